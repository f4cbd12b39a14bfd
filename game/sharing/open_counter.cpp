#include "game/sharing/open_counter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "engine/core/quote.h"

namespace onggi::sharing {

Result<CounterReader> CounterReader::open(const std::filesystem::path& pipe) {
    const auto refused = [&](int error_number, const char* what) {
        return system_lacks(fmt::format("{}: expected {}, found {}", shown_path(pipe.native()), what,
                                        std::generic_category().message(error_number)));
    };
    constexpr mode_t kOwnerReadsGroupWrites = 0620;
    if (::mkfifo(pipe.c_str(), kOwnerReadsGroupWrites) != 0 && errno != EEXIST)
        return refused(errno, "to make a pipe");
    // Opened for writing too: the pipe then has no end of file when the server stops, and open() does not
    // block.
    const int descriptor = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) return refused(errno, "to open a pipe");
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISFIFO(status.st_mode)) {
        ::close(descriptor);
        return bad_input(fmt::format("{}: expected a pipe, found something else", shown_path(pipe.native())));
    }
    return CounterReader(descriptor);
}

CounterReader::CounterReader(CounterReader&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

CounterReader& CounterReader::operator=(CounterReader&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

CounterReader::~CounterReader() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::map<ShareEvent, int> CounterReader::take() {
    std::map<ShareEvent, int> counts;
    std::array<char, 4096> letters{};
    constexpr int kMostRounds = 16;  // a pipe's capacity: bounds the time under a flood of events
    for (int round = 0; round < kMostRounds; ++round) {
        const ssize_t got = ::read(descriptor_, letters.data(), letters.size());
        if (got <= 0) break;
        for (ssize_t i = 0; i < got; ++i) {
            const auto event = static_cast<ShareEvent>(letters[static_cast<std::size_t>(i)]);
            switch (event) {
                case ShareEvent::kPageOpened:
                case ShareEvent::kModelTaken:
                case ShareEvent::kPrintTaken:
                case ShareEvent::kFilmTaken:
                    ++counts[event];
            }
        }
    }
    return counts;
}

CounterWriter::~CounterWriter() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void CounterWriter::count(ShareEvent event) noexcept {
    if (pipe_.empty()) return;
    // Without a reader, the next event tries again.
    if (descriptor_ < 0) descriptor_ = ::open(pipe_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor_ < 0) return;
    const char letter = static_cast<char>(event);
    if (::write(descriptor_, &letter, 1) == 1 || errno == EAGAIN || errno == EINTR) return;
    ::close(descriptor_);  // the reader closed the pipe
    descriptor_ = -1;
}

}  // namespace onggi::sharing
