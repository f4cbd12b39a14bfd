#include "game/app/kiosk/presentation/kiosk_pot.h"

#include <algorithm>
#include <cmath>

#include "engine/ui/painter.h"
#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/clay/studio/load.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_parameters.h"
#include "game/finish/glaze.h"
#include "game/heritage/advice.h"
#include "game/heritage/jar.h"

namespace onggi::app {
namespace {

// The size of the lesson's moves for a kilogram; other lumps scale by the cube root of their mass.
constexpr double kPressedMm = 3.0;       // a foot narrower by this, or a lump higher by twice as much
constexpr double kOpenedMm = 18.0;       // from rim to floor
constexpr double kOpenedBoreMm = 24.0;   // in the middle of that depth, to the inner face
constexpr double kRaisedFraction = 1.4;  // of the height at the opening
constexpr double kRaisedMm = 75.0;       // or this height in any case
constexpr double kDrawnWallMm = 9.5;     // of a raised wall in the mean, for a kilogram
constexpr double kTallMm = 190.0;        // or so tall, however thick: a narrow opening lets no wall get thin
constexpr double kKilogramMm3 = 1000.0 / clay::studio::kDensityGPerMm3;

double volume_mm3(const pot::Pot& shape) {
    const auto& outer = shape.outer_mm;
    const auto& inner = shape.inner_mm;
    const auto& tops = shape.top_mm;
    const double even_mm = shape.height_mm / static_cast<double>(outer.size());
    double volume = 0.0;
    double below_mm = 0.0;
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const double top_mm = tops.empty() ? below_mm + even_mm : double{tops[i]};
        const double bore_mm = inner.empty() ? 0.0 : double{inner[i]};
        volume += kPi * (double{outer[i]} * double{outer[i]} - bore_mm * bore_mm) * (top_mm - below_mm);
        below_mm = top_mm;
    }
    return volume;
}

// Mean thickness of the wall, from a little above the floor to the rim; 0 for solid clay.
double mean_wall_mm(const pot::Pot& shape) {
    constexpr int kHeights = 16;
    constexpr double kFootFraction = 0.1;  // of the depth
    const double depth_mm = shape.height_mm - shape.floor_mm;
    if (is_solid(shape) || !(depth_mm > 0.0)) return 0.0;
    double sum = 0.0;
    for (int i = 0; i < kHeights; ++i) {
        const double fraction = kFootFraction + (1.0 - kFootFraction) * (i + 0.5) / kHeights;
        const pot::Wall wall = wall_at(shape, shape.floor_mm + fraction * depth_mm);
        sum += wall.outer_mm - wall.inner_mm;
    }
    return sum / kHeights;
}

}  // namespace

int Lesson::steps_done(const pot::Pot& shape) {
    if (shape.ring_count() <= 0) return done_;
    const auto& outer = shape.outer_mm;
    const double foot_mm = double{outer[outer.size() / 6]};
    const double height_mm = shape.height_mm;
    if (!has_start_) {
        has_start_ = true;
        start_height_mm_ = height_mm;
        start_foot_mm_ = foot_mm;
        size_ = std::cbrt(volume_mm3(shape) / kKilogramMm3);
    }
    const double bore_mm = wall_at(shape, 0.5 * (height_mm + shape.floor_mm)).inner_mm;
    const bool is_open = shape.can_be_hollow() && height_mm - shape.floor_mm > kOpenedMm * size_ &&
                         bore_mm >= kOpenedBoreMm * size_;
    if (is_open && opened_height_mm_ == 0.0) opened_height_mm_ = height_mm;
    const bool was_opened = opened_height_mm_ > 0.0;
    const bool pressed = start_foot_mm_ - foot_mm >= kPressedMm * size_ ||
                         height_mm - start_height_mm_ >= 2.0 * kPressedMm * size_;
    const bool is_drawn = mean_wall_mm(shape) <= kDrawnWallMm * size_ || height_mm >= kTallMm * size_;
    const bool raised = is_open && is_drawn &&
                        (height_mm > kRaisedFraction * opened_height_mm_ || height_mm >= kRaisedMm * size_);
    // Opening includes pressing, and raising includes both: a visitor who begins with a later move has done
    // the earlier ones.
    done_ = std::max(done_, raised ? 3 : was_opened ? 2 : pressed ? 1 : 0);
    return done_;
}

