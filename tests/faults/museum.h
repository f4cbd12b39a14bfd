// A kiosk's folder with every kind of file, the kiosk's actions on it, and the checks that must pass after
// any fault of the disk.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "game/kiosk/config.h"

namespace onggi::faults {

constexpr const char* kYesterday = "2026-11-24";
constexpr const char* kToday = "2026-11-25";

// An action of the kiosk, from its first call to its last. Returns whether it succeeded.
struct Deed {
    const char* name;
    std::function<bool(const std::filesystem::path&)> act;
};
[[nodiscard]] std::vector<Deed> deeds();
// Those that the staff does while the kiosk stands still.
[[nodiscard]] std::vector<Deed> deeds_of_staff();
// Those that the kiosk's own threads do: the keeper and the phones'.
[[nodiscard]] std::vector<Deed> deeds_of_threads();

[[nodiscard]] kiosk::Config config_of(const std::filesystem::path& museum);

// Two pots, one of them shared and on the wall; visits that were counted; what the staff has set; a visit
// that was interrupted; the first bowl of a jar; a heartbeat; and the archive of another
// gallery, with one pot, its page and its visit.
void lay_out(const std::filesystem::path& museum);

// Checks that the kiosk starts there, finds everything that lay_out() made except what the action removes,
// shows nothing partial, and works. `said_done`: the action reported success, so its result must be there.
void expect_sound(const std::filesystem::path& museum, const Deed& deed, bool said_done);

}  // namespace onggi::faults
