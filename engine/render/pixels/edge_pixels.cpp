#include "engine/render/pixels/edge_pixels.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

// Blends each byte: `fraction` 256ths of `other`, the rest of `own`.
std::uint32_t mixed(std::uint32_t own, std::uint32_t other, std::uint32_t fraction) {
    constexpr std::uint32_t kEven = 0x00FF00FFU;
    constexpr std::uint32_t kHalf = 0x00800080U;
    const auto of = [&](int shift) {
        const std::uint32_t sum =
            ((own >> shift) & kEven) * (256U - fraction) + ((other >> shift) & kEven) * fraction + kHalf;
        return (sum >> 8) & kEven;
    };
    return of(0) | of(8) << 8;
}

// A segment in the coordinates of its major axis (along) and minor axis (across).
struct Line {
    vec2 from;  // along, across
    float lean = 0.0F;
    float first = 0.0F;  // along
    float last = 0.0F;
    float depth = 0.0F;  // at `from`
    float deeper = 0.0F;
};

Line line_of(const OutlinePiece& piece, bool is_level) {
    const auto turned = [&](const vec4& at) { return is_level ? vec2(at.x, at.y) : vec2(at.y, at.x); };
    const vec2 from = turned(piece.from);
    const vec2 to = turned(piece.to);
    const float length = to.x - from.x;
    const float by = std::abs(length) > 1e-4F ? length : std::copysign(1e-4F, length);
    // Extended at both ends, so that adjacent segments leave no gap.
    constexpr float kBeyond = 0.25F;
    return {.from = from,
            .lean = (to.y - from.y) / by,
            .first = std::min(from.x, to.x) - kBeyond,
            .last = std::max(from.x, to.x) + kBeyond,
            .depth = piece.from.z,
            .deeper = (piece.to.z - piece.from.z) / by};
}

}  // namespace

void EdgePixels::smooth(std::span<const OutlinePiece> pieces, const PixelRect& within,
                        const PictureCanvas& canvas) {
    if (within.width <= 0 || within.height <= 0) return;
    smoothed_.clear();
    const auto width = static_cast<std::ptrdiff_t>(canvas.size.width);
    for (const OutlinePiece& piece : pieces) {
        const vec2 length = glm::abs(vec2(piece.to) - vec2(piece.from));
        const bool is_level = length.x > length.y;
        const Line line = line_of(piece, is_level);
        const int low_along = is_level ? within.x : within.y;
        const int low_across = is_level ? within.y : within.x;
        const int end_along = low_along + (is_level ? within.width : within.height);
        const int end_across = low_across + (is_level ? within.height : within.width);
        const std::ptrdiff_t step = is_level ? width : 1;  // to the next pixel across
        const int first = std::max(shapes::first_pixel(line.first, end_along), low_along);
        const int end = shapes::first_pixel(line.last, end_along);
        for (int along = first; along < end; ++along) {
            const float by = static_cast<float>(along) + 0.5F - line.from.x;
            const float across = line.from.y + line.lean * by;
            if (!(across >= static_cast<float>(low_across)) || across >= static_cast<float>(end_across))
                continue;
            // The segment crosses this pixel and splits it at its distance from the pixel's centre.
            const int pixel = static_cast<int>(across);
            const float off = static_cast<float>(pixel) + 0.5F - across;
            const auto at =
                static_cast<std::size_t>(is_level ? pixel * width + along : along * width + pixel);
            if (line.depth + line.deeper * by > canvas.depth[at]) continue;
            const std::size_t beside =
                off > 0.0F ? at - static_cast<std::size_t>(step) : at + static_cast<std::size_t>(step);
            const auto fraction = static_cast<std::uint32_t>((0.5F - std::abs(off)) * 256.0F + 0.5F);
            smoothed_.push_back({at, mixed(canvas.pixels[at], canvas.pixels[beside], fraction)});
        }
    }
    for (const Smoothed& one : smoothed_)
        canvas.pixels[one.at] = one.pixel;
}

}  // namespace onggi::render
