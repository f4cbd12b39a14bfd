// A gallery of ten thousand pots opens as fast as one of ten, and operations on all pots grow no faster than
// their number. The best of several rounds counts, because a busy machine can only make one slower.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>

#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 15;
constexpr int kPotsADay = 100;

// Processor time of this thread: on a busy machine a long round never runs without an interruption, a short
// one may.
double processor_s() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double best_s(const std::function<void()>& work) {
    double best = 1e9;
    for (int round = 0; round < kRounds; ++round) {
        const double begun_s = processor_s();
        work();
        best = std::min(best, processor_s() - begun_s);
    }
    return best;
}

class AGallery {
  public:
    explicit AGallery(int pots) {
        config_.gallery.folder = folder_.path().string();
        for (int pot = 0; pot < pots; ++pot) {
            const int month = pot / kPotsADay;
            const fs::path place = folder_.path() /
                                   fmt::format("{}-{:02}-01", 2020 + month / 12, 1 + month % 12) /
                                   fmt::format("pot-{:03}", 1 + pot % kPotsADay);
            fs::create_directories(place);
            test::put_file(place / "pot.png", "x");
        }
    }
    [[nodiscard]] double opens_s() const {
        return best_s([&] { EXPECT_GT(Gallery(config_).free_mb(), 0.0); });
    }
    [[nodiscard]] double clears_s() const {
        return best_s([&] { Gallery(config_).clear_parts(); });
    }
    [[nodiscard]] double lists_s(std::size_t expected) const {
        return best_s([&] { EXPECT_EQ(kept_pots(folder_.path()).size(), expected); });
    }

  private:
    test::TemporaryFolder folder_;
    kiosk::Config config_;
};

TEST(Gallery, OfTenThousandPotsOpensAsFastAsOneOfTen) {
    const AGallery small(10);
    const AGallery middle(1000);
    const AGallery large(10'000);
    const double opens_s = large.opens_s();
    const double clears_s = large.clears_s();
    const double lists_s = large.lists_s(10'000);
    const double opens = opens_s / small.opens_s();
    const double clears = clears_s / middle.clears_s();
    const double lists = lists_s / middle.lists_s(1000);
    std::printf(
        "10000 pots: open in %.1f us, %.2f times as long as 10; are cleared up in %.2f ms, %.1f times "
        "as long as 1000; are listed in %.2f ms, %.1f times as long\n",
        1e6 * opens_s, opens, 1e3 * clears_s, clears, 1e3 * lists_s, lists);
    EXPECT_LT(opens, 2.0);
    EXPECT_LT(clears, 20.0);
    EXPECT_LT(lists, 20.0);
}

}  // namespace
}  // namespace onggi::app
