// The audit of every screen, in every language, shape and size of text, and in every way it can be set up:
// nothing too small to read or to touch, nothing clipped, nothing overlapping, nothing on a pot, and enough
// contrast. A layout is in u, the same for 720 lines and for 4K, and is checked without painting; contrast is
// checked on a small painting.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "game/visit/steps.h"
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
    std::string name = fmt::format("{}_{}x{}", one.language, one.width_px, one.height_px);
    std::erase(name, '-');
    return name;
}

// One painter for all tests, because finding its fonts takes as long as checking a layout. And one store: the
// same pots are on the screens of every language.
class Audit : public testing::TestWithParam<Case> {
  protected:
    static void SetUpTestSuite() {
        painter_ = std::make_unique<ui::Painter>();
        store_ = std::make_unique<PaintingStore>(*painter_, PaintingStore::Paints::kAllForGood);
    }
    static void TearDownTestSuite() {
        store_.reset();
        painter_.reset();
    }
    inline static std::unique_ptr<ui::Painter> painter_;
    inline static std::unique_ptr<PaintingStore> store_;
};

// Every way in which a visitor may have set the screens up.
std::vector<SampleRequest> ways_of(const Case& one, int text_size) {
    std::vector<SampleRequest> ways;
    for (const int way : {0, 1, 2, 3, 4, 5, 6, 7}) {
        ways.push_back({.width_px = one.width_px,
                        .height_px = one.height_px,
                        .language = one.language,
                        .text_size = text_size,
                        .reach = (way & 1) != 0,
                        .left_hand = (way & 2) != 0,
                        .scans = (way & 4) != 0,
                        .staff = way == 0});
    }
    return ways;
}

std::string words_for(const SampleRequest& way) {
    return fmt::format("text {}{}{}{}", way.text_size, way.reach ? ", reach" : "",
                       way.left_hand ? ", left hand" : "", way.scans ? ", ring" : "");
}

// With the ring on target n modulo the number of targets.
SampleView with_ring(const SampleView& sample, std::size_t n, std::size_t targets) {
    View view = *sample.view;
    view.focus = targets == 0 ? -1 : static_cast<int>(n % targets);
    return {sample.name, std::make_shared<const View>(std::move(view))};
}

void expect_nothing_in_any_layout(const Case& one, ui::Painter& painter) {
    PaintingStore store(painter, PaintingStore::Paints::kNothing);
    std::size_t ring = 0;
    for (int text_size = 1; text_size <= kiosk::kMostTextSize; ++text_size) {
        for (const SampleRequest& way : ways_of(one, text_size)) {
            for (const SampleView& sample : sample_views(way)) {
                SCOPED_TRACE(fmt::format("{}, {}", sample.name, words_for(way)));
                Composition screen = visit::compose(*sample.view, painter, store);
                audit_layout(sample, screen);
                if (!way.scans) continue;
                const SampleView ringed = with_ring(sample, ++ring, screen.targets.size());
                audit_layout(ringed, visit::compose(*ringed.view, painter, store));
            }
        }
    }
}

TEST_P(Audit, FindsNoFaultInAnyLayout) {
    expect_nothing_in_any_layout(GetParam(), *painter_);
}

// Panel shapes between and beyond the three designed ones, landscape and portrait.
class OtherShapes : public Audit {};
TEST_P(OtherShapes, FindNoFaultInAnyLayout) {
    expect_nothing_in_any_layout(GetParam(), *painter_);
}

