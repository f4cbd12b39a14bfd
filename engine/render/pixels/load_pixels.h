// How near clay is to giving way, laid on its own colour eight pixels at a time: shaders/load.glsl for a
// device that is the processor. Inline, so that it becomes a part of whatever instructions its user is
// compiled for. Any thread; pure.
#pragma once

#include "engine/render/pixels/pixel_blocks.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace onggi::render::blocks {

// 0 up to `from`, 1 from there plus 1 / `slope` on.
[[gnu::always_inline]] inline Block smooth_step(const Block& at, const Block& from, const Block& slope) {
    return eased(least(most((at - from) * slope, 0.0F), 1.0F));
}

// Of numbers that are not below 0.
[[gnu::always_inline]] inline Block fraction(const Block& number) {
    return number - floats(ints(number));
}

// A number that changes over the picture, and by how much it does from a pixel to the next ones.
struct Spread {
    Block value;
    Block width;
};

// What its three layers leave of the colour under them: a reddening, a hatch, and lines where the warning
// begins.
struct LoadLayers {
    Block red;
    Block dark;
    Block pale;

    // 1 gives way. `along`: mm along the hatch's own axis, not below 0.
    [[gnu::always_inline]] static LoadLayers of(const Spread& load, const Spread& along) {
        constexpr float kWarns = 0.6F;
        constexpr float kHatchMm = 7.0F;
        const Block past = load.value - kWarns;
        const Block near = least(most(past / (1.0F - kWarns), 0.0F), 1.0F);
        const Block warned = smooth_step(past, Block{}, Block{} + 20.0F);
        const Block line = magnitude(fraction(along.value / kHatchMm) - 0.5F);
        const Block width = most(along.width / kHatchMm, 1e-5F);
        const Block hatch = 1.0F - smooth_step(line, 0.10F + 0.25F * near, 1.0F / width);
        const Block frame_px = magnitude(past) / most(load.width, 1e-5F);
        return {.red = (0.25F + 0.45F * near) * warned,
                .dark = hatch * warned * 0.85F,
                .pale = 1.0F - smooth_step(frame_px, Block{} + 1.2F, Block{} + 1.0F)};
    }
    [[gnu::always_inline]] [[nodiscard]] Block over(const Block& own, int channel) const {
        constexpr vec3 kRed{0.50F, 0.10F, 0.03F};
        constexpr vec3 kDark{0.045F, 0.008F, 0.002F};
        constexpr vec3 kPale{1.0F, 0.88F, 0.66F};
        Block shown = own + (kRed[channel] - own) * red;
        shown += (kDark[channel] - shown) * dark;
        return shown + (kPale[channel] - shown) * pale;
    }
};

}  // namespace onggi::render::blocks

#pragma GCC diagnostic pop
