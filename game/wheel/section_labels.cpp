#include "game/wheel/section_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace onggi::wheel {
namespace {

using ui::Colour;

// Chosen by eye in a picture of 640 x 480; all lengths scale with the picture.
constexpr float kTextPx = 15.0F;
constexpr float kLeastTextPx = 9.0F;
constexpr float kTagHeightPx = 19.0F;
constexpr float kTagPaddingPx = 6.0F;
constexpr float kBetweenTagsPx = 4.0F;
constexpr float kLeaderPx = 30.0F;
constexpr float kMarginPx = 5.0F;
constexpr float kTickPx = 3.0F;
constexpr Colour kInk = ui::hex(0x2a1f17);
constexpr Colour kPaper = ui::hex(0xfbf5e8);

constexpr double kBelowRimMm = 3.0;  // a rim is rounded
constexpr double kAboveFloorMm = 5.0;
constexpr double kClosestMm = 10.0;  // least distance of two measured walls
constexpr std::size_t kMostWalls = 6;

// The hollow rings of a pot, by height.
class Wall {
  public:
    explicit Wall(const pot::Pot& pot) : pot_(pot) {
        const bool sound =
            pot.inner_mm.size() == pot.outer_mm.size() && pot.top_mm.size() == pot.outer_mm.size();
        for (std::size_t i = 0; sound && i < pot.outer_mm.size(); ++i) {
            if (pot.inner_mm[i] > 0.0F) rings_.push_back(i);
        }
    }
    [[nodiscard]] bool empty() const { return rings_.empty(); }
    [[nodiscard]] double bottom_mm() const { return middle_mm(rings_.front()); }
    [[nodiscard]] double top_mm() const { return middle_mm(rings_.back()); }
    [[nodiscard]] double middle_mm(std::size_t ring) const {
        const double below = ring > 0 ? static_cast<double>(pot_.top_mm[ring - 1]) : 0.0;
        return 0.5 * (below + static_cast<double>(pot_.top_mm[ring]));
    }
    [[nodiscard]] std::size_t at(double y_mm) const {
        return *std::min_element(rings_.begin(), rings_.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(middle_mm(a) - y_mm) < std::abs(middle_mm(b) - y_mm);
        });
    }
    // The ring with the least `value`, from that height up.
    template <typename Value>
    [[nodiscard]] std::size_t least(const Value& value, double from_mm = 0.0) const {
        std::size_t best = rings_.back();
        for (const std::size_t ring : rings_) {
            if (middle_mm(ring) >= from_mm && value(ring) < value(best)) best = ring;
        }
        return best;
    }
    [[nodiscard]] SectionMeasure measure(std::size_t ring) const {
        const auto outer = static_cast<double>(pot_.outer_mm[ring]);
        return {.height_mm = middle_mm(ring),
                .thickness_mm = outer - static_cast<double>(pot_.inner_mm[ring]),
                .outer_mm = outer};
    }

  private:
    const pot::Pot& pot_;
    std::vector<std::size_t> rings_;
};

// Adds a wall unless another measured one is near. Keeps the order, top down.
void add_apart(std::vector<SectionMeasure>& walls, const SectionMeasure& wall, double apart_mm) {
    if (walls.size() >= kMostWalls) return;
    for (const SectionMeasure& other : walls) {
        if (std::abs(other.height_mm - wall.height_mm) < apart_mm) return;
    }
    const auto lower = [](const SectionMeasure& a, const SectionMeasure& b) {
        return a.height_mm > b.height_mm;
    };
    walls.insert(std::upper_bound(walls.begin(), walls.end(), wall, lower), wall);
}

}  // namespace

std::vector<SectionMeasure> section_measures(const pot::Pot& pot) {
    const Wall wall(pot);
    if (wall.empty()) return {};
    const double bottom = wall.bottom_mm();
    const double length = wall.top_mm() - bottom;
    const double apart = std::max(kClosestMm, 0.1 * length);
    const auto outer = [&](std::size_t ring) { return pot.outer_mm[ring]; };
    const auto wideness = [&](std::size_t ring) { return -pot.outer_mm[ring]; };
    const auto thickness = [&](std::size_t ring) { return pot.outer_mm[ring] - pot.inner_mm[ring]; };
    const std::size_t belly = wall.least(wideness);
    std::vector<SectionMeasure> walls;
    for (const std::size_t ring : {wall.at(wall.top_mm() - std::min(kBelowRimMm, 0.1 * length)),
                                   wall.at(bottom + std::min(kAboveFloorMm, 0.1 * length)),
                                   wall.least(thickness), belly, wall.least(outer, wall.middle_mm(belly))})
        add_apart(walls, wall.measure(ring), apart);
    // Then add walls half way in the largest gaps.
    while (walls.size() < kMostWalls) {
        std::size_t widest = 0;
        double gap = 0.0;
        for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
            const double here = walls[i].height_mm - walls[i + 1].height_mm;
            if (here > gap) gap = here, widest = i;
        }
        if (gap < 2.5 * apart) break;
        const std::size_t before = walls.size();
        add_apart(walls, wall.measure(wall.at(walls[widest].height_mm - 0.5 * gap)), apart);
        if (walls.size() == before) break;
    }
    walls.push_back({.of_floor = true,
                     .height_mm = 0.5 * pot.floor_mm,
                     .thickness_mm = pot.floor_mm,
                     .outer_mm = static_cast<double>(pot.outer_mm.front())});
    return walls;
}

