// The design as numbers: colours, type, distances, in u. One u is 1/720 of a 16:9 picture's height. Any
// thread; constant. A test checks the contrast of every pair in use.
#pragma once

#include "engine/ui/colour.h"

namespace onggi::screens::design {

using ui::Colour;
using ui::hex;

inline constexpr Colour kInk = hex(0x2a1f17);
inline constexpr Colour kInk2 = hex(0x4b3b2d);
inline constexpr Colour kSlip = hex(0xf7f0e3);
inline constexpr Colour kSlip2 = hex(0xddcfb8);
inline constexpr Colour kSlip3 = hex(0xefe3cd);
inline constexpr Colour kWhiteSlip = hex(0xfff8ea);
inline constexpr Colour kHanji = hex(0xefe5d2);
inline constexpr Colour kPorcelain = hex(0xfbf8f1);
inline constexpr Colour kNight = hex(0x1b1410);
inline constexpr Colour kNightTop = hex(0x3a2a1e);
inline constexpr Colour kCeladonHi = hex(0xcbdcc4);
inline constexpr Colour kCeladonLo = hex(0xa8c3a1);
inline constexpr Colour kTokenHi = hex(0xfdf8ee);
inline constexpr Colour kTokenLo = hex(0xece1cd);
inline constexpr Colour kBareClay = hex(0xb98556);
inline constexpr Colour kRust = hex(0x8a3212);
inline constexpr Colour kHatch = hex(0x5a1c08);
inline constexpr Colour kAmber = hex(0xf3bd72);
inline constexpr Colour kDot = hex(0x7d4f2a);
inline constexpr Colour kClayFill = hex(0xcda077);
inline constexpr Colour kWater = hex(0xa9c0bf);
inline constexpr Colour kNiche = hex(0x3a2c21);
inline constexpr Colour kNicheEdge = hex(0x85705a);
inline constexpr Colour kOutline = hex(0xfff6e2);
inline constexpr Colour kTokenEdge = hex(0xe9dcc6);
inline constexpr Colour kWallLight = hex(0x6a5642);
inline constexpr Colour kWall = hex(0x4a3a2c);
inline constexpr Colour kWallDark = hex(0x281e16);
inline constexpr Colour kShelf = hex(0x70573f);
inline constexpr Colour kShelfEdge = hex(0x7d5c3a);
inline constexpr Colour kRule = hex(0xd3c3a8);

// Disabled controls: the opacity of a picture, and the colour of words on the ledge.
inline constexpr float kRestingAlpha = 0.45F;
inline constexpr Colour kRestingWords = hex(0x948a7f);

// The paper's colours of Fig. 6; the sum is black there, and black with a pale edge here.
inline constexpr Colour kStiffness = hex(0xf79a4b);
inline constexpr Colour kViscosity = hex(0x7fbcf5);
inline constexpr Colour kFriction = hex(0x8fd67a);

inline constexpr float kMargin = 32.0F;
inline constexpr float kLeastTextSize = 26.0F;

// The type of words at the default text size.
enum class Face { kPlain, kBold, kSerif };
struct Type {
    float size;
    float line;
    Face face = Face::kPlain;
    float least_size = kLeastTextSize;  // the smallest size to fit a box

    [[nodiscard]] constexpr Type times(float scale) const {
        return {size * scale, line * scale, face, least_size};
    }
    [[nodiscard]] constexpr Type bold_if(bool is_bold) const {
        return {size, line, is_bold ? Face::kBold : face, least_size};
    }
};
constexpr Type bold(float size, float line) {
    return {size, line, Face::kBold};
}
constexpr Type serif(float size, float line, float least_size = 40.0F) {
    return {size, line, Face::kSerif, least_size};
}
inline constexpr Type kTitle = serif(46.0F, 62.0F);
inline constexpr Type kHeading = bold(28.0F, 38.0F);
inline constexpr Type kBody{30.0F, 40.0F};
inline constexpr Type kLine{28.0F, 40.0F};
inline constexpr Type kReading{27.0F, 36.0F};
inline constexpr Type kName = bold(27.0F, 34.0F);  // a step's name beside its controls
inline constexpr Type kNote{26.0F, 34.0F};
inline constexpr Type kPaper{26.0F, 33.0F};  // on a card of paper
inline constexpr Type kLabel{26.0F, 32.0F};  // below a control

inline constexpr float kLeastTarget = 50.0F;  // the ends of a stepper, the staff's keys
// The panel for which u was chosen: 24 inches, 1080 lines.
inline constexpr float kMmPerU = 0.4151F;
// Cap height in ems of the families with the lowest capitals, Noto Sans and Serif.
inline constexpr double kCapitalFraction = 0.719;

}  // namespace onggi::screens::design
