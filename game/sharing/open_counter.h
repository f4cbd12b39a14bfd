// Anonymous counts of phone requests: pages opened and files taken. The server writes one letter an event
// into a pipe that it cannot read; the kiosk reads the pipe now and then. Any one thread but the haptic one;
// never blocks.
#pragma once

#include <filesystem>
#include <map>

#include "engine/core/result.h"

namespace onggi::sharing {

enum class ShareEvent : char { kPageOpened = 'o', kModelTaken = 'm', kPrintTaken = 'p', kFilmTaken = 'f' };

// The kiosk's end: a named pipe, created if missing (the owner may read and write, the group may write).
class CounterReader {
  public:
    // Bad input: the folder is missing, or the path is not a pipe. System lacks: the pipe cannot be created
    // or opened.
    [[nodiscard]] static Result<CounterReader> open(const std::filesystem::path& pipe);
    CounterReader(CounterReader&& other) noexcept;
    CounterReader& operator=(CounterReader&& other) noexcept;
    CounterReader(const CounterReader&) = delete;
    CounterReader& operator=(const CounterReader&) = delete;
    ~CounterReader();

    // The events since the last call, up to 64 kB at once. Unknown letters are ignored.
    [[nodiscard]] std::map<ShareEvent, int> take();

  private:
    explicit CounterReader(int descriptor) : descriptor_(descriptor) {}
    int descriptor_ = -1;
};

// The server's end. Without a reader, or with a full pipe, an event is dropped without waiting.
class CounterWriter {
  public:
    explicit CounterWriter(std::filesystem::path pipe) : pipe_(std::move(pipe)) {}  // empty: counts nothing
    CounterWriter(const CounterWriter&) = delete;
    CounterWriter& operator=(const CounterWriter&) = delete;
    ~CounterWriter();

    void count(ShareEvent event) noexcept;

  private:
    std::filesystem::path pipe_;
    int descriptor_ = -1;
};

}  // namespace onggi::sharing
