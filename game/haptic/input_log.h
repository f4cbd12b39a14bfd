// The tool of every tick since a lump was fresh, in next to no memory: all but the newest block is kept as
// bytes in which what repeats from tick to tick takes next to nothing, and those are put aside on the disk
// where there is a folder for them. What comes out is what was put in, to the bit. One thread that is not the
// haptic one; allocates, blocks.
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

// A tick's tool, its places apart from the rest, which seldom changes.
struct LoggedInput {
    dvec3 position_mm{0.0};
    dvec3 second_position_mm{0.0};
    std::uint32_t settings = 0;  // index of all else
    std::uint32_t force_check = 0;
};

class InputLog {
  public:
    static constexpr std::size_t kBlock = 4096;  // inputs

    // Empty: all of it stays in memory.
    explicit InputLog(std::filesystem::path folder = {}) : aside_(std::move(folder)) {}

    void push_back(const LoggedInput& input);
    // Takes away what is behind the first so many. Precondition: no more than there are. After an error, what
    // the disk gave back of what should have stayed is all there is.
    Result<void> shrink(std::size_t count);
    void clear();

    [[nodiscard]] std::size_t size() const { return packed_.size() * kBlock + newest_.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    // Precondition: not empty.
    [[nodiscard]] const LoggedInput& back() const { return last_; }
    // In memory. For a display and for tests.
    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] std::uint64_t bytes_on_disk() const { return aside_.bytes_on_disk(); }

    // Reads one after the other, a block at a time. Good until the log changes.
    class Reader {
      public:
        Reader(const InputLog& log, std::size_t first) : log_(log), next_(first) {}
        // Good until the next call. Precondition: there is one more. Errors: those of SpillFile::get().
        [[nodiscard]] Result<const LoggedInput*> next();

      private:
        const InputLog& log_;
        std::size_t next_;
        std::size_t block_ = static_cast<std::size_t>(-1);  // that is unpacked
        std::vector<LoggedInput> inputs_;
    };

  private:
    using Packed = std::vector<std::byte>;
    [[nodiscard]] static Packed packed(const std::vector<LoggedInput>& inputs);
    [[nodiscard]] static std::vector<LoggedInput> unpacked(const Packed& bytes);
    [[nodiscard]] Result<std::vector<LoggedInput>> block(std::size_t which) const;

    files::SpillFile aside_;
    std::vector<files::SpillFile::Piece> packed_;  // of kBlock inputs each
    std::vector<LoggedInput> newest_;
    LoggedInput last_;
};

}  // namespace onggi::haptic
