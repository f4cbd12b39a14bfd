// Needs the fonts of the kiosk: fonts-nanum and fonts-noto-core.
#include "engine/ui/painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace onggi::ui {
namespace {

TextStyle style(float size = 26.0F) {
    return {
        .family = "NanumSquareRound, Noto Sans Arabic, Noto Sans", .size = size, .line_height = 1.25F * size};
}

// The part of a painting in which anything was drawn.
Rect drawn_part(const Painting& painting) {
    int left = painting.width;
    int right = -1;
    int top = painting.height;
    int bottom = -1;
    for (int y = 0; y < painting.height; ++y) {
        for (int x = 0; x < painting.width; ++x) {
            if (painting.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(painting.width) +
                               static_cast<std::size_t>(x)) *
                                  4 +
                              3] < 64) {
                continue;
            }
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    return {static_cast<float>(left), static_cast<float>(top), static_cast<float>(right - left + 1),
            static_cast<float>(bottom - top + 1)};
}

Painting written(Painter& painter, const Text& text, float box_width) {
    Sketch sketch{.size = {box_width, 60.0F}};
    sketch.add(Writing{.at = {0.0F, 10.0F}, .text = text, .box_width = box_width});
    return painter.paint(sketch);
}

TEST(Painter, HasTheFontsItIsAskedFor) {
    const Painter painter;
    const std::array<std::string, 3> families{"NanumSquareRound", "Noto Naskh Arabic", "No Such Family"};
    EXPECT_EQ(painter.missing_families(families), std::vector<std::string>{"No Such Family"})
        << "install fonts-nanum and fonts-noto-core";
}

TEST(Painter, KnowsEveryLetterOfThreeScripts) {
    Painter painter;
    for (const char* words :
         {"Press in, low down", "아래쪽을 눌러 보세요", "اضغط من الأسفل", "12th⁠–⁠13th c. × 5"}) {
        const TextSize size = painter.measure({.words = words, .style = style()});
        EXPECT_EQ(size.unknown_glyphs, 0) << words;
        EXPECT_GT(size.width, 40.0F) << words;
        EXPECT_EQ(size.lines, 1) << words;
    }
}

TEST(Painter, SaysWhichLettersNoFontHas) {
    Painter painter;
    EXPECT_EQ(painter.measure({.words = "\xf4\x8f\xbf\xbd", .style = style()}).unknown_glyphs,
              1);  // U+10FFFD
}

TEST(Painter, BreaksLinesBetweenWordsAlsoInKorean) {
    Painter painter;
    const Text text{.words = "손을 대면 시작해요", .style = style(50.0F), .width = 220.0F};
    const TextSize size = painter.measure(text);
    EXPECT_EQ(size.lines, 2);
    EXPECT_FALSE(size.too_wide);
    EXPECT_EQ(size.height, 2 * 62.5F);
    EXPECT_TRUE(
        painter.measure({.words = "시작해요시작해요", .style = style(50.0F), .width = 150.0F}).too_wide);
}

TEST(Painter, StartsALineOnTheSideItsLanguageDoes) {
    Painter painter;
    const float width = 400.0F;
    EXPECT_LT(drawn_part(written(painter, {.words = "Water", .style = style()}, width)).x, 10.0F);
    Text arabic{.words = "الماء", .style = style()};
    arabic.style.right_to_left = true;
    EXPECT_GT(drawn_part(written(painter, arabic, width)).right(), 390.0F);
    arabic.style.align = Align::kEnd;
    EXPECT_LT(drawn_part(written(painter, arabic, width)).x, 10.0F);
    arabic.style.align = Align::kCentre;
    EXPECT_NEAR(drawn_part(written(painter, arabic, width)).centre().x, 200.0F, 4.0F);
}

TEST(Painter, DrawsAsWideAsItMeasures) {
    Painter painter;
    const Text text{.words = "Done", .style = style(40.0F)};
    EXPECT_NEAR(drawn_part(written(painter, text, 400.0F)).width, painter.measure(text).width, 6.0F);
}

TEST(Painter, KeepsAllWordsOfALineInABoxThatIsAHairTooNarrow) {
    Painter painter;
    for (const char* words : {"as high as one pull goes", "한 번에 이만큼까지 올라가요", "لا أعلى من هذا"}) {
        const Text text{.words = words, .style = style()};
        for (const float px_per_u : {0.5F, 0.667F, 1.0F, 1.5F}) {
            const auto drawn = [&](float box_width) {
                Sketch sketch{.size = {500.0F, 60.0F}, .px_per_u = px_per_u};
                sketch.add(Writing{.at = {20.0F, 10.0F}, .text = text, .box_width = box_width});
                return drawn_part(painter.paint(sketch)).width;
            };
            EXPECT_EQ(drawn(painter.measure(text).width - 1.0F), drawn(0.0F)) << words << ' ' << px_per_u;
        }
    }
}

TEST(Painter, PaintsBoxesWhereTheyAre) {
    Painter painter;
    Sketch sketch{.size = {40.0F, 30.0F}, .px_per_u = 2.0F};
    sketch.add(Box{.rect = {10.0F, 5.0F, 20.0F, 10.0F}, .fill = Fill::flat(hex(0xff8000))});
    const Painting painting = painter.paint(sketch);
    EXPECT_EQ(painting.width, 80);
    EXPECT_EQ(drawn_part(painting), (Rect{20.0F, 10.0F, 40.0F, 20.0F}));
    const std::uint8_t* const middle = painting.rgba.data() + (20 * 80 + 40) * 4;
    EXPECT_EQ(middle[0], 255);
    EXPECT_EQ(middle[1], 128);
    EXPECT_EQ(middle[2], 0);
}

TEST(Painter, SpreadsAShadowAndFadesASketch) {
    Painter painter;
    Sketch sketch{.size = {60.0F, 60.0F}};
    sketch.add(Shadow{.rect = {20.0F, 20.0F, 20.0F, 20.0F}, .blur = 12.0F, .colour = hex(0x000000)});
    const auto alpha = [](const Painting& painting, int x, int y) {
        return painting.rgba[static_cast<std::size_t>(y * painting.width + x) * 4 + 3];
    };
    const Painting soft = painter.paint(sketch);
    EXPECT_GT(alpha(soft, 30, 30), alpha(soft, 20, 30));
    EXPECT_GT(alpha(soft, 20, 30), alpha(soft, 14, 30));
    EXPECT_EQ(alpha(soft, 4, 30), 0);
    sketch.fade = Sketch::Fade{.whole = {0.0F, 0.0F}, .gone = {60.0F, 0.0F}};
    const Painting faded = painter.paint(sketch);
    EXPECT_NEAR(alpha(faded, 30, 30), alpha(soft, 30, 30) / 2, 6);
}

TEST(Painter, PaintsTheSameSketchTheSame) {
    Painter one;
    Painter other;
    Sketch sketch{.size = {200.0F, 60.0F}, .px_per_u = 1.5F};
    sketch.add(Writing{.text = {.words = "같은 축척 نفس", .style = style()}});
    EXPECT_EQ(one.paint(sketch).rgba, other.paint(sketch).rgba);
    const std::uint64_t hash = sketch.hash();
    std::get<Writing>(sketch.items[0]).text.style.colour = hex(0xffffff);
    EXPECT_NE(sketch.hash(), hash);
}

}  // namespace
}  // namespace onggi::ui