std::string words_of(const SectionMeasure& measure) {
    return fmt::format("{:.1f} mm", measure.thickness_mm);
}

namespace {

// Maps points of the cut plane to pixels.
class Section {
  public:
    Section(const pot::Pot& pot, const dvec2& wheel_direction, const render::Camera& camera, int width_px,
            int height_px)
        : pot_(pot),
          wheel_direction_(wheel_direction),
          camera_(camera),
          width_px_(width_px),
          height_px_(height_px),
          towards_rad_(
              std::atan2(static_cast<double>(camera.eye_mm.x), static_cast<double>(camera.eye_mm.z))) {}

    // Pixel of a point of the cut, by its radius (negative to the left of the axis), before dents and
    // off-centre.
    [[nodiscard]] std::optional<vec2> pixel(double radius_mm, double y_mm) const {
        const dvec2 right{std::cos(towards_rad_), -std::sin(towards_rad_)};  // (x, z)
        const dvec2 centre = centre_mm(y_mm);
        const double r = radius_mm + std::copysign(dent_mm(radius_mm < 0.0, y_mm), radius_mm);
        const auto seen = render::project(camera_, width_px_, height_px_,
                                          {centre.x + r * right.x, y_mm, centre.y + r * right.y});
        if (!seen) return std::nullopt;
        return vec2(seen->pixel);
    }

  private:
    [[nodiscard]] dvec2 centre_mm(double y_mm) const {
        const std::size_t rings = pot_.top_mm.size();
        if (rings == 0 || pot_.centre_mm.size() != rings) return dvec2(0.0);
        const auto above = std::upper_bound(pot_.top_mm.begin(), pot_.top_mm.end(), static_cast<float>(y_mm));
        const auto ring = std::min(static_cast<std::size_t>(above - pot_.top_mm.begin()), rings - 1);
        const dvec2 own(pot_.centre_mm[ring]);
        const dvec2 turn = wheel_direction_;
        return {own.x * turn.x + own.y * turn.y, own.y * turn.x - own.x * turn.y};
    }
    // The dent moves both faces of the wall, which keeps its thickness: see pot::Pot::dents_mm.
    [[nodiscard]] double dent_mm(bool left, double y_mm) const {
        constexpr std::size_t kSectors = kDentSectors;
        const std::size_t rows = pot_.dents_mm.size() / kSectors;
        if (rows == 0 || !(pot_.height_mm > 0.0)) return 0.0;
        const double turned = std::atan2(wheel_direction_.y, wheel_direction_.x);
        const double turns = (towards_rad_ + (left ? kPi : 0.0) - turned) / kTurn;
        const auto place = [](double fraction, std::size_t count) {
            const double at = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count);
            return std::min(static_cast<std::size_t>(at), count - 1);
        };
        const std::size_t row = place(y_mm / pot_.height_mm, rows);
        return static_cast<double>(
            pot_.dents_mm[row * kSectors + place(turns - std::floor(turns), kSectors)]);
    }

    const pot::Pot& pot_;
    dvec2 wheel_direction_;
    const render::Camera& camera_;
    int width_px_;
    int height_px_;
    double towards_rad_;
};

// A measure in the picture: its line, and the place of its tag.
struct Tag {
    std::string words;
    vec2 from{0.0F};
    vec2 to{0.0F};
    vec2 leader{0.0F};  // start of its leader
    bool left = false;
    float y = 0.0F;  // of the tag's middle
};

std::optional<Tag> tag_of(const SectionMeasure& measure, const Section& section) {
    const double y = measure.height_mm;
    const double r = measure.outer_mm;
    const auto from =
        measure.of_floor ? section.pixel(-0.5 * r, 0.0) : section.pixel(r - measure.thickness_mm, y);
    const auto to = measure.of_floor ? section.pixel(-0.5 * r, measure.thickness_mm) : section.pixel(r, y);
    if (!from || !to) return std::nullopt;
    Tag tag{.words = words_of(measure), .from = *from, .to = *to, .leader = *to, .left = measure.of_floor};
    if (measure.of_floor) tag.leader = 0.5F * (*from + *to);
    tag.y = tag.leader.y;
    return tag;
}

