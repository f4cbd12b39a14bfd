#include "engine/render/pixels/overlay_paint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>

#include "engine/core/hash.h"
#include "engine/render/upload_ledger.h"

namespace onggi::render {
namespace {

std::uint64_t key_of(int x, int y) {
    return std::uint64_t{static_cast<std::uint32_t>(y)} << 32U | static_cast<std::uint32_t>(x);
}

}  // namespace

void OverlayPictures::take(std::span<const ui::Atlas::Upload> uploads, int side_px) {
    if (side_px != side_px_) pictures_.clear();
    side_px_ = side_px;
    for (const ui::Atlas::Upload& upload : uploads) {
        std::erase_if(pictures_, [&](const auto& older) { return overlap(older.second.placed, upload); });
        pictures_[key_of(upload.x, upload.y)] = {upload, ++last_number_};
    }
}

const OverlayPictures::Picture* OverlayPictures::at(vec2 corner_px) const {
    const glm::ivec2 corner(corner_px);
    const auto found = pictures_.find(key_of(corner.x, corner.y));
    return found == pictures_.end() ? nullptr : &found->second;
}

namespace {

PixelRect rect_of(std::span<const ui::Vertex> vertices, std::span<const std::uint32_t> corners) {
    vec2 low = vertices[corners[0]].position_px;
    vec2 high = low;
    for (const std::uint32_t corner : corners.subspan(1)) {
        low = glm::min(low, vertices[corner].position_px);
        high = glm::max(high, vertices[corner].position_px);
    }
    return rect_about(low, high);
}

}  // namespace

void OverlayTiles::learn(const TileGrid& grid, const ui::DrawList& list, const OverlayPictures& pictures) {
    const bool is_known = content_.size() == grid.count() && grid == grid_;
    const std::uint64_t list_hash = list.hash();
    if (is_known && list_hash == list_hash_ && pictures.state() == pictures_state_) return;
    grid_ = grid;
    list_hash_ = list_hash;
    pictures_state_ = pictures.state();
    content_.assign(grid.count(), 0);
    for (const ui::Run& run : list.runs()) {
        const std::span<const std::uint32_t> indices =
            list.indices().subspan(run.first_index, run.index_count);
        for (std::size_t at = 0; at < indices.size(); at += 3) {
            const std::span<const std::uint32_t> corners = indices.subspan(at, 3);
            StateHash of_triangle;
            of_triangle.add_word(run.from_atlas ? 1 : 0);
            if (run.from_atlas) {
                const auto* picture = pictures.at(list.vertices()[corners[0]].atlas_px);
                of_triangle.add_word(picture == nullptr ? 0 : picture->number);
            }
            for (const std::uint32_t corner : corners) {
                static_assert(sizeof(ui::Vertex) == 2 * sizeof(vec2) + sizeof(std::uint32_t));
                of_triangle.add_bytes(std::as_bytes(list.vertices().subspan(corner, 1)));
            }
            for_tiles(grid, rect_of(list.vertices(), corners), [&](std::size_t tile) {
                StateHash number;
                number.add_word(content_[tile]);
                number.add_word(of_triangle.value());
                content_[tile] = std::max<std::uint64_t>(number.value(), 1);
            });
        }
    }
}

namespace {

// Compiler vectors, so that each processor uses its best instructions and computes the same bits.
constexpr std::size_t kLanes = 4;
using Words [[gnu::vector_size(16)]] = std::uint32_t;
using Halves [[gnu::vector_size(16)]] = std::uint16_t;
using Ints [[gnu::vector_size(16)]] = std::int32_t;
using Floats [[gnu::vector_size(16)]] = float;

constexpr std::uint32_t kEvenBytes = 0x00FF00FFU;

// Converts 0..255 to 0..256, in both halves of each word.
[[gnu::always_inline]] inline Words part_of_256(const Words& of_255) {
    const Words part = of_255 + (of_255 >> 7);
    return part | part << 16;
}

[[gnu::always_inline]] inline Words scaled(const Words& pixels, const Words& part_in_both_halves) {
    const auto part = std::bit_cast<Halves>(part_in_both_halves);
    const Halves even = (std::bit_cast<Halves>(pixels & kEvenBytes) * part + 128) >> 8;
    const Halves odd = std::bit_cast<Halves>(pixels >> 8 & kEvenBytes) * part + 128;
    return std::bit_cast<Words>(even) | (std::bit_cast<Words>(odd) & ~kEvenBytes);
}

// No byte exceeds 255, because no colour in `over` (premultiplied) exceeds its alpha.
[[gnu::always_inline]] inline Words laid_over(const Words& under, const Words& over) {
    return over + scaled(under, part_of_256(255U - (over >> 24)));
}

std::uint32_t in_order(std::uint32_t pixel, ByteOrder order) {
    if (order == ByteOrder::kRedFirst) return pixel;
    return (pixel & 0xFF00FF00U) | (pixel & 0xFFU) << 16U | (pixel >> 16U & 0xFFU);
}

[[gnu::always_inline]] inline Words in_order(const Words& pixels, ByteOrder order) {
    if (order == ByteOrder::kRedFirst) return pixels;
    return (pixels & 0xFF00FF00U) | (pixels & 0xFFU) << 16 | (pixels >> 16 & 0xFFU);
}

// Composes `over(at, bytes)` over a row, four pixels at a time; the last group may be smaller.
template <typename Over>
[[gnu::always_inline]] inline void lay_row(std::uint32_t* pixels, std::size_t count, const Over& over) {
    const auto lay = [&](std::size_t at, std::size_t bytes) {
        Words under{};
        std::memcpy(&under, pixels + at, bytes);
        const Words laid = laid_over(under, over(at, bytes));
        std::memcpy(pixels + at, &laid, bytes);
    };
    std::size_t at = 0;
    for (; at + kLanes <= count; at += kLanes)
        lay(at, sizeof(Words));  // with a constant size, memcpy is one instruction
    if (at < count) lay(at, (count - at) * sizeof(std::uint32_t));
}

// A run of pixels in a row that a shape is drawn over.
struct Span {
    int y = 0;
    int left = 0;
    std::uint32_t* pixels = nullptr;
    std::size_t count = 0;
};

void lay_even(std::uint32_t colour, const Span& span) {
    const Words over = Words{} + colour;
    lay_row(span.pixels, span.count, [&](std::size_t, std::size_t) { return over; });
}

// For each byte: the value at the first pixel of a span, and the gradient along it.
struct Shading {
    Floats first{};
    Floats across{};
};

void lay_shaded(const Shading& shading, const Span& span) {
    constexpr Floats kSteps{0.0F, 1.0F, 2.0F, 3.0F};
    const Floats kMost = Floats{} + 255.0F;
    std::array<Floats, 4> value;
    std::array<Floats, 4> step;
    for (std::size_t byte = 0; byte < 4; ++byte) {
        value[byte] = shading.first[byte] + 0.5F + shading.across[byte] * kSteps;
        step[byte] = Floats{} + shading.across[byte] * static_cast<float>(kLanes);
    }
    lay_row(span.pixels, span.count, [&](std::size_t, std::size_t) {
        Words over{};
        const Floats alpha = value[3] < kMost ? value[3] : kMost;
        for (std::size_t byte = 0; byte < 4; ++byte) {
            // Clamp: rounding, or the steep gradient of a sliver, must not raise a colour above its alpha or
            // overflow a byte.
            const Floats least = value[byte] < alpha ? value[byte] : alpha;
            const Floats kept = least > Floats{} ? least : Floats{};
            over |= std::bit_cast<Words>(__builtin_convertvector(kept, Ints)) << (8 * byte);
            value[byte] += step[byte];
        }
        return over;
    });
}

struct Picture {
    const ui::Painting* painting = nullptr;
    glm::ivec2 corner{0};     // position of its upper left pixel
    std::uint32_t alpha = 0;  // of 255
    ByteOrder order = ByteOrder::kRedFirst;
};

void lay_picture(const Picture& picture, const Span& span) {
    const ui::Painting& painting = *picture.painting;
    const glm::ivec2 at = glm::ivec2(span.left, span.y) - picture.corner;
    if (at.y < 0 || at.y >= painting.height || at.x < 0 || at.x >= painting.width) return;
    const std::size_t there = std::min(span.count, static_cast<std::size_t>(painting.width - at.x));
    const std::uint8_t* const row = painting.rgba.data() + 4 * (static_cast<std::size_t>(at.y) *
                                                                    static_cast<std::size_t>(painting.width) +
                                                                static_cast<std::size_t>(at.x));
    const Words part = part_of_256(Words{} + picture.alpha);
    lay_row(span.pixels, there, [&](std::size_t first, std::size_t bytes) {
        Words over{};
        std::memcpy(&over, row + 4 * first, bytes);
        if (picture.alpha < 255) over = scaled(over, part);
        return in_order(over, picture.order);
    });
}

Floats bytes_of(std::uint32_t rgba) {
    const auto byte = [&](unsigned at) { return static_cast<float>(rgba >> (8 * at) & 0xFFU); };
    return Floats{byte(0), byte(1), byte(2), byte(3)};
}

// Returns the first pixel whose centre is at or after `edge`.
int first_pixel(float edge, int least, int most) {
    // In this argument order NaN yields `least`.
    return static_cast<int>(
        std::min(std::max(static_cast<float>(least), std::ceil(edge - 0.5F)), static_cast<float>(most)));
}

// The target of the painting and its clip rectangle.
struct Sheet {
    PixelRect inside;
    int width_px = 0;
    std::span<std::uint32_t> pixels;

