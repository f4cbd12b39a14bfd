#include "engine/haptics/stop_key.h"

#include <dirent.h>
#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

namespace onggi::haptics {
namespace {

constexpr std::array<std::uint16_t, 2> kStopKeys{KEY_PAUSE, KEY_STOP};
// A key press ends the wait at once. After it the thread looks whether it shall end.
constexpr int kWaitMs = 100;
constexpr std::size_t kMostKeyboards = 16;

bool has_a_stop_key(int file) {
    std::array<unsigned char, KEY_MAX / 8 + 1> keys{};
    if (::ioctl(file, EVIOCGBIT(EV_KEY, keys.size()), keys.data()) < 0) return false;
    return std::any_of(kStopKeys.begin(), kStopKeys.end(),
                       [&](std::uint16_t key) { return (unsigned{keys[key / 8U]} >> (key % 8U) & 1U) != 0; });
}

}  // namespace

std::vector<StopKeyboard> open_stop_keys(const std::vector<std::string>& known, const std::string& folder) {
    std::vector<StopKeyboard> found;
    DIR* entries = ::opendir(folder.c_str());
    if (entries == nullptr) return found;
    while (const dirent* entry = ::readdir(entries)) {
        const std::string_view name = entry->d_name;
        if (!name.starts_with("event") || known.size() + found.size() >= kMostKeyboards ||
            std::find(known.begin(), known.end(), name) != known.end())
            continue;
        const int file = ::open((folder + "/" + entry->d_name).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (file < 0) continue;
        if (has_a_stop_key(file)) {
            found.push_back({std::string(name), file});
        } else {
            ::close(file);
        }
    }
    ::closedir(entries);
    return found;
}

StopKey::StopKey(Find find, std::function<void()> pressed)
    : find_(std::move(find)),
      keyboards_(find_({})),
      pressed_(std::move(pressed)) {}

StopKey::~StopKey() {
    for (const StopKeyboard& keyboard : keyboards_)
        ::close(keyboard.file);
}

void StopKey::look_for_more(std::int64_t now_ns) noexcept {
    if (looked_ns_ == 0) looked_ns_ = now_ns;
    if (now_ns - looked_ns_ < kLooksEveryNs) return;
    looked_ns_ = now_ns;
    std::vector<std::string> known;
    for (const StopKeyboard& keyboard : keyboards_)
        known.push_back(keyboard.name);
    for (StopKeyboard& keyboard : find_(known))
        keyboards_.push_back(std::move(keyboard));
}

std::int64_t StopKey::round(std::int64_t now_ns) noexcept {
    look_for_more(now_ns);
    std::array<pollfd, kMostKeyboards> waits{};
    const std::size_t count = std::min(keyboards_.size(), waits.size());
    for (std::size_t k = 0; k < count; ++k)
        waits[k] = {.fd = keyboards_[k].file, .events = POLLIN, .revents = 0};
    // Without keyboards this only sleeps.
    if (::poll(waits.data(), count, kWaitMs) <= 0) return 0;
    for (std::size_t k = 0; k < count; ++k)
        if (waits[k].revents != 0) drain(keyboards_[k]);
    std::erase_if(keyboards_, [](const StopKeyboard& keyboard) { return keyboard.file < 0; });
    return 0;
}

void StopKey::drain(StopKeyboard& keyboard) noexcept {
    std::array<input_event, 16> events{};
    const ssize_t size = ::read(keyboard.file, events.data(), sizeof(events));
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {  // pulled out
        ::close(std::exchange(keyboard.file, -1));
        return;
    }
    constexpr std::int32_t kPressed = 1;  // 0 is released, 2 repeated
    const std::size_t count = static_cast<std::size_t>(size) / sizeof(input_event);
    const bool is_pressed = std::any_of(
        events.begin(), events.begin() + static_cast<std::ptrdiff_t>(count), [](const input_event& event) {
            return event.type == EV_KEY && event.value == kPressed &&
                   std::find(kStopKeys.begin(), kStopKeys.end(), event.code) != kStopKeys.end();
        });
    if (is_pressed) pressed_();
}

}  // namespace onggi::haptics