// Moves tags, ordered from the top down, until none overlaps another, with small total displacement.
void spread(std::vector<Tag>& tags, float pitch, float lowest) {
    float moved = 0.0F;
    for (std::size_t i = 1; i < tags.size(); ++i) {
        const float y = std::max(tags[i].y, tags[i - 1].y + pitch);
        moved += y - tags[i].y;
        tags[i].y = y;
    }
    if (tags.empty()) return;
    const float back = std::max(moved / static_cast<float>(tags.size()), tags.back().y - lowest);
    for (Tag& tag : tags)
        tag.y -= back;
}

std::string line(vec2 from, vec2 to) {
    return fmt::format("M{:.2f} {:.2f} L{:.2f} {:.2f} ", from.x, from.y, to.x, to.y);
}

}  // namespace

ui::Sketch section_labels(const pot::Pot& pot, const dvec2& wheel_direction, const render::Camera& camera,
                          int width_px, int height_px, ui::Painter& painter) {
    const auto width = static_cast<float>(width_px);
    const auto height = static_cast<float>(height_px);
    ui::Sketch sketch{.size = {width, height}};
    const float scale = std::sqrt(width * height / (640.0F * 480.0F));
    if (scale * kTextPx < kLeastTextPx) return sketch;

    const Section section(pot, wheel_direction, camera, width_px, height_px);
    std::vector<Tag> walls;
    std::vector<Tag> floors;
    float rightmost = 0.0F;
    float leftmost = width;
    for (const SectionMeasure& measure : section_measures(pot)) {
        const auto tag = tag_of(measure, section);
        const auto far_side = section.pixel(-measure.outer_mm, measure.height_mm);
        if (!tag || !far_side) continue;
        (tag->left ? floors : walls).push_back(*tag);
        rightmost = std::max(rightmost, tag->to.x);
        leftmost = std::min(leftmost, far_side->x);
    }
    const float pitch = scale * (kTagHeightPx + kBetweenTagsPx);
    const float margin = scale * kMarginPx;
    spread(walls, pitch, height - margin - 0.5F * pitch);

    const ui::TextStyle style{.family = "NanumSquareRound, Noto Sans",
                              .bold = true,
                              .size = scale * kTextPx,
                              .line_height = scale * kTagHeightPx,
                              .colour = kInk,
                              .align = ui::Align::kCentre};
    float tag_width = 0.0F;
    for (const auto* tags : {&walls, &floors}) {
        for (const Tag& tag : *tags) {
            const float words = painter.measure({.words = tag.words, .style = style}).width;
            tag_width = std::max(tag_width, words + 2.0F * scale * kTagPaddingPx);
        }
    }
    const float right = std::min(rightmost + scale * kLeaderPx, width - margin - tag_width);
    const float left = std::max(leftmost - scale * kLeaderPx, margin + tag_width) - tag_width;

    for (const auto* tags : {&walls, &floors}) {
        for (const Tag& tag : *tags) {
            const ui::Rect box{tag.left ? left : right, tag.y - 0.5F * scale * kTagHeightPx, tag_width,
                               scale * kTagHeightPx};
            const vec2 across = tag.left ? vec2{scale * kTickPx, 0.0F} : vec2{0.0F, scale * kTickPx};
            const std::string lines = line(tag.from, tag.to) + line(tag.from - across, tag.from + across) +
                                      line(tag.to - across, tag.to + across) +
                                      line(tag.leader, {tag.left ? box.right() : box.x, tag.y});
            sketch.add(ui::Shape{.path = lines, .stroke = kPaper, .stroke_width = 3.2F * scale});
            sketch.add(ui::Shape{.path = lines, .stroke = kInk, .stroke_width = 1.2F * scale});
            sketch.add(ui::Shadow{.rect = box.moved({0.0F, scale}),
                                  .radius = 4.0F * scale,
                                  .blur = 3.0F * scale,
                                  .colour = kInk.with_alpha(0.35F)});
            sketch.add(ui::Box{.rect = box, .radius = 4.0F * scale, .fill = ui::Fill::flat(kPaper)});
            sketch.add(ui::Writing{
                .at = {box.x, box.y}, .text = {.words = tag.words, .style = style}, .box_width = tag_width});
        }
    }
    return sketch;
}

void lay_over(asset::Image& picture, const ui::Painting& painting) {
    if (painting.width != picture.width || painting.height != picture.height) return;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        const unsigned through = 255U - painting.rgba[i + 3];
        for (std::size_t c = i; c < i + 3; ++c)
            picture.rgba[c] =
                static_cast<std::uint8_t>(painting.rgba[c] + (picture.rgba[c] * through + 127U) / 255U);
    }
}

}  // namespace onggi::wheel