    [[nodiscard]] int first_row(float edge) const {
        return first_pixel(edge, inside.y, inside.y + inside.height);
    }
    // Returns the part of a row between two edges; may be empty.
    [[nodiscard]] Span span(int y, float left_edge, float right_edge) const {
        const int left = first_pixel(left_edge, inside.x, inside.x + inside.width);
        const int right = first_pixel(right_edge, inside.x, inside.x + inside.width);
        return {y, left, pixels.data() + static_cast<std::ptrdiff_t>(y) * width_px + left,
                static_cast<std::size_t>(std::max(right - left, 0))};
    }
};

// An axis-aligned rectangle: upper left corner, then clockwise.
using Quad = std::array<ui::Vertex, 4>;

// Interpolates along the left and right sides, then across each row.
void paint_box(const Quad& box, const Sheet& sheet) {
    const vec2 from = box[0].position_px;
    const vec2 size = box[2].position_px - from;
    const float per_px = 1.0F / size.x;
    const bool is_even = std::all_of(box.begin() + 1, box.end(),
                                     [&](const ui::Vertex& corner) { return corner.rgba == box[0].rgba; });
    const int end = sheet.first_row(from.y + size.y);
    for (int y = sheet.first_row(from.y); y < end; ++y) {
        const Span span = sheet.span(y, from.x, from.x + size.x);
        if (is_even) {
            lay_even(box[0].rgba, span);
            continue;
        }
        const float down = (static_cast<float>(y) + 0.5F - from.y) / size.y;
        const Floats left = bytes_of(box[0].rgba) * (1.0F - down) + bytes_of(box[3].rgba) * down;
        const Floats right = bytes_of(box[1].rgba) * (1.0F - down) + bytes_of(box[2].rgba) * down;
        const Floats across = (right - left) * per_px;
        lay_shaded({left + across * (static_cast<float>(span.left) + 0.5F - from.x), across}, span);
    }
}

void paint_picture(const Quad& box, const Picture& picture, const Sheet& sheet) {
    const int end = sheet.first_row(box[2].position_px.y);
    for (int y = sheet.first_row(box[0].position_px.y); y < end; ++y)
        lay_picture(picture, sheet.span(y, box[0].position_px.x, box[2].position_px.x));
}

using Triangle = std::array<ui::Vertex, 3>;

// The plane through three corners' colours: for each byte the value at the pixel centre (0, 0) and its
// gradients. Empty for a triangle without area.
struct Plane {
    Floats origin{};
    Floats across{};
    Floats down{};
};
std::optional<Plane> plane_of(const Triangle& corners) {
    const vec2 a = corners[0].position_px;
    const vec2 ab = corners[1].position_px - a;
    const vec2 ac = corners[2].position_px - a;
    const float area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0.0F) return std::nullopt;
    const Floats at_a = bytes_of(corners[0].rgba);
    const Floats b = bytes_of(corners[1].rgba) - at_a;
    const Floats c = bytes_of(corners[2].rgba) - at_a;
    const Floats across = (b * ac.y - c * ab.y) / area;
    const Floats down = (c * ab.x - b * ac.x) / area;
    return Plane{at_a + across * (0.5F - a.x) + down * (0.5F - a.y), across, down};
}

// Returns where a horizontal line crosses the sides of a triangle. A side is always walked downwards, so that
// the two triangles that share it agree on its pixels.
std::optional<vec2> crossed(const Triangle& corners, float y) {
    vec2 ends(1e9F, -1e9F);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        vec2 high = corners[i].position_px;
        vec2 low = corners[(i + 1) % corners.size()].position_px;
        if (high.y > low.y) std::swap(high, low);
        if (!(high.y <= y && y < low.y)) continue;
        const float x = high.x + (y - high.y) * ((low.x - high.x) / (low.y - high.y));
        ends = {std::min(ends.x, x), std::max(ends.y, x)};
    }
    if (ends.x >= ends.y) return std::nullopt;
    return ends;
}

