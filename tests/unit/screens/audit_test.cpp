// The audit of every screen, in every language, shape and size of text, and in every way it can be set up:
// nothing too small to read or to touch, nothing clipped, nothing laid over another, nothing on a pot, and
// words that stand out from what is behind them. A layout is in u, the same for 720 lines and for 4K, and is
// judged without a brush; what words stand on is judged on a small painting.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "game/screens/screens.h"
#include "tests/unit/screens/audit_checks.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

struct Case {
    int width_px;
    int height_px;
    const char* language;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
    const Case& one = info.param;
    return fmt::format("{}_{}x{}", one.language, one.width_px, one.height_px);
}

class Audit : public testing::TestWithParam<Case> {
  protected:
    ui::Painter painter_;
};

TEST_P(Audit, FindsNothingInAnyLayout) {
    const Case& one = GetParam();
    PaintingStore store(painter_, PaintingStore::Paints::kNothing);
    for (int text_size = 1; text_size <= kiosk::kMostTextSize; ++text_size) {
        for (const SampleView& sample :
             sample_views({one.width_px, one.height_px, one.language, text_size})) {
            SCOPED_TRACE(fmt::format("{}, text {}", sample.name, text_size));
            audit_layout(sample, compose(*sample.view, painter_, store));
        }
    }
}

TEST_P(Audit, FindsNoWordsThatSinkIntoWhatIsBehindThem) {
    const Case& one = GetParam();
    PaintingStore store(painter_);
    // A quarter of the size each way, and the same layout.
    for (const int text_size : {1, 3}) {
        for (const SampleView& sample :
             sample_views({one.width_px / 4, one.height_px / 4, one.language, text_size})) {
            SCOPED_TRACE(fmt::format("{}, text {}", sample.name, text_size));
            const Composition composition = compose(*sample.view, painter_, store);
            audit_contrast(sample, composition);
            audit_room(sample, composition);
        }
    }
}

// Unoptimised, one audit takes a minute: there the code runs once, and the optimised builds judge the rest.
#ifdef NDEBUG
INSTANTIATE_TEST_SUITE_P(Screens, Audit,
                         testing::Values(Case{1280, 720, "en"}, Case{1280, 720, "ko"}, Case{1280, 720, "ar"},
                                         Case{720, 1280, "en"}, Case{720, 1280, "ko"}, Case{720, 1280, "ar"},
                                         Case{1024, 768, "en"}, Case{1024, 768, "ko"}, Case{1024, 768, "ar"}),
                         name_of);
#else
INSTANTIATE_TEST_SUITE_P(Screens, Audit, testing::Values(Case{1280, 720, "ar"}), name_of);
#endif

}  // namespace
}  // namespace onggi::screens
