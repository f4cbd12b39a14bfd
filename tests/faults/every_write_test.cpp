// At every call by which the kiosk changes the disk, the disk fails, or the program is killed, or the power
// is cut: afterwards the kiosk starts, shows nothing partial, and has lost nothing older. ONGGI_EVERY_FAULT=1
// runs all combinations, some minutes; ./check gives each call one kind of fault, which varies between the
// actions.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "tests/faults/museum.h"
#include "tests/faults/write_faults.h"
#include "tests/support/temporary_folder.h"

namespace onggi::faults {
namespace {

namespace fs = std::filesystem;

// The child's report before its end, in shared memory.
struct Told {
    long calls = 0;
    bool is_done = false;
    std::array<char, 512> failed_call{};
};

struct Ended {
    Told told;
    bool was_killed = false;
    int status = 0;
};

class EveryWrite : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        base_ = new test::TemporaryFolder;
        lay_out(base_->path() / "museum");
        void* const memory =
            ::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        ASSERT_NE(memory, MAP_FAILED);
        told_ = new (memory) Told;
    }
    static void TearDownTestSuite() {
        ::munmap(told_, sizeof(Told));
        delete base_;
    }
    // The same museum again and again.
    fs::path fresh() {
        fs::remove_all(folder_ / "museum");
        fs::copy(base_->path() / "museum", folder_ / "museum", fs::copy_options::recursive);
        return folder_ / "museum";
    }
    static Ended act(const Deed& deed, const fs::path& museum, Kind kind, long at) {
        *told_ = {};
        const pid_t child = ::fork();
        if (child == 0) {
            arm(museum, kind, at);
            told_->is_done = deed.act(museum);
            disarm();
            told_->calls = calls();
            std::strncpy(told_->failed_call.data(), failed_call().c_str(), told_->failed_call.size() - 1);
            ::_exit(0);
        }
        Ended ended;
        ::waitpid(child, &ended.status, 0);
        ended.was_killed = WIFSIGNALED(ended.status) && WTERMSIG(ended.status) == SIGKILL;
        ended.told = *told_;
        return ended;
    }

    test::TemporaryFolder folder_;
    static inline test::TemporaryFolder* base_ = nullptr;
    static inline Told* told_ = nullptr;
};

constexpr std::array kKinds{Kind::kKilled,   Kind::kTorn, Kind::kPowerCut,
                            Kind::kFullOnce, Kind::kFull, Kind::kBroken};

TEST_F(EveryWrite, MayFailOrBeTheLastWithoutLoss) {
    const bool all = std::getenv("ONGGI_EVERY_FAULT") != nullptr;
    std::size_t turn = 0;
    for (const Deed& deed : deeds()) {
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
                EXPECT_EQ(ended.was_killed, is_end) << where;
                EXPECT_TRUE(ended.was_killed || (WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0))
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
    for (const Deed& deed : deeds()) {
        const fs::path museum = fresh();
        const Ended ended = act(deed, museum, Kind::kReadOnly, 1);
        EXPECT_TRUE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0) << deed.name;
        EXPECT_FALSE(ended.told.is_done) << deed.name << ": expected it to say that nothing was kept";
        expect_sound(museum, deed, false);
    }
}

}  // namespace
}  // namespace onggi::faults
