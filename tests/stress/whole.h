// Checks of the disk after a kiosk was killed at any moment.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/record/session.h"
#include "tests/support/temporary_folder.h"

namespace onggi::stress {

inline void expect_whole_pot(const std::filesystem::path& pot) {
    for (const char* name : {"pot.onggi", "pot.glb", "pot.stl", "pot.3mf", "pot.png"})
        ASSERT_TRUE(std::filesystem::exists(pot / name)) << pot / name;
    const auto session = record::parse_session(test::content_of(pot / "pot.onggi"), pot.string());
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_TRUE(session->is_complete()) << pot;
    const std::string glb = test::content_of(pot / "pot.glb");
    ASSERT_EQ(glb.substr(0, 4), "glTF") << pot;
    std::uint32_t size = 0;
    std::memcpy(&size, glb.data() + 8, sizeof size);
    EXPECT_EQ(size, glb.size()) << pot;
    const std::string stl = test::content_of(pot / "pot.stl");
    ASSERT_GT(stl.size(), 84U) << pot;
    std::memcpy(&size, stl.data() + 80, sizeof size);
    EXPECT_EQ(84U + 50U * std::size_t{size}, stl.size()) << pot;
    const std::string png = test::content_of(pot / "pot.png");
    ASSERT_GT(png.size(), 12U) << pot;
    EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND") << pot;
}

// Checks all pots of the gallery, and adds them to `seen`.
inline void expect_whole_pots(const std::filesystem::path& gallery, std::set<std::string>& seen) {
    for (const auto& day : std::filesystem::directory_iterator(gallery)) {
        if (!day.is_directory()) continue;
        for (const auto& pot : std::filesystem::directory_iterator(day.path())) {
            const std::string name = pot.path().filename().string();
            // The next start removes incomplete pots.
            if (!name.starts_with("pot-") || pot.path().extension() == ".part") continue;
            expect_whole_pot(pot.path());
            seen.insert((day.path() / name).string());
        }
    }
}

struct Found {
    bool is_any = false;
    std::uint64_t ticks = 0;
};

// Returns the visit that the next start will find. Works on a copy, because reading consumes it.
inline Found expect_whole_visit(const std::filesystem::path& gallery, const std::filesystem::path& copy,
                                const haptic::HapticState& start,
                                const haptic::HapticParameters& parameters) {
    Found found;
    std::filesystem::remove_all(copy);
    if (!std::filesystem::exists(gallery / "state")) return found;
    std::filesystem::copy(gallery / "state", copy);
    std::vector<std::string> remarks;
    const auto pot = app::InterruptedSession::find(copy, start, parameters, remarks);
    for (const std::string& line : remarks)
        ADD_FAILURE() << line;
    if (!pot) return found;
    for (;;) {
        const auto more = pot->work(10'000);
        EXPECT_TRUE(more) << more.error().message;
        if (!more || !*more) break;
    }
    found.is_any = pot->is_worth_it();
    found.ticks = pot->history().ticks();
    return found;
}

}  // namespace onggi::stress
