// A kiosk's folder with something of everything in it, what a kiosk does to it, and what has to be right of
// it whatever happened to the disk meanwhile.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "game/kiosk/config.h"

namespace onggi::faults {

constexpr const char* kYesterday = "2026-11-24";
constexpr const char* kToday = "2026-11-25";

// A deed of the kiosk, from its first call to its last. True: it says that it was done.
struct Deed {
    const char* name;
    std::function<bool(const std::filesystem::path&)> act;
};
[[nodiscard]] std::vector<Deed> deeds();

[[nodiscard]] kiosk::Config config_of(const std::filesystem::path& museum);

// Two pots, one of them shared and on the wall; visits that were counted; what the staff has set; a visit
// that was interrupted; a heartbeat.
void lay_out(const std::filesystem::path& museum);

// The kiosk starts there, finds all that lay_out() left but what the deed was to take away, shows nothing
// half, and works. `said_done`: the deed said so, and what it did is there.
void expect_sound(const std::filesystem::path& museum, const Deed& deed, bool said_done);

}  // namespace onggi::faults
