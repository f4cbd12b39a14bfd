// Kills the program at random moments, repeatedly on the same folder: each pot of the gallery is complete or
// absent, and an interrupted visit can be resumed. A few kills in ./check; ONGGI_KILLS=200 for the long run.
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include "game/app/system/start_log.h"
#include "tests/stress/interrupted_wheel.h"
#include "tests/stress/whole.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;

int kills() {
    const char* wanted = std::getenv("ONGGI_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 8;
}

// One run: from the start to the kill, a given time after a given number of output bytes (a busy machine is
// slow). Returns its output.
std::string live_and_die(const fs::path& gallery, unsigned seed, std::size_t after_words, int after_ms) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return {};
    const std::string folder = gallery.string();
    const std::string number = std::to_string(seed);
    const std::string wheel = test::in_build("tests/interrupted_wheel");
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
        ::execl(wheel.c_str(), "interrupted_wheel", folder.c_str(), number.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    std::string all;
    std::array<char, 256> bytes{};
    const auto patience_ms = static_cast<int>(test::scaled(std::chrono::minutes(1)).count());
    for (pollfd said{.fd = ends[0], .events = POLLIN, .revents = 0};
         all.size() < after_words && ::poll(&said, 1, patience_ms) == 1;) {
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

TEST(AKilledWheel, LeavesEveryPotWholeAndTheVisitToBePickedUp) {
    const test::TemporaryFolder folder;
    const fs::path gallery = folder / "gallery";
    std::mt19937 chance(20261122);
    std::set<std::string> seen;
    int while_throwing = 0;
    int threw_on = 0;  // long enough to be in the journal
    int threw_on_picked_up = 0;
    int while_saving = 0;
    int picked_up = 0;
    int resumed = 0;
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(stress::kRateHz);
    // The moments of the kills depend on the machine's speed: a run goes on until a visit was resumed, and a
    // long one until the rare cases have occurred.
    constexpr int kEnoughThrewOn = 10;
    const bool is_long = kills() >= 100;
    const auto lacks_moments = [&](int kill) {
        if (picked_up == 0) return kill < 5 * kills();
        return is_long && threw_on <= kEnoughThrewOn && kill < 2 * kills();
    };
    int kill = 0;
    for (; kill < kills() || lacks_moments(kill); ++kill) {
        const auto late_ms = static_cast<int>(chance() % 600);
        const auto moments = 1 + chance() % 5;
        const std::string said = live_and_die(gallery, static_cast<unsigned>(chance()), moments, late_ms);
        ASSERT_FALSE(said.empty()) << "it was never at work";
        while_throwing += said.back() == stress::kThrows || said.back() == stress::kResumed ? 1 : 0;
        threw_on += said.back() == stress::kThrewOn ? 1 : 0;
        while_saving += said.back() == stress::kSaves ? 1 : 0;
        resumed += static_cast<int>(std::count(said.begin(), said.end(), stress::kResumed));

        stress::expect_whole_pots(gallery, seen);
        const stress::Found found =
            stress::expect_whole_visit(gallery, folder / "copy", stress::start(), parameters);
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
        kill, while_throwing, threw_on, while_saving, seen.size(), picked_up, threw_on_picked_up, resumed);
    EXPECT_GT(picked_up, 0) << "nothing was proved";
    if (is_long) {
        EXPECT_GT(seen.size(), 20U);
        EXPECT_GT(while_saving, 3);
        EXPECT_GT(resumed, 0);
        EXPECT_GT(threw_on, kEnoughThrewOn);
        EXPECT_GE(threw_on_picked_up, threw_on * 9 / 10) << "a keeper may be late, but not often";
    }
}

}  // namespace
}  // namespace onggi
