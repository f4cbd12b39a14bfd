#include "engine/sound/headphones.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/list_folder.h"

namespace onggi::sound {
namespace {

constexpr std::int64_t kLooksEveryNs = 3'000'000'000;

using Switches = std::array<unsigned char, SW_MAX / 8 + 1>;

bool has_headphones(const Switches& switches) {
    return (unsigned{switches[SW_HEADPHONE_INSERT / 8]} >> (SW_HEADPHONE_INSERT % 8U) & 1U) != 0;
}

}  // namespace

Headphones::~Headphones() {
    for (const Jack& jack : jacks_)
        ::close(jack.file);
}

void Headphones::look_for_more() {
    std::set<std::string> before = std::exchange(others_, {});
    for (const std::filesystem::path& entry : list_folder(folder_).entries) {
        const std::string name = entry.filename().string();
        if (auto known = before.extract(name)) {
            others_.insert(std::move(known));
            continue;
        }
        if (!name.starts_with("event") ||
            std::any_of(jacks_.begin(), jacks_.end(), [&](const Jack& jack) { return jack.name == name; }))
            continue;
        const int file = ::open(entry.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (file < 0) continue;
        Switches can{};
        const bool is_jack =
            ::ioctl(file, EVIOCGBIT(EV_SW, can.size()), can.data()) >= 0 && has_headphones(can);
        if (is_jack) {
            jacks_.push_back({name, file});
        } else {
            ::close(file);
            others_.insert(name);
        }
    }
}

bool Headphones::are_in(std::int64_t now_ns) {
    if (now_ns >= looks_ns_) {
        looks_ns_ = now_ns + kLooksEveryNs;
        look_for_more();
    }
    bool are_in = false;
    std::erase_if(jacks_, [&](const Jack& jack) {
        Switches on{};
        if (::ioctl(jack.file, EVIOCGSW(on.size()), on.data()) < 0) {  // pulled out with its card
            ::close(jack.file);
            return true;
        }
        are_in = are_in || has_headphones(on);
        return false;
    });
    return are_in;
}

}  // namespace onggi::sound