kiosk::Warning warning_for(clay::studio::Cause cause, double strength_kpa) {
    // Half the strength of fresh clay (13 kPa): clay twisted off by the hands was too soft below it, and
    // otherwise too thin.
    constexpr double kSoftKpa = 6.5;
    switch (cause) {
        case clay::studio::Cause::kSpin:
            return kiosk::Warning::kFast;
        case clay::studio::Cause::kTwist:
            return strength_kpa < kSoftKpa ? kiosk::Warning::kWet : kiosk::Warning::kThin;
        case clay::studio::Cause::kWeight:
        case clay::studio::Cause::kOverhang:
        case clay::studio::Cause::kNone:
            break;
    }
    return kiosk::Warning::kThin;
}

kiosk::Warning warning_of(const haptic::LoadReport& load, kiosk::Warning before) {
    const double limit =
        before == kiosk::Warning::kNone ? clay::studio::kWarnedLoad : clay::studio::kRelaxedLoad;
    return load.index < limit ? kiosk::Warning::kNone : warning_for(load.cause, load.strength_kpa);
}

double thinnest_wall_mm(const pot::Pot& shape) {
    double thinnest = 0.0;
    const auto& outer = shape.outer_mm;
    const auto& inner = shape.inner_mm;
    for (std::size_t i = 0; i < inner.size(); ++i) {
        if (inner[i] <= 0.0F) continue;
        const double wall = double{outer[i]} - double{inner[i]};
        if (thinnest == 0.0 || wall < thinnest) thinnest = wall;
    }
    return thinnest;
}

AcrossWall across_wall(const pot::Pot& shape) {
    constexpr double kFromMm = 6.0;  // above the floor, where a wall is thick by nature
    constexpr double kStepMm = 2.0;
    const double top_mm = shape.height_mm - kStepMm;  // above it is the round of the lip
    AcrossWall across;
    double sum_mm = 0.0;
    int count = 0;
    for (double y_mm = shape.floor_mm + kFromMm; !is_solid(shape) && y_mm < top_mm; y_mm += kStepMm) {
        const pot::Wall wall = wall_at(shape, y_mm);
        const pot::Wall low = wall_at(shape, y_mm - kStepMm);
        const pot::Wall high = wall_at(shape, y_mm + kStepMm);
        const double aside_mm = 0.5 * (high.outer_mm + high.inner_mm - low.outer_mm - low.inner_mm);
        const double lean = aside_mm / (2.0 * kStepMm);
        const double across_mm = (wall.outer_mm - wall.inner_mm) / std::hypot(1.0, lean);
        across.thickest_mm = std::max(across.thickest_mm, across_mm);
        sum_mm += across_mm;
        ++count;
    }
    if (count > 0) across.mean_mm = sum_mm / count;
    return across;
}

int thick_wall_mm(const pot::Pot& shape) {
    constexpr double kThickestMm = 15.0;  // for a kilogram
    constexpr double kMeanMm = 10.0;
    const AcrossWall across = across_wall(shape);
    const double size = std::cbrt(volume_mm3(shape) / kKilogramMm3);
    const bool is_thick = across.thickest_mm > kThickestMm * size || across.mean_mm > kMeanMm * size;
    return is_thick ? static_cast<int>(std::lround(across.thickest_mm)) : 0;
}

