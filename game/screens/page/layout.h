// The picture shapes of the design, and the ledge's edge for the camera. Any thread; pure. u, unless a name
// says px.
#pragma once

#include <algorithm>

#include "engine/math/math.h"
#include "game/kiosk/state.h"

namespace onggi::screens {

enum class Shape { kWide, kTall, kSquare };  // 16:9, 9:16, 4:3

[[nodiscard]] inline Shape shape_of(int width_px, int height_px) {
    const float aspect = static_cast<float>(width_px) / static_cast<float>(std::max(1, height_px));
    if (aspect < 1.0F) return Shape::kTall;
    return aspect < 1.5F ? Shape::kSquare : Shape::kWide;
}

template <typename T>
[[nodiscard]] T by_shape(Shape shape, const T& wide, const T& square, const T& tall) {
    return shape == Shape::kWide ? wide : shape == Shape::kSquare ? square : tall;
}

// The design sizes of the shapes: 1280 x 720 u, 720 x 1280, 1024 x 768. A picture of another shape is at
// least this large in each direction, so that items laid out from opposite edges never meet.
[[nodiscard]] inline vec2 design_size(Shape shape) {
    return by_shape(shape, vec2(1280.0F, 720.0F), vec2(1024.0F, 768.0F), vec2(720.0F, 1280.0F));
}

[[nodiscard]] inline float px_per_u_of(int width_px, int height_px) {
    const vec2 design = design_size(shape_of(width_px, height_px));
    return std::min(static_cast<float>(width_px) / design.x, static_cast<float>(height_px) / design.y);
}

// The ledge's extra height for larger text (1 to 3: 100, 150, 200 %); none with low controls.
[[nodiscard]] inline float ledge_growth(const kiosk::Comfort& comfort) {
    if (comfort.reach || comfort.text_size <= 1) return 0.0F;
    return comfort.text_size == 2 ? 50.0F : 94.0F;
}

// The ledge's upper edge on a picture `height` u high.
[[nodiscard]] inline float ledge_y(Shape shape, float height, const kiosk::Comfort& comfort) {
    return height - by_shape(shape, 146.0F, 210.0F, 380.0F) - ledge_growth(comfort);
}

}  // namespace onggi::screens
