// At every call by which the kiosk changes the disk, the disk fails, or the program is killed, or the power
// is cut: afterwards the kiosk starts, shows nothing partial, and has lost nothing older. ONGGI_EVERY_FAULT=1
// runs all combinations, some minutes; ./check gives each call one kind of fault, which varies between the
// actions.
#include <signal.h>  // NOLINT: SIGKILL is POSIX

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "tests/faults/forked_deed.h"
#include "tests/faults/write_faults.h"

namespace onggi::faults {
namespace {

namespace fs = std::filesystem;

class EveryWrite : public ForkedDeed {
  protected:
    static Ended act(const Deed& deed, const fs::path& museum, Kind kind, long at) {
        return in_a_fork([&](Told& told) {
            arm(museum, kind, at);
            told.is_done = deed.act(museum);
            disarm();
            told.calls = calls();
            std::strncpy(told.failed_call.data(), failed_call().c_str(), told.failed_call.size() - 1);
        });
    }
    static bool was_killed(const Ended& ended) {
        return WIFSIGNALED(ended.status) && WTERMSIG(ended.status) == SIGKILL;
    }
};

constexpr std::array kKinds{Kind::kKilled,   Kind::kTorn, Kind::kPowerCut,
                            Kind::kFullOnce, Kind::kFull, Kind::kBroken};

std::vector<Deed> all_deeds() {
    std::vector<Deed> all = deeds();
    for (Deed& deed : deeds_of_staff())
        all.push_back(std::move(deed));
    return all;
}

TEST_F(EveryWrite, MayFailOrBeTheLastWithoutLoss) {
    const bool all = std::getenv("ONGGI_EVERY_FAULT") != nullptr;
    std::size_t turn = 0;
    for (const Deed& deed : all_deeds()) {
        const Ended whole = act(deed, fresh(), Kind::kNone, 0);
        ASSERT_TRUE(WIFEXITED(whole.status) && whole.told.is_done) << deed.name;
        ASSERT_GT(whole.told.calls, 0) << deed.name;
        expect_sound(folder_ / "museum", deed, true);
        std::map<Kind, int> runs;
        int borne = 0;
        for (long at = 1; at <= whole.told.calls; ++at) {
            for (const Kind kind : kKinds) {
                if (!all && kind != kKinds[turn++ % kKinds.size()]) continue;
                const fs::path museum = fresh();
                const Ended ended = act(deed, museum, kind, at);
                const std::string where = std::string(deed.name) + ", " + name_of(kind) + " at call " +
                                          std::to_string(at) + " of " + std::to_string(whole.told.calls) +
                                          ": " + ended.told.failed_call.data();
                const bool is_end = kind == Kind::kKilled || kind == Kind::kTorn || kind == Kind::kPowerCut;
                EXPECT_EQ(was_killed(ended), is_end) << where;
                EXPECT_TRUE(was_killed(ended) || (WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0))
                    << where << ": the program ended with " << ended.status;
                borne += ended.told.is_done ? 1 : 0;
                ++runs[kind];
                expect_sound(museum, deed, ended.told.is_done);
                if (HasFailure()) FAIL() << where;
            }
            if (!all) ++turn;  // so that the next call meets another
        }
        std::string words;
        for (const auto& [kind, number] : runs)
            words += std::string(words.empty() ? "" : ", ") + std::to_string(number) + " " + name_of(kind);
        std::printf("%s: %ld calls change the disk; %s; done all the same %d times\n", deed.name,
                    whole.told.calls, words.c_str(), borne);
    }
}

TEST_F(EveryWrite, MayBeRefusedByADiskThatIsReadOnly) {
    for (const Deed& deed : all_deeds()) {
        const fs::path museum = fresh();
        const Ended ended = act(deed, museum, Kind::kReadOnly, 1);
        EXPECT_TRUE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0) << deed.name;
        EXPECT_FALSE(ended.told.is_done) << deed.name << ": expected it to say that nothing was kept";
        expect_sound(museum, deed, false);
    }
}

}  // namespace
}  // namespace onggi::faults