screens::FiredPot fired_pot(const clay::StudioClay& clay, const std::vector<heritage::Target>& targets,
                            const std::shared_ptr<const std::vector<screens::Exhibit>>& relatives,
                            std::optional<std::size_t> chosen) {
    const clay::ClayBody body = clay.lump().body;
    const clay::PotMeasures measures = clay::measure_pot(clay.rings(), body, clay::Firing::kGlaze);
    const heritage::PotForm form = heritage::form_of(clay);
    screens::FiredPot pot{.height_mm = measures.height_mm,
                          .width_mm = measures.widest_mm,
                          .weight_g = measures.mass_g,
                          .capacity_l = measures.capacity_ml / 1000.0};
    const double step_mm = form.height_mm / static_cast<double>(form.radii_mm.size() - 1);
    for (std::size_t i = 0; i < form.radii_mm.size(); ++i)
        pot.shape.outside.push_back(vec2(form.radii_mm[i], step_mm * static_cast<double>(i)));
    const double scale = clay::shrunk_scale(body, clay::Firing::kGlaze);
    for (auto point = pot.shape.outside.rbegin(); point != pot.shape.outside.rend(); ++point) {
        const double wet_y_mm = std::min(double{point->y} / scale, clay.height_mm() - 0.5);
        const double wall_mm = clay::wall_thickness_mm(clay.rings(), wet_y_mm) * scale;
        const double radius_mm = double{point->x} - wall_mm;
        if (radius_mm < 2.0 || double{point->y} < measures.floor_mm) break;
        pot.shape.inside.push_back(vec2(radius_mm, point->y));
    }
    if (!pot.shape.inside.empty()) {
        const auto floor_mm = static_cast<float>(measures.floor_mm);
        pot.shape.inside.push_back({0.6F * pot.shape.inside.back().x, floor_mm});
        pot.shape.inside.push_back({0.0F, floor_mm});
    }
    pot.shape.off_round = pot::off_round_of(clay.rings(), clay::shrunk_scale(body, clay::Firing::kGlaze));
    if (targets.empty() || !relatives || relatives->size() != targets.size()) return pot;
    pot.is_after_relative = chosen && *chosen < targets.size();
    const std::size_t beside = pot.is_after_relative ? *chosen : heritage::nearest(form, targets).target;
    const heritage::Target& target = targets[beside];
    const auto fraction =
        pot.is_after_relative ? std::optional(heritage::size_on_this_wheel(target).fraction) : std::nullopt;
    const heritage::Advice advice = heritage::advise(form, target, fraction);
    if (fraction) pot.off_outline_mm = heritage::profile_rms_mm(form, target, *fraction);
    pot.relative = {relatives, &(*relatives)[beside]};
    pot.good_key = heritage::good_key(advice);
    pot.next_key = heritage::next_key(advice);
    return pot;
}

ui::Painting portrait(const pot::Section& shape, int glaze, int side_px) {
    const auto side = static_cast<float>(side_px);
    const float scale = std::min(0.62F * side / std::max(1.0F, 2.0F * shape.radius_mm()),
                                 0.66F * side / std::max(1.0F, shape.height_mm()));
    screens::PotPicture pot =
        screens::paint_pot(shape, finish::glaze_at(glaze), scale, 0.2F, 0.0, screens::kLeavingSamples);
    ui::Sketch sketch;
    sketch.size = vec2(side);
    sketch.add(ui::Box{{0.0F, 0.0F, side, side}, 0.0F, ui::Fill::flat(ui::hex(0x281e16))});
    sketch.add(ui::Ellipse{{-0.35F * side, -0.45F * side, 1.7F * side, 1.8F * side},
                           ui::Fill::round(ui::hex(0x7d6750), ui::hex(0x281e16))});
    const vec2 foot(0.5F * side, 0.84F * side);
    const float reach = 1.5F * shape.radius_mm() * scale;
    sketch.add(ui::Ellipse{{foot.x - 0.8F * reach, foot.y - 0.1F * reach, 1.8F * reach, 0.24F * reach},
                           ui::Fill::round(ui::hex(0x0c0703, 0.7F), ui::hex(0x0c0703, 0.0F))});
    ui::Picture picture;
    picture.hash = shape.hash();
    picture.rect = {foot.x - pot.foot_px.x, foot.y - pot.foot_px.y, static_cast<float>(pot.painting.width),
                    static_cast<float>(pot.painting.height)};
    picture.painting = std::make_shared<const ui::Painting>(std::move(pot.painting));
    sketch.add(picture);
    return ui::Painter().paint(sketch);
}

}  // namespace onggi::app
