// What is counted of phones: that a page was opened, that a file was taken, and nothing of whom. The server
// writes a letter an event into a pipe of which it can read nothing; the kiosk reads it now and then. Any one
// thread but the haptic one; never blocks.
#pragma once

#include <filesystem>
#include <map>

#include "engine/core/result.h"

namespace onggi::sharing {

enum class ShareEvent : char { kPageOpened = 'o', kModelTaken = 'm', kPrintTaken = 'p', kFilmTaken = 'f' };

// The kiosk's end: a named pipe, made where there is none (for the owner to read and write, for the group to
// write).
class CounterReader {
  public:
    // Bad input: no folder there, or something that is no pipe. System lacks: it may not be made or opened.
    [[nodiscard]] static Result<CounterReader> open(const std::filesystem::path& pipe);
    CounterReader(CounterReader&& other) noexcept;
    CounterReader& operator=(CounterReader&& other) noexcept;
    CounterReader(const CounterReader&) = delete;
    CounterReader& operator=(const CounterReader&) = delete;
    ~CounterReader();

    // What has happened since it was last asked; 64 kB at most at once. Letters that mean nothing are passed
    // over.
    [[nodiscard]] std::map<ShareEvent, int> take();

  private:
    explicit CounterReader(int descriptor) : descriptor_(descriptor) {}
    int descriptor_ = -1;
};

// The server's end. Where nobody reads, or the pipe is full, an event is not counted, and nobody waits.
class CounterWriter {
  public:
    explicit CounterWriter(std::filesystem::path pipe) : pipe_(std::move(pipe)) {}  // empty: nothing is
    CounterWriter(const CounterWriter&) = delete;
    CounterWriter& operator=(const CounterWriter&) = delete;
    ~CounterWriter();

    void count(ShareEvent event) noexcept;

  private:
    std::filesystem::path pipe_;
    int descriptor_ = -1;
};

}  // namespace onggi::sharing