// With larger text, texts without room keep their size, but none is smaller, and on the whole they are
// clearly larger.
TEST_P(Audit, FindsNoSmallerWordsWithLargerText) {
    const Case& one = GetParam();
    PaintingStore store(*painter_, PaintingStore::Paints::kNothing);
    for (const bool reach : {false, true}) {
        std::map<std::string, float> first;
        std::map<std::string, float> before;
        for (int text_size = 1; text_size <= kiosk::kMostTextSize; ++text_size) {
            double grown = 0.0;
            int count = 0;
            for (const SampleView& sample : sample_views({.width_px = one.width_px,
                                            .height_px = one.height_px,
                                            .language = one.language,
                                            .text_size = text_size,
                                            .reach = reach,
                                            .staff = false})) {
                std::map<std::string, int> again;
                for (const Writing& text : visit::compose(*sample.view, *painter_, store).writings) {
                    const std::string key =
                        fmt::format("{} {} {}", sample.name, text.words, again[text.words]++);
                    const auto smaller = before.find(key);
                    if (smaller != before.end()) {
                        EXPECT_GE(text.size, smaller->second - 0.01F) << key << ", text " << text_size;
                    }
                    before[key] = text.size;
                    const float size = first.emplace(key, text.size).first->second;
                    if (sample.view->state.screen == kiosk::Screen::kAttract) continue;
                    grown += double{text.size} / double{size};
                    ++count;
                }
            }
            constexpr std::array kLeastGrown{0.99, 1.12, 1.16};  // of the whole screens' words
            EXPECT_GT(grown / count, kLeastGrown[static_cast<std::size_t>(text_size - 1)])
                << "text " << text_size;
        }
    }
}

TEST_P(Audit, FindsNoWordsWithoutContrastOrRoom) {
    const Case& one = GetParam();
    // A quarter of the size each way, and the same layout. The staff's panel keeps its size of text.
    const auto audit = [&](SampleRequest request) {
        request.width_px = one.width_px / 4;
        request.height_px = one.height_px / 4;
        request.language = one.language;
        std::size_t ring = 0;
        for (const SampleView& sample : sample_views(request)) {
            SCOPED_TRACE(fmt::format("{}, {}", sample.name, words_for(request)));
            const SampleView ringed = request.scans ? with_ring(sample, ++ring, 12) : sample;
            const Composition composition = visit::compose(*ringed.view, *painter_, *store_);
            audit_contrast(ringed, composition);
            audit_room(ringed, composition);
        }
    };
    for (const int text_size : {1, 2, 3})
        audit({.text_size = text_size, .staff = text_size == 1});
    audit({.text_size = 3, .reach = true, .left_hand = true, .scans = true, .staff = false});
}

// Unoptimised, one audit takes a minute: debug builds run it once, and the optimised builds do the rest.
#ifdef NDEBUG
INSTANTIATE_TEST_SUITE_P(Screens, Audit,
                         testing::Values(Case{1280, 720, "en"}, Case{1280, 720, "ko"}, Case{1280, 720, "ar"},
                                         Case{720, 1280, "en"}, Case{720, 1280, "ko"}, Case{720, 1280, "ar"},
                                         Case{1024, 768, "en"}, Case{1024, 768, "ko"}, Case{1024, 768, "ar"}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Screens, OtherShapes,
                         testing::Values(Case{1280, 800, "en"}, Case{800, 1280, "ko"}, Case{768, 1024, "ar"},
                                         Case{1280, 1024, "en"}, Case{1024, 1280, "ko"},
                                         Case{1080, 1080, "en"}, Case{2560, 1080, "ar"},
                                         Case{1080, 2560, "en"}),
                         name_of);
// Cases of each of these in the shape; the newer languages, which have no other cases.
std::vector<Case> in_newer_languages(int width_px, int height_px) {
    std::vector<Case> cases;
    for (const char* language : {"ja", "zh-Hans", "de", "fr", "es"})
        cases.push_back({width_px, height_px, language});
    return cases;
}

INSTANTIATE_TEST_SUITE_P(WideScreens, Audit, testing::ValuesIn(in_newer_languages(1280, 720)), name_of);
INSTANTIATE_TEST_SUITE_P(TallScreens, OtherShapes, testing::ValuesIn(in_newer_languages(720, 1280)), name_of);
INSTANTIATE_TEST_SUITE_P(SquareScreens, OtherShapes, testing::ValuesIn(in_newer_languages(1024, 768)),
                         name_of);
#else
INSTANTIATE_TEST_SUITE_P(Screens, Audit, testing::Values(Case{1280, 720, "ar"}), name_of);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(OtherShapes);
#endif

}  // namespace
}  // namespace onggi::screens
