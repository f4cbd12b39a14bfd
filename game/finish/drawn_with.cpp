#include "game/finish/drawn_with.h"

#include <algorithm>
#include <cstddef>

#include "engine/math/luminance.h"
#include "game/decoration/motifs.h"
#include "game/finish/mark_colour.h"

namespace onggi::finish {

using decoration::Ink;
using decoration::Pigment;
using decoration::Stroke;
using decoration::Technique;
using decoration::Texel;

namespace {

bool is_inlay(const Stroke& stroke) {
    if (stroke.technique == Technique::kInlay) return true;
    const auto lines = decoration::lines_of(stroke.motif);
    return std::any_of(lines.begin(), lines.end(), [](const decoration::MotifLine& line) {
        return line.ink == Ink::kWhiteInlay || line.ink == Ink::kBlackInlay;
    });
}

}  // namespace

bool DrawnWith::nothing() const {
    return wiped == 0 && std::all_of(pigment.begin(), pigment.end(), [](std::uint32_t n) { return n == 0; });
}

DrawnWith drawn_with(const decoration::Texture& texture, const decoration::Strokes& strokes) {
    constexpr std::uint8_t kMostly = 128;
    DrawnWith drawn;
    for (const Texel& texel : texture.texels) {
        if (texel.amount >= kMostly) {
            ++drawn.pigment[static_cast<std::size_t>(texel.pigment)];
        } else if (texel.coat != 0 && texel.coat < (Texel::kWiped + 255) / 2) {
            ++drawn.wiped;
        }
    }
    drawn.pigment[static_cast<std::size_t>(Pigment::kNone)] = 0;
    const auto last_clear = std::find_if(strokes.rbegin(), strokes.rend(), [](const Stroke& stroke) {
        return stroke.technique == Technique::kClear;
    });
    drawn.inlaid = std::any_of(strokes.rbegin(), last_clear, is_inlay);
    return drawn;
}

bool hides(const GlazeMaterial& glaze, const DrawnWith& drawn) {
    constexpr float kSeen = 1.35F;    // contrast; chosen by eye, on sheets of every pigment under every glaze
    constexpr float kBetween = 0.3F;  // bare fraction between the streaks of a brushed coat
    constexpr float kTelling = 0.1F;  // fraction of the drawing
    const vec3 ground = glm::mix(glaze.colour, glaze.thin_colour, kBetween * glaze.brushed);
    float all = 0.0F;
    float seen = 0.0F;
    for (int i = 1; i < decoration::kPigmentCount; ++i) {
        const auto count = static_cast<float>(drawn.pigment[static_cast<std::size_t>(i)]);
        const vec3 mark = pigment_colour(glaze.marks, static_cast<Pigment>(i));
        all += count;
        if (contrast(luminance(mark), luminance(ground)) >= kSeen) seen += count;
    }
    const auto wiped = static_cast<float>(drawn.wiped);
    return all + wiped > 0.0F && seen + wiped < kTelling * (all + wiped);
}

}  // namespace onggi::finish
