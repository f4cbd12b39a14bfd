// Counts the program's recent crashes, so that a program that keeps crashing starts in safe mode, with a
// simple picture. One small file, written atomically. Main thread.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::app {

// Times are seconds of the machine's clock since 1970, which may jump.
struct StartLog {
    bool is_running = false;  // a start without an end: still running, or crashed
    std::vector<std::int64_t> falls_s;

    friend bool operator==(const StartLog&, const StartLog&) = default;
};

// The report for the staff, which also decides on safe mode.
struct StartReport {
    bool is_safe_mode = false;
    int falls = 0;  // recent ones
};

constexpr int kFallsToSafeMode = 3;
constexpr std::int64_t kFallsCountForS = 600;

// Records a start at that time: counts a crash of the previous run, and drops old crashes. Pure.
[[nodiscard]] StartReport begin(StartLog& log, std::int64_t now_s);
// Records an intended end. Pure.
inline void end(StartLog& log) {
    log.is_running = false;
}

// Writes and parses the file's text. Bad input: the line, what was expected, what was found.
[[nodiscard]] std::string text_of(const StartLog& log);
[[nodiscard]] Result<StartLog> read_start_log(std::string_view text, const std::string& file);

// Reads the log in FOLDER/starts for another program. Errors: the file's, and as above.
[[nodiscard]] Result<StartLog> read_start_log_of(const std::filesystem::path& folder);
// The number of recent crashes at that time. Pure.
[[nodiscard]] int falls_lately(StartLog log, std::int64_t now_s);

// The log in FOLDER/starts, from one start to its end.
class StartKeeper {
  public:
    explicit StartKeeper(const std::filesystem::path& folder);

    // Appends a line to `remarks` if the file is damaged or cannot be written; the start then counts as the
    // first.
    StartReport begin_now(std::vector<std::string>& remarks);
    Result<void> end_now();
    // Ends a start that failed. If the system lacks something that may appear later, such as a display or a
    // driver, it does not count as a crash. Returns `error`.
    Error end_without(Error error);

  private:
    Result<void> write();

    std::filesystem::path file_;
    StartLog log_;
};

// Ensures that a gallery has only one kiosk: a lock on FOLDER/lock, which the kernel releases when the
// process ends for any reason. Children do not inherit it. Main thread.
class GalleryLock {
  public:
    GalleryLock() = default;
    GalleryLock(const GalleryLock&) = delete;
    GalleryLock& operator=(const GalleryLock&) = delete;
    ~GalleryLock();

    // System lacks: another process has the lock. Succeeds without a lock if the file cannot be opened or the
    // file system has no locks.
    Result<void> take(const std::filesystem::path& folder);
    // The other process that has the lock. Precondition: this process does not have it; the query would
    // release it.
    [[nodiscard]] static std::optional<pid_t> other_at(const std::filesystem::path& folder);

  private:
    int descriptor_ = -1;
};

}  // namespace onggi::app
