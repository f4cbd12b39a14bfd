// The codes for phones, in the pixels of the screen. zbarimg cannot guard their margin
// (findings/zbarimg-reads-a-code-in-a-quarter-of-its-quiet-zone.sh).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "game/screens/page/legibility.h"
#include "game/visit/steps.h"
#include "tests/unit/screens/flatten.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

// A panel, and how wide a code it must show at least.
struct CodePanel {
    int width_px;
    int height_px;
    double diagonal_inch;
    double least_code_mm;
};

class APicture {
  public:
    explicit APicture(asset::Image image) : image_(std::move(image)) {}
    [[nodiscard]] bool is_dark(int x, int y) const {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return true;
        const auto at = static_cast<std::size_t>((y * image_.width + x) * asset::kBytesPerPixel);
        return image_.rgba[at + 1] < 190;
    }
    // Whether any pixel is dark between two squares of pixels with the same middle.
    [[nodiscard]] bool has_dark_around(int left, int top, int side, int margin) const {
        for (int y = top - margin; y < top + side + margin; ++y) {
            for (int x = left - margin; x < left + side + margin; ++x) {
                const bool inside = x >= left && x < left + side && y >= top && y < top + side;
                if (!inside && is_dark(x, y)) return true;
            }
        }
        return false;
    }

  private:
    asset::Image image_;
};

void expect_a_code(const CodePanel& panel, const SampleView& sample, ui::Painter& painter,
                   PaintingStore& store) {
    SCOPED_TRACE(fmt::format("{} {}x{} of {} inches", sample.name, panel.width_px, panel.height_px,
                             panel.diagonal_inch));
    constexpr int kModules = 29;      // of the sample's code
    constexpr int kQuietModules = 4;  // ISO/IEC 18004
    View view = *sample.view;
    view.px_per_mm = px_per_mm(panel.width_px, panel.height_px, panel.diagonal_inch);
    const Composition screen = visit::compose(view, painter, store);
    const APicture picture(flatten(screen, ui::hex(0x8f7c64), true));
    int codes = 0;
    for (const Item& item : screen.items) {
        const auto px = [&](float u) { return static_cast<int>(std::lround(u * screen.px_per_u)); };
        const int side = px(item.rect.width);
        if (!item.painting || item.is_words || side != px(item.rect.height) || side % kModules != 0) continue;
        ++codes;
        EXPECT_GE(side / view.px_per_mm, panel.least_code_mm);
        const int left = px(item.rect.x);
        const int top = px(item.rect.y);
        const int module = side / kModules;
        EXPECT_TRUE(picture.has_dark_around(left + module, top + module, side - 2 * module, module))
            << "expected modules at the code's edges";
        EXPECT_FALSE(picture.has_dark_around(left, top, side, kQuietModules * module));
    }
    EXPECT_EQ(codes, 1);
    for (const Writing& text : screen.writings) {
        EXPECT_FALSE(text.too_wide) << text.words;
        EXPECT_LE(text.rect.bottom(), screen.bounds.bottom()) << text.words;
    }
}

TEST(PhoneCodes, HaveAQuietZoneOfFourModules) {
    ui::Painter painter;
    PaintingStore store(painter);
    for (const CodePanel& panel : {CodePanel{1280, 720, 24.0, 60.0}, CodePanel{720, 1280, 24.0, 60.0},
                                   CodePanel{1280, 720, 15.6, 45.0}, CodePanel{1280, 1024, 19.0, 55.0}}) {
        for (const char* language : {"ko", "ar"}) {
            for (const SampleView& sample : sample_views({panel.width_px, panel.height_px, language, 1})) {
                if (sample.name == "home-ready" || sample.name == "home-wifi")
                    expect_a_code(panel, sample, painter, store);
            }
        }
    }
}

}  // namespace
}  // namespace onggi::screens
