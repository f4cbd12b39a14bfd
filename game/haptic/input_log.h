// The tool of every tick since a lump was fresh, in little memory: all but the newest block is kept as bytes
// in which what repeats from tick to tick takes next to nothing. What comes out is what was put in, to the
// bit. One thread that is not the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/math.h"

namespace onggi::haptic {

// A tick's tool, its places apart from the rest, which seldom changes.
struct LoggedInput {
    dvec3 position_mm{0.0};
    std::uint32_t second = 0;    // index of the second hand's place
    std::uint32_t settings = 0;  // index of all else
    std::uint32_t force_check = 0;
};

class InputLog {
  public:
    static constexpr std::size_t kBlock = 4096;  // inputs

    void push_back(const LoggedInput& input);
    // Takes away what is behind the first so many. Precondition: no more than there are.
    void shrink(std::size_t count);
    void clear() { shrink(0); }

    [[nodiscard]] std::size_t size() const { return packed_.size() * kBlock + newest_.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    // Precondition: not empty.
    [[nodiscard]] LoggedInput back() const {
        return newest_.empty() ? unpacked(packed_.back()).back() : newest_.back();
    }
    // For a display and for tests.
    [[nodiscard]] std::size_t bytes() const;

    // Reads one after the other, a block at a time. Good until the log changes.
    class Reader {
      public:
        Reader(const InputLog& log, std::size_t first) : log_(log), next_(first) {}
        // Precondition: there is one more.
        [[nodiscard]] LoggedInput next();

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

    std::vector<Packed> packed_;  // of kBlock inputs each
    std::vector<LoggedInput> newest_;
};

}  // namespace onggi::haptic
