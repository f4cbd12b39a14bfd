// The tool of every tick since a lump was fresh, in little memory: all blocks but the newest are compressed
// by prediction from tick to tick, and spilled to disk if there is a folder for them. Reads return the exact
// inputs. One thread, but not the haptic one; allocates, blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/files/spill_file.h"
#include "engine/math/math.h"

namespace onggi::haptic {

// A tick's tool: positions, and an index for the rest, which seldom changes.
struct LoggedInput {
    dvec3 position_mm{0.0};
    dvec3 second_position_mm{0.0};
    std::uint32_t settings = 0;  // index of the tool's other fields
    std::uint32_t force_check = 0;
};

class InputLog {
  public:
    static constexpr std::size_t kBlock = 4096;  // inputs

    // Empty folder: the log stays in memory.
    explicit InputLog(std::filesystem::path folder = {}) : aside_(std::move(folder)) {}

    void push_back(const LoggedInput& input);
    // Keeps the first `count` inputs. Precondition: count <= size(). After an error, only the inputs that the
    // disk returned are left.
    Result<void> shrink(std::size_t count);
    void clear();

    [[nodiscard]] std::size_t size() const { return packed_.size() * kBlock + newest_.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    // Precondition: not empty.
    [[nodiscard]] const LoggedInput& back() const { return last_; }
    // Bytes in memory. For a display and for tests.
    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] std::uint64_t bytes_on_disk() const { return aside_.bytes_on_disk(); }

    // Reads the inputs in order, a block at a time. Valid until the log changes.
    class Reader {
      public:
        Reader(const InputLog& log, std::size_t first) : log_(log), next_(first) {}
        // The result is valid until the next call. Precondition: there is another input. Errors: those of
        // SpillFile::get().
        [[nodiscard]] Result<const LoggedInput*> next();

      private:
        const InputLog& log_;
        std::size_t next_;
        std::size_t block_ = static_cast<std::size_t>(-1);  // the block that is unpacked
        std::vector<LoggedInput> inputs_;
    };

  private:
    using Packed = std::vector<std::byte>;
    [[nodiscard]] static Packed packed(const std::vector<LoggedInput>& inputs);
    [[nodiscard]] static std::vector<LoggedInput> unpacked(const Packed& bytes);
    [[nodiscard]] Result<std::vector<LoggedInput>> block(std::size_t which) const;

    files::SpillFile aside_;
    std::vector<files::SpillFile::Piece> packed_;  // kBlock inputs each
    std::vector<LoggedInput> newest_;
    LoggedInput last_;
};

}  // namespace onggi::haptic
