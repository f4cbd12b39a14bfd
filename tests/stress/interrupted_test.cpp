// Killed at random moments, again and again on the same folder: each pot of the gallery is whole or is not
// there, and the visit that was interrupted can be picked up. A few kills in ./check; ONGGI_KILLS=200 for the
// long run.
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include "engine/record/session.h"
#include "game/app/left_over.h"
#include "game/app/start_log.h"
#include "tests/stress/interrupted_wheel.h"
#include "tests/support/temporary_folder.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;

int kills() {
    const char* wanted = std::getenv("ONGGI_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 8;
}

// One life: from its start to the kill, so many ms after it had said so much; a busy machine takes its time.
// What it said.
std::string live_and_die(const fs::path& gallery, unsigned seed, std::size_t after_words, int after_ms) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return {};
    const std::string folder = gallery.string();
    const std::string number = std::to_string(seed);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
        ::execl(ONGGI_INTERRUPTED_WHEEL, "interrupted_wheel", folder.c_str(), number.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    std::string all;
    std::array<char, 256> bytes{};
    for (pollfd said{.fd = ends[0], .events = POLLIN, .revents = 0};
         all.size() < after_words && ::poll(&said, 1, 60'000) == 1;) {
        const ssize_t size = ::read(ends[0], bytes.data(), bytes.size());
        if (size <= 0) break;
        all.append(bytes.data(), static_cast<std::size_t>(size));
    }
    ::poll(nullptr, 0, after_ms);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended by itself, with " << status;
    for (ssize_t size = 0; (size = ::read(ends[0], bytes.data(), bytes.size())) > 0;)
        all.append(bytes.data(), static_cast<std::size_t>(size));
    ::close(ends[0]);
    return all;
}

void expect_whole_pot(const fs::path& pot) {
    for (const char* name : {"pot.onggi", "pot.glb", "pot.stl", "pot.png"})
        ASSERT_TRUE(fs::exists(pot / name)) << pot / name;
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

struct Found {
    bool is_any = false;
    std::uint64_t ticks = 0;
};

// What the next life will find. On a copy: it is the next life's to take.
Found expect_whole_visit(const fs::path& gallery, const fs::path& copy) {
    Found found;
    fs::remove_all(copy);
    if (!fs::exists(gallery / "state")) return found;
    fs::copy(gallery / "state", copy);
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(stress::kRateHz);
    std::vector<std::string> remarks;
    const auto pot = app::LeftOver::find(copy, stress::start(), parameters, remarks);
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

TEST(AKilledWheel, LeavesEveryPotWholeAndTheVisitToBePickedUp) {
    const test::TemporaryFolder folder;
    const fs::path gallery = folder / "gallery";
    std::mt19937 chance(20261122);
    std::set<std::string> seen;
    int while_throwing = 0;
    int threw_on = 0;  // long enough for the journal to know of it
    int threw_on_picked_up = 0;
    int while_saving = 0;
    int picked_up = 0;
    int resumed = 0;
    for (int kill = 0; kill < kills(); ++kill) {
        const std::string said = live_and_die(gallery, static_cast<unsigned>(chance()), 1 + chance() % 5,
                                              static_cast<int>(chance() % 600));
        ASSERT_FALSE(said.empty()) << "it was never at work";
        while_throwing += said.back() == stress::kThrows || said.back() == stress::kResumed ? 1 : 0;
        threw_on += said.back() == stress::kThrewOn ? 1 : 0;
        while_saving += said.back() == stress::kSaves ? 1 : 0;
        resumed += static_cast<int>(std::count(said.begin(), said.end(), stress::kResumed));

        for (const auto& day : fs::directory_iterator(gallery)) {
            if (!day.is_directory()) continue;
            for (const auto& pot : fs::directory_iterator(day.path())) {
                const std::string name = pot.path().filename().string();
                // What is beside is taken away at the next start.
                if (!name.starts_with("pot-") || pot.path().extension() == ".part") continue;
                expect_whole_pot(pot.path());
                seen.insert((day.path() / name).string());
            }
        }
        const Found found = expect_whole_visit(gallery, folder / "copy");
        picked_up += found.is_any ? 1 : 0;
        threw_on_picked_up += found.is_any && said.back() == stress::kThrewOn ? 1 : 0;
        const auto log = app::read_start_log(test::content_of(gallery / "state/starts"), "starts");
        ASSERT_TRUE(log) << log.error().message;
        EXPECT_TRUE(log->is_running);
        if (HasFailure()) {
            FAIL() << "after kill " << kill + 1 << ", which had said '" << said << "'";
        }
    }
    std::printf(
        "%d kills, %d while throwing, %d after throwing for long, %d while saving; %zu pots whole, %d visits "
        "picked up, %d of those that threw for long, %d resumed\n",
        kills(), while_throwing, threw_on, while_saving, seen.size(), picked_up, threw_on_picked_up, resumed);
    EXPECT_GT(picked_up, 0) << "nothing was proved";
    if (kills() >= 100) {
        EXPECT_GT(seen.size(), 20U);
        EXPECT_GT(while_saving, 3);
        EXPECT_GT(resumed, 0);
        EXPECT_GT(threw_on, 10);
        EXPECT_GE(threw_on_picked_up, threw_on * 9 / 10) << "a keeper may be late, but not often";
    }
}

}  // namespace
}  // namespace onggi