void paint_triangle(const Triangle& corners, const Sheet& sheet) {
    const auto plane = plane_of(corners);
    if (!plane) return;
    const auto [high, low] =
        std::minmax({corners[0].position_px.y, corners[1].position_px.y, corners[2].position_px.y});
    const int end = sheet.first_row(low);
    for (int y = sheet.first_row(high); y < end; ++y) {
        const auto ends = crossed(corners, static_cast<float>(y) + 0.5F);
        if (!ends) continue;
        const Span span = sheet.span(y, ends->x, ends->y);
        const Floats first = plane->origin + plane->across * static_cast<float>(span.left) +
                             plane->down * static_cast<float>(y);
        lay_shaded({first, plane->across}, span);
    }
}

bool may_touch(std::span<const ui::Vertex> corners, const PixelRect& inside) {
    vec2 low = corners[0].position_px;
    vec2 high = low;
    for (const ui::Vertex& corner : corners.subspan(1)) {
        low = glm::min(low, corner.position_px);
        high = glm::max(high, corner.position_px);
    }
    const vec2 from(inside.x, inside.y);
    const vec2 to = from + vec2(inside.width, inside.height);
    return low.x < to.x && low.y < to.y && high.x > from.x && high.y > from.y;
}

// Returns the next two triangles as a box if they form one.
std::optional<Quad> next_box(std::span<const ui::Vertex> vertices, std::span<const std::uint32_t> indices) {
    if (indices.size() < 6 || indices[3] != indices[0] || indices[4] != indices[2]) return std::nullopt;
    const Quad box{vertices[indices[0]], vertices[indices[1]], vertices[indices[2]], vertices[indices[5]]};
    const auto at = [&](std::size_t corner) { return box[corner].position_px; };
    const bool is_upright =
        at(0).x == at(3).x && at(1).x == at(2).x && at(0).y == at(1).y && at(2).y == at(3).y;
    if (!is_upright || !(at(2).x > at(0).x && at(2).y > at(0).y)) return std::nullopt;
    return box;
}

}  // namespace

