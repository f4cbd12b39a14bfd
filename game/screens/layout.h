// The shapes of picture that the design knows, and what the camera has to know of them: where the ledge
// begins. Any thread; pure. u, unless a name says px.
#pragma once

#include <algorithm>

#include "game/kiosk/state.h"

namespace onggi::screens {

enum class Shape { kWide, kTall, kSquare };  // 16:9, 9:16, 4:3

[[nodiscard]] inline Shape shape_of(int width_px, int height_px) {
    const float aspect = static_cast<float>(width_px) / static_cast<float>(std::max(1, height_px));
    if (aspect < 1.0F) return Shape::kTall;
    return aspect < 1.5F ? Shape::kSquare : Shape::kWide;
}

// The designs are 720 u high, 720 wide when tall, and 768 high at 4:3.
[[nodiscard]] inline float px_per_u_of(int width_px, int height_px) {
    const Shape shape = shape_of(width_px, height_px);
    const float short_side = shape == Shape::kSquare ? 768.0F : 720.0F;
    return static_cast<float>(shape == Shape::kTall ? width_px : height_px) / short_side;
}

// How much further the ledge reaches up for larger text; 1 to 3: 100, 150, 200 %. Not where everything has to
// stay within a short reach.
[[nodiscard]] inline float ledge_growth(const kiosk::Comfort& comfort) {
    if (comfort.reach || comfort.text_size <= 1) return 0.0F;
    return comfort.text_size == 2 ? 50.0F : 94.0F;
}

// The ledge's upper edge on a picture that is so many u high.
[[nodiscard]] inline float ledge_y(Shape shape, float height, const kiosk::Comfort& comfort) {
    const float deep = shape == Shape::kTall ? 380.0F : shape == Shape::kSquare ? 210.0F : 146.0F;
    return height - deep - ledge_growth(comfort);
}

}  // namespace onggi::screens
