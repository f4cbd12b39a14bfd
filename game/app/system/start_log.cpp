#include "game/app/system/start_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "engine/core/number_in.h"
#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/system/wall_clock.h"

namespace onggi::app {
namespace {

constexpr std::string_view kFirstLine = "onggi starts 1";
constexpr std::size_t kMostLogBytes = 4096;
constexpr std::size_t kMostFalls = 20;  // more have no effect

constexpr const char* kFile = "starts";
constexpr const char* kLockFile = "lock";

void forget_old_falls(std::vector<std::int64_t>& falls_s, std::int64_t now_s) {
    // If the clock was put back, recorded crashes lie in the future: they count as of now.
    for (std::int64_t& fall_s : falls_s)
        fall_s = std::min(fall_s, now_s);
    std::erase_if(falls_s, [&](std::int64_t fall_s) { return now_s - fall_s >= kFallsCountForS; });
}

}  // namespace

StartReport begin(StartLog& log, std::int64_t now_s) {
    if (log.is_running) log.falls_s.push_back(now_s);
    forget_old_falls(log.falls_s, now_s);
    if (log.falls_s.size() > kMostFalls)
        log.falls_s.erase(log.falls_s.begin(), log.falls_s.end() - static_cast<std::ptrdiff_t>(kMostFalls));
    log.is_running = true;
    const int falls = static_cast<int>(log.falls_s.size());
    return {.is_safe_mode = falls >= kFallsToSafeMode, .falls = falls};
}

std::string text_of(const StartLog& log) {
    std::string text = fmt::format("{}\n{}\n", kFirstLine, log.is_running ? "running" : "ended");
    for (const std::int64_t fall_s : log.falls_s)
        text += fmt::format("fell {}\n", fall_s);
    return text;
}

Result<StartLog> read_start_log(std::string_view text, const std::string& file) {
    StartLog log;
    const auto wrong = [&](int line, std::string_view expected, std::string_view found) {
        return bad_input(
            fmt::format("{}, line {}: expected {}, found {}", file, line, expected, in_quotes(found)));
    };
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (number == 1) {
            if (line != kFirstLine) return wrong(number, in_quotes(kFirstLine), line);
        } else if (number == 2) {
            if (line != "running" && line != "ended") return wrong(number, "'running' or 'ended'", line);
            log.is_running = line == "running";
        } else {
            constexpr std::string_view kFell = "fell ";
            const auto fall_s =
                number_in<std::int64_t>(line.substr(line.starts_with(kFell) ? kFell.size() : line.size()));
            if (!fall_s) return wrong(number, "'fell' and a time", line);
            log.falls_s.push_back(*fall_s);
        }
    }
    if (number < 2) return wrong(number + 1, "'running' or 'ended'", "");
    return log;
}

Result<StartLog> read_start_log_of(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kFile;
    const auto text = files::read_file(file, kMostLogBytes);
    return text ? read_start_log(*text, file.string()) : Result<StartLog>(text.error());
}

int falls_lately(StartLog log, std::int64_t now_s) {
    forget_old_falls(log.falls_s, now_s);
    return static_cast<int>(log.falls_s.size());
}

StartKeeper::StartKeeper(const std::filesystem::path& folder) : file_(folder / kFile) {}

Result<void> StartKeeper::write() {
    std::error_code error;
    std::filesystem::create_directories(file_.parent_path(), error);
    return files::write_file_atomically(file_, text_of(log_));
}

StartReport StartKeeper::begin_now(std::vector<std::string>& remarks) {
    std::error_code error;
    if (std::filesystem::exists(file_, error)) {
        auto log = read_start_log_of(file_.parent_path());
        if (log) {
            log_ = std::move(*log);
        } else {
            remarks.push_back(log.error().message + "; earlier crashes are forgotten");
        }
    }
    const StartReport report = begin(log_, wall_clock_s());
    if (const auto written = write(); !written) remarks.push_back(written.error().message);
    if (report.is_safe_mode) {
        remarks.push_back(fmt::format(
            "safe mode: the program crashed {} times within {} minutes; no devices, a plain picture",
            report.falls, kFallsCountForS / 60));
    } else if (report.falls > 0) {
        remarks.push_back(fmt::format("restarted after a crash, number {} within {} minutes", report.falls,
                                      kFallsCountForS / 60));
    }
    return report;
}

Result<void> StartKeeper::end_now() {
    end(log_);
    return write();
}

Error StartKeeper::end_without(Error error) {
    if (error.kind == ErrorKind::kSystemLacks) static_cast<void>(end_now());
    return error;
}

Result<void> GalleryLock::take(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    constexpr mode_t kMode = 0666;  // minus the umask
    descriptor_ = ::open((folder / kLockFile).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
    if (descriptor_ < 0) return {};  // without a writable folder there is nothing to protect
    struct flock whole {};
    whole.l_type = F_WRLCK;
    if (::fcntl(descriptor_, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN)) return {};
    return system_lacks(fmt::format("{}: expected no other kiosk at this gallery, found process {}",
                                    shown_path(folder.parent_path().native()), other_at(folder).value_or(0)));
}

GalleryLock::~GalleryLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<pid_t> GalleryLock::other_at(const std::filesystem::path& folder) {
    const int descriptor = ::open((folder / kLockFile).c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) return std::nullopt;
    struct flock whole {};
    whole.l_type = F_WRLCK;
    const bool is_known = ::fcntl(descriptor, F_GETLK, &whole) == 0;
    ::close(descriptor);
    if (!is_known || whole.l_type == F_UNLCK) return std::nullopt;
    return whole.l_pid;
}

}  // namespace onggi::app