void paint_overlay(const OverlayPainting& painting, const PixelRect& inside, int width_px,
                   std::span<std::uint32_t> into) {
    const Sheet sheet{inside, width_px, into};
    for (int y = inside.y; y < inside.y + inside.height; ++y)
        std::fill_n(into.data() + static_cast<std::ptrdiff_t>(y) * width_px + inside.x, inside.width, 0U);
    const std::span<const ui::Vertex> vertices = painting.list.vertices();
    const auto ordered = [&](ui::Vertex vertex) {
        vertex.rgba = in_order(vertex.rgba, painting.order);
        return vertex;
    };
    for (const ui::Run& run : painting.list.runs()) {
        auto indices = painting.list.indices().subspan(run.first_index, run.index_count);
        while (indices.size() >= 3) {
            auto box = next_box(vertices, indices);
            if (box) {
                indices = indices.subspan(6);
                if (!may_touch(*box, inside)) continue;
                if (!run.from_atlas) {
                    std::transform(box->begin(), box->end(), box->begin(), ordered);
                    paint_box(*box, sheet);
                } else if (const auto* picture = painting.pictures.at((*box)[0].atlas_px)) {
                    paint_picture(*box,
                                  {.painting = picture->placed.painting.get(),
                                   .corner = glm::ivec2((*box)[0].position_px),
                                   .alpha = (*box)[0].rgba >> 24U,
                                   .order = painting.order},
                                  sheet);
                }
                continue;
            }
            const Triangle corners{ordered(vertices[indices[0]]), ordered(vertices[indices[1]]),
                                   ordered(vertices[indices[2]])};
            indices = indices.subspan(3);
            if (!run.from_atlas && may_touch(corners, inside)) paint_triangle(corners, sheet);
        }
    }
}

void lay_over(std::span<const std::uint32_t> painted, std::span<const std::uint32_t> under,
              const PixelRect& inside, int width_px, std::span<std::uint32_t> into) {
    for (int y = inside.y; y < inside.y + inside.height; ++y) {
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                           static_cast<std::size_t>(inside.x);
        const auto count = static_cast<std::size_t>(inside.width);
        if (into.data() != under.data())
            std::memcpy(into.data() + first, under.data() + first, count * sizeof(std::uint32_t));
        lay_row(into.data() + first, count, [&](std::size_t at, std::size_t bytes) {
            Words over{};
            std::memcpy(&over, painted.data() + first + at, bytes);
            return over;
        });
    }
}

}  // namespace onggi::render
