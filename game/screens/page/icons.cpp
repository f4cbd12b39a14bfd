#include "game/screens/page/icons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "game/screens/page/design.h"

namespace onggi::screens {
namespace {

struct Stroke {
    std::string_view path;
    std::optional<ui::Colour> fill{};
    float width = 3.6F;
    std::optional<ui::Colour> own{};  // replaces the icon's colour
};

constexpr ui::Colour kMetal = ui::hex(0xc9bfae);
constexpr ui::Colour kIron = ui::hex(0x7a3c1f);
constexpr ui::Colour kCobalt = ui::hex(0x2f4c8c);
constexpr ui::Colour kDarkClay = ui::hex(0x8a7058);
constexpr ui::Colour kCeladon = ui::hex(0x7f9c80);
constexpr ui::Colour kSkin = ui::hex(0xe6cfae);
constexpr ui::Colour kSpongeFill = ui::hex(0xe8c76a);
constexpr ui::Colour kWoodFill = ui::hex(0xb07f4c);
constexpr ui::Colour kStepFill = ui::hex(0xc79a6c);

constexpr std::size_t kMostStrokes = 4;
using Strokes = std::array<Stroke, kMostStrokes>;  // those without a path draw nothing

struct Picture {
    Icon icon;
    Strokes strokes;
};

using design::kClayFill;
using design::kSlip;
using design::kWater;

constexpr Strokes kWaves{{{"M6 22 C14 10 20 10 28 20 C36 30 44 30 58 16"},
                          {"M6 36 C14 24 20 24 28 34 C36 44 44 44 58 30"},
                          {"M6 50 C14 38 20 38 28 48 C36 58 44 58 58 44"}}};

// In the order of Icon.
constexpr std::array kPictures{
    Picture{Icon::kUndo,
            {{{"M24 14 L11 27 L25 38"}, {"M12 27 H37 C49 27 54 34 54 41 C54 49 48 54 38 54 H24"}}}},
    Picture{Icon::kAgain, {{{"M14 46 C13 27 23 16 32 16 C42 16 51 27 50 46 Z", kClayFill}, {"M5 52 H59"}}}},
    Picture{
        Icon::kTool,
        {{{"M10 42 C5 22 22 9 40 12 C54 14 60 27 53 36 C46 43 41 36 33 41 C25 47 14 53 10 42 Z", kClayFill},
          {"M20.5 30 a4.5 4.5 0 1 1 9 0 a4.5 4.5 0 1 1 -9 0 Z", kSlip}}}},
    Picture{Icon::kWater,
            {{{"M6 31 H58 C56 48 45 56 32 56 C19 56 8 48 6 31 Z", kWater},
              {"M32 3 C36 11 40 14 40 19 A8 8 0 0 1 24 19 C24 14 28 11 32 3 Z", kWater}}}},
    Picture{Icon::kSpeed,
            {{{"M5 42 a27 10 0 1 1 54 0 a27 10 0 1 1 -54 0 Z", kMetal},
              {"M5 42 V47 C5 53 17 58 32 58 C47 58 59 53 59 47 V42"},
              {"M11 25 C17 15 42 12 51 22"},
              {"M52 10 L52 23 L39 23"}}}},
    Picture{Icon::kDone,
            {{{"M14 42 C8 26 20 22 22 10 H42 C44 22 56 26 50 42 Z", kClayFill},
              {"M4 51 H60"},
              {"M4 46 V56 M60 46 V56"}}}},
    Picture{Icon::kUp, {{{"M32 52 V14 M15 30 L32 12 L49 30"}}}},
    Picture{Icon::kDown, {{{"M32 12 V50 M15 34 L32 52 L49 34"}}}},
    Picture{Icon::kLeft, {{{"M52 32 H14 M30 15 L12 32 L30 49"}}}},
    Picture{Icon::kRight, {{{"M12 32 H50 M34 15 L52 32 L34 49"}}}},
    Picture{Icon::kMinus, {{{"M14 32 H50", {}, 6.0F}}}},
    Picture{Icon::kPlus, {{{"M14 32 H50 M32 14 V50", {}, 6.0F}}}},
    Picture{Icon::kSound,
            {{{"M10 25 H20 L34 13 V51 L20 39 H10 Z", kClayFill},
              {"M43 24 C48 29 48 35 43 40 M50 17 C59 26 59 38 50 47"}}}},
    Picture{Icon::kText,
            {{{"M4 52 L19 14 L34 52 M9 40 H29"}, {"M39 52 L48 29 L57 52 M42 44 H54", {}, 3.0F}}}},
    Picture{Icon::kHand,
            {{{"M18 34 V18 a5 5 0 0 1 10 0 V28 M28 28 V12 a5 5 0 0 1 10 0 V28 M38 28 V16 a5 5 0 0 1 10 0 "
               "V40 "
               "C48 52 40 58 31 58 C22 58 17 53 9 38 C7 33 13 30 18 36",
               kSkin}}}},
    Picture{Icon::kRib,
            {{{"M23 6 C35 3 47 9 47 21 C47 29 41 33 42 41 C44 52 37 60 28 58 C18 56 14 46 15 32 C16 22 14 "
               "9 23 6 Z",
               kClayFill},
              {"M27 19 a4.5 4.5 0 1 1 9 0 a4.5 4.5 0 1 1 -9 0 Z", kSlip}}}},
    Picture{
        Icon::kSponge,
        {{{"M7 36 C7 22 19 13 33 13 C48 13 58 23 57 36 C56 48 44 54 31 53 C18 53 7 48 7 36 Z", kSpongeFill},
          {"M20 30 h1 M31 23 h1 M43 29 h1 M26 41 h1 M38 43 h1 M48 39 h1", {}, 5.0F}}}},
    Picture{Icon::kWire,
            {{{"M22 24 C26 42 38 42 42 24", {}, 2.6F},
              {"M10 12 L22 24 M54 12 L42 24", {}, 8.0F, kWoodFill},
              {"M9 55 H55", {}, 3.0F}}}},
    Picture{Icon::kMore, {{{"M16 40 L32 24 L48 40", {}, 6.0F}}}},
    Picture{Icon::kAbout,
            {{{"M12 8 H44 L54 18 V56 H12 Z", design::kPorcelain},
              {"M22 24 H42 M22 34 H44 M22 44 H36", {}, 3.0F}}}},
    Picture{Icon::kLow, {{{"M10 8 H54 V56 H10 Z"}, {"M10 36 H54"}, {"M32 12 V28 M24 22 L32 30 L40 22"}}}},
    Picture{
        Icon::kStill,
        {{{"M6 40 a26 10 0 1 1 52 0 a26 10 0 1 1 -52 0 Z", kMetal}, {"M22 16 V28 M42 16 V28", {}, 6.0F}}}},
    Picture{Icon::kSpeech,
            {{{"M8 10 H56 V42 H32 L19 56 V42 H8 Z", design::kPorcelain},
              {"M20 22 V30 M28 18 V34 M36 21 V31 M44 24 V28", {}, 4.0F}}}},
    Picture{Icon::kCheck, {{{"M10 34 L26 50 L55 15", {}, 6.0F}}}},
    Picture{Icon::kLookIn,
            {{{"M14 14 C21 4 43 4 50 14 C43 24 21 24 14 14 Z"},
              {"M28 14 a4 4 0 1 1 8 0 a4 4 0 1 1 -8 0 Z"},
              {"M8 37 C10 53 22 60 32 60 C42 60 54 53 56 37"},
              {"M8 36 a24 8 0 1 1 48 0 a24 8 0 1 1 -48 0 Z", kClayFill}}}},
    Picture{Icon::kShow,
            {{{"M22 40 V22 a4 4 0 0 1 8 0 V32 M30 32 V16 a4 4 0 0 1 8 0 V32 M38 32 V20 a4 4 0 0 1 8 0 "
               "V42 C46 52 40 57 32 57 C24 57 20 53 13 42 C11 38 16 35 20 39",
               kSkin},
              {"M20 10 A18 18 0 0 1 46 10 M46 3 V11 H38", {}, 3.2F}}}},
    Picture{Icon::kNoWifi,
            {{{"M4 24 C20 8 44 8 60 24 M14 34 C24 24 40 24 50 34 M23 43 C28 38 36 38 41 43"},
              {"M29 52 a3 3 0 1 1 6 0 a3 3 0 1 1 -6 0 Z", design::kInk},
              {"M9 60 L55 6", {}, 5.0F, design::kRust}}}},
    Picture{Icon::kNoCode,
            {{{"M8 8 H26 V26 H8 Z M38 8 H56 V26 H38 Z M8 38 H26 V56 H8 Z M38 38 H50 M38 47 H44 M48 56 H56"},
              {"M9 60 L55 6", {}, 5.0F, design::kRust}}}},
    Picture{Icon::kStepPress,
            {{{"M10 46 C10 30 16 14 32 14 C48 14 54 30 54 46 Z", kStepFill, 3.4F}, {"M3 51 H61", {}, 3.4F}}}},
    Picture{Icon::kStepOpen,
            {{{"M9 46 V24 H22 C23 34 26 38 32 38 C38 38 41 34 42 24 H55 V46 Z", kStepFill, 3.4F},
              {"M3 51 H61", {}, 3.4F}}}},
    Picture{Icon::kStepRaise,
            {{{"M14 46 V8 H22 V38 H42 V8 H50 V46 Z", kStepFill, 3.4F}, {"M3 51 H61", {}, 3.4F}}}},
    Picture{
        Icon::kJarFirst,
        {{{"M6 16 C8 36 18 46 23 46 H41 C46 46 56 36 58 16 Z", kStepFill, 3.4F}, {"M3 51 H61", {}, 3.4F}}}},
    Picture{Icon::kJarAside,
            {{{"M3 22 C4 37 11 44 14 44 H26 C29 44 36 37 37 22 Z", kStepFill, 3.4F},
              {"M2 50 H38 M44 33 H60 M53 26 L60 33 L53 40", {}, 3.4F}}}},
    Picture{Icon::kJarSecond,
            {{{"M8 26 C10 40 19 46 23 46 H41 C45 46 54 40 56 26 Z", kStepFill, 3.4F},
              {"M6 14 H11 M18 14 H23 M30 14 H35 M42 14 H47 M54 14 H58 M3 51 H61", {}, 3.4F}}}},
    Picture{Icon::kJarJoin,
            {{{"M12 25 C13 12 22 6 25 6 H39 C42 6 51 12 52 25 Z M12 34 C13 46 22 52 25 52 H39 C42 52 "
               "51 46 52 34 Z",
               kStepFill, 3.4F},
              {"M3 57 H61", {}, 3.4F}}}},
    Picture{Icon::kJarWhole,
            {{{"M24 7 H40 C52 12 57 21 57 29 C57 40 49 48 40 51 H24 C15 48 7 40 7 29 C7 21 12 12 24 7 Z",
               kStepFill, 3.4F},
              {"M9 30 H15 M22 30 H28 M36 30 H42 M49 30 H55 M3 56 H61", {}, 3.4F}}}},
    Picture{Icon::kTrimmer,
            {{{"M28 36 L10 54", {}, 8.0F, kWoodFill},
              {"M30 34 C20 18 34 6 46 10 C58 14 58 30 46 34 C40 36 34 36 30 34 Z", {}, 4.0F}}}},
    Picture{Icon::kFingerWaves, kWaves},
    Picture{Icon::kIronBrush,
            {{{"M56 8 L36 32", {}, 5.0F}, {"M36 28 L40 33 C34 44 22 54 12 56 C14 46 24 34 36 28 Z", kIron}}}},
    Picture{
        Icon::kBlueBrush,
        {{{"M56 8 L36 32", {}, 5.0F}, {"M36 28 L40 33 C34 44 22 54 12 56 C14 46 24 34 36 28 Z", kCobalt}}}},
    Picture{Icon::kInlay,
            {{{"M8 32 a24 24 0 1 1 48 0 a24 24 0 1 1 -48 0 Z", kDarkClay},
              {"M14 36 C22 20 28 24 32 33 C36 42 43 42 50 28", {}, 5.0F, kSlip}}}},
    Picture{Icon::kWhiteBrush,
            {{{"M54 6 L42 20", {}, 5.0F},
              {"M36 16 L48 28 L34 44 L20 30 Z", kSlip},
              {"M26 26 L38 38 M8 52 C24 46 42 46 58 52 M16 60 C28 56 40 56 52 60"}}}},
    Picture{Icon::kFlower,
            {{{"M26 32 a6 6 0 1 1 12 0 a6 6 0 1 1 -12 0 Z", kClayFill},
              {"M32 26 C24 18 26 6 32 5 C38 6 40 18 32 26 M38 32 C46 24 58 26 59 32 C58 38 46 40 38 32 "
               "M32 38 C40 46 38 58 32 59 C26 58 24 46 32 38 M26 32 C18 40 6 38 5 32 C6 26 18 24 26 32"},
              {"M28 28 C18 28 12 18 15 15 C18 12 28 18 28 28 M36 28 C36 18 46 12 49 15 C52 18 46 28 36 "
               "28 M36 36 C46 36 52 46 49 49 C46 52 36 46 36 36 M28 36 C28 46 18 52 15 49 C12 46 18 36 28 "
               "36"}}}},
    Picture{Icon::kTurns,
            {{{"M6 44 a26 10 0 1 1 52 0 a26 10 0 1 1 -52 0 Z", kMetal},
              {"M12 26 C18 14 42 10 52 22 M52 10 V23 H39"}}}},
    Picture{
        Icon::kRests,
        {{{"M6 44 a26 10 0 1 1 52 0 a26 10 0 1 1 -52 0 Z", kMetal}, {"M24 12 V28 M40 12 V28", {}, 6.0F}}}},
    Picture{Icon::kWipe,
            {{{"M14 56 C8 40 22 34 22 18 H42 C42 34 56 40 50 56 Z", kClayFill},
              {"M24 36 L40 52 M40 36 L24 52", {}, 4.6F}}}},
    Picture{Icon::kPale, {{{"M14 32 a18 18 0 1 1 36 0 a18 18 0 1 1 -36 0 Z", kSlip}}}},
    Picture{Icon::kDark, {{{"M14 32 a18 18 0 1 1 36 0 a18 18 0 1 1 -36 0 Z", design::kInk}}}},
    Picture{Icon::kBrushDown,
            {{{"M54 6 L40 24", {}, 5.0F},
              {"M40 20 L45 26 C38 38 28 46 18 48 C20 38 28 28 40 20 Z", kClayFill},
              {"M8 56 H56"}}}},
    Picture{
        Icon::kCrane,
        {{{"M6 22 L16 22 C22 26 20 38 30 42 C36 44 44 42 50 38", {}, 4.2F},
          {"M30 40 C32 26 34 14 36 6 C38 18 38 30 38 40 M36 40 C42 28 50 18 56 14 C54 24 48 34 42 41", kSlip},
          {"M44 42 L54 54 M40 43 L46 57"}}}},
    Picture{Icon::kCloud,
            {{{"M20 42 C8 42 6 28 16 26 C16 14 32 10 36 20 C48 16 56 30 46 36 M16 44 C26 54 44 54 58 46"}}}},
    Picture{Icon::kMum,
            {{{"M5 32 a27 27 0 1 1 54 0 a27 27 0 1 1 -54 0 Z", kCeladon},
              {"M27 32 a5 5 0 1 1 10 0 a5 5 0 1 1 -10 0 Z", kSlip},
              {"M32 24 V12 M32 40 V52 M24 32 H12 M40 32 H52 M26 26 L18 18 M38 26 L46 18 M26 38 L18 46 M38 "
               "38 L46 46",
               {},
               5.0F,
               kSlip}}}},
    Picture{Icon::kFish,
            {{{"M6 32 C14 16 36 14 46 30 L58 20 V44 L46 34 C36 50 14 48 6 32 Z", kSlip},
              {"M15 30 H17 M24 22 C28 28 28 36 24 42 M33 24 C36 29 36 35 33 40"}}}},
    Picture{Icon::kGrass,
            {{{"M32 58 C30 40 24 26 10 18 M32 58 C32 38 34 22 40 8 M33 58 C38 44 46 36 58 34 M31 58 C26 48 "
               "18 42 8 42"}}}},
    Picture{Icon::kWave, kWaves},
};

constexpr bool has_each_icon_at_its_place() {
    for (std::size_t i = 0; i < kPictures.size(); ++i) {
        if (kPictures[i].icon != static_cast<Icon>(i)) return false;
    }
    return kPictures.size() == kIconCount;
}
static_assert(has_each_icon_at_its_place());

std::span<const Stroke> strokes_of(Icon icon) {
    const Strokes& all = kPictures[static_cast<std::size_t>(icon)].strokes;
    const auto end =
        std::find_if(all.begin(), all.end(), [](const Stroke& stroke) { return stroke.path.empty(); });
    return {all.begin(), end};
}

void add_strokes(ui::Sketch& sketch, Icon icon, vec2 at, float side, const ui::Colour& stroke,
                 const std::optional<std::optional<ui::Colour>>& other_fill) {
    for (const Stroke& one : strokes_of(icon)) {
        std::optional<ui::Colour> fill = one.fill;
        if (fill && other_fill) fill = *other_fill;
        sketch.add(ui::Shape{.path = std::string(one.path),
                             .placing = {.at = at, .scale = vec2(side / 64.0F)},
                             .fill = fill,
                             .stroke = one.own.value_or(stroke),
                             .stroke_width = one.width});
    }
}

}  // namespace

void add_icon(ui::Sketch& sketch, Icon icon, vec2 at, float side, const ui::Colour& stroke) {
    add_strokes(sketch, icon, at, side, stroke, std::nullopt);
}

void add_icon(ui::Sketch& sketch, Icon icon, vec2 at, float side, const ui::Colour& stroke,
              const std::optional<ui::Colour>& fill) {
    add_strokes(sketch, icon, at, side, stroke, std::optional(fill));
}

std::string spiral_path(float fraction) {
    constexpr int kPoints = 240;
    constexpr float kTurns = 6.0F;
    std::string path;
    for (int i = 0; i <= static_cast<int>(kPoints * fraction); ++i) {
        const float along = static_cast<float>(i) / kPoints;
        const float angle = along * kTurns * kTurnF - 0.5F * kPiF;
        const float radius = 66.0F + along * 92.0F;
        path +=
            fmt::format("{}{:.1f} {:.1f} ", i == 0 ? 'M' : 'L', 0.5F * kSpiralSide + radius * std::cos(angle),
                        0.5F * kSpiralSide + radius * std::sin(angle));
    }
    return path;
}

}  // namespace onggi::screens
