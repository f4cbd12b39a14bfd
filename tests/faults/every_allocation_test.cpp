// Lets each allocation of a kiosk's action fail, alone or with all after it. The action must succeed, fail
// with an error, or end the program with one line and exit code 3; it must not crash. Afterwards the checks
// of every_write_test.cpp hold, and a kept pot has the same bytes as without the failure. ONGGI_EVERY_FAULT=1
// tries every allocation both ways; without it the first sixty of each action are tried, and two dozen more,
// evenly spread.
#include <fcntl.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include "game/app/system/crash_report.h"
#include "tests/faults/allocation_faults.h"
#include "tests/faults/forked_deed.h"

namespace onggi::faults {
namespace {

namespace fs = std::filesystem;

// Every allocation up to kFirst, then kMostRuns more of an action. The actions of threads paint pictures,
// which takes longer.
constexpr long kFirst = 60;
constexpr long kMostRuns = 24;
constexpr long kMostRunsOfThreads = 12;

// Content by path, and a folder's path alone.
using Files = std::map<std::string, std::string>;

Files files_in(const fs::path& folder) {
    Files found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        found[fs::relative(entry.path(), folder)] =
            entry.is_regular_file() ? test::content_of(entry.path()) : "";
    return found;
}

// The part below `folder`; empty if there is none.
Files below(const fs::path& folder, const Files& files) {
    const std::string prefix = folder.string() + "/";
    Files found;
    for (auto at = files.lower_bound(prefix); at != files.end() && at->first.starts_with(prefix); ++at)
        found.insert(*at);
    return found;
}

class EveryAllocation : public ForkedDeed, public testing::WithParamInterface<Deed> {
  protected:
    EveryAllocation() : said_(::open((folder_ / "said").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
    ~EveryAllocation() override { ::close(said_); }
    Ended act(const fs::path& museum, Shortage shortage, long at) {
        EXPECT_EQ(::ftruncate(said_, 0), 0);
        ::lseek(said_, 0, SEEK_SET);
        return in_a_fork([&](Told& told) {
            ::dup2(said_, STDERR_FILENO);
            app::report_crashes();
            run_short(shortage, at);
            // Like a thread of the kiosk: an exception ends the program.
            const auto beside = [&]() noexcept { return GetParam().act(museum); };
            told.is_done = beside();
            end_shortage();
            told.calls = allocations();
        });
    }
    void expect_told(const Ended& ended) {
        ASSERT_TRUE(WIFEXITED(ended.status)) << "signal " << WTERMSIG(ended.status) << said();
        if (WEXITSTATUS(ended.status) == 0) return;
        EXPECT_EQ(WEXITSTATUS(ended.status), 3) << said();
        // A library may say a line of its own before it, such as its failed assertion.
        EXPECT_TRUE(std::regex_match(
            said(), std::regex("(.*\n)?onggi: expected memory for the thread [a-z_]+, found none left\n")))
            << said();
    }
    // All files after the action. Each distinct result is checked once an action.
    void expect_sound_museum(const fs::path& museum, bool said_done) {
        Files now = files_in(museum);
        for (const auto& [place, content] : now) {
            const fs::path path = place;
            if (!path.filename().string().starts_with("pot-")) continue;
            const Files& expected = laid_out_.contains(place) ? laid_out_ : whole_;
            if (!expected.contains(place)) continue;  // a part that the next start removes
            EXPECT_TRUE(below(path, now) == below(path, expected)) << path << " is damaged or kept in part";
        }
        is_as_laid_out_ = now == laid_out_;
        if (!seen_.emplace(said_done, std::move(now)).second) return;
        ++checked_;
        is_as_laid_out_ = false;  // the checks write
        expect_sound(museum, GetParam(), said_done);
    }
    fs::path museum() { return std::exchange(is_as_laid_out_, false) ? folder_ / "museum" : fresh(); }
    static bool is_of_threads() {
        const std::string_view suite =
            testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
        return suite.starts_with("OfItsThreads");
    }
    [[nodiscard]] std::string said() const { return test::content_of(folder_ / "said"); }

    int said_;  // what the child says
    Files laid_out_;
    Files whole_;  // after the action without a shortage
    std::set<std::pair<bool, Files>> seen_;
    int checked_ = 0;
    bool is_as_laid_out_ = false;
};

TEST_P(EveryAllocation, MayFailAndNothingIsLost) {
    const bool all = std::getenv("ONGGI_EVERY_FAULT") != nullptr;
    const Deed& deed = GetParam();
    const Ended whole = act(fresh(), Shortage::kNone, 0);
    ASSERT_TRUE(WIFEXITED(whole.status) && whole.told.is_done) << said();
    laid_out_ = files_in(laid_out());
    whole_ = files_in(folder_ / "museum");
    expect_sound(folder_ / "museum", deed, true);
    const long first = is_of_threads() ? 0 : kFirst;
    const long most = is_of_threads() ? kMostRunsOfThreads : kMostRuns;
    // Odd, so that every second place of a pattern in the allocations is met too.
    const long stride = (whole.told.calls - first) / most | 1;
    long turn = 0;
    int runs = 0;
    int done = 0;
    int ended_early = 0;
    for (long at = 1; at <= whole.told.calls; at += all || at <= first ? 1 : stride) {
        ++turn;
        const bool tries_once = all || at <= first || turn % 2 == 0;
        const bool tries_for_good = all || (at <= first ? turn % 4 == 0 : turn % 2 == 1);
        for (const Shortage shortage : {Shortage::kOnce, Shortage::kForGood}) {
            if (!(shortage == Shortage::kOnce ? tries_once : tries_for_good)) continue;
            const fs::path there = museum();
            const Ended ended = act(there, shortage, at);
            expect_told(ended);
            ++runs;
            done += ended.told.is_done ? 1 : 0;
            ended_early += ended.status != 0 ? 1 : 0;
            expect_sound_museum(there, ended.told.is_done);
            if (HasFailure())
                FAIL() << "short " << name_of(shortage) << " at allocation " << at << " of "
                       << whole.told.calls << ": " << said();
        }
    }
    std::printf(
        "%s: %ld allocations, %d runs; done all the same %d times, ended in one line %d times; %d museums "
        "checked\n",
        deed.name, whole.told.calls, runs, done, ended_early, checked_);
}

std::string name_of_deed(const testing::TestParamInfo<Deed>& deed) {
    std::string name = deed.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(OfTheKiosk, EveryAllocation, testing::ValuesIn(deeds()), &name_of_deed);
INSTANTIATE_TEST_SUITE_P(OfItsThreads, EveryAllocation, testing::ValuesIn(deeds_of_threads()), &name_of_deed);

}  // namespace
}  // namespace onggi::faults
