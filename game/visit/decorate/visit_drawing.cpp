#include "game/visit/decorate/visit_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/jobs/thread_setup.h"
#include "game/visit/flow/step.h"

namespace onggi::visit {
namespace {

using decoration::Stroke;
using decoration::Technique;
using decoration::WallPlace;
using kiosk::Button;

const finish::MarkPalette& raw_palette() {
    return finish::wet_clay().marks;
}

// The widths of the ledge's brushes in three sizes, mm.
constexpr std::array<std::array<double, kiosk::kMostBrush>, kiosk::kMotifTool> kWidthsMm{
    {{14.0, 20.0, 28.0}, {2.2, 4.0, 7.0}, {2.2, 4.0, 7.0}, {1.2, 2.0, 3.2}, {12.0, 22.0, 36.0}}};
constexpr double kMotifOfWall = 0.34;

std::uint16_t width_units(double width_mm) {
    return static_cast<std::uint16_t>(std::clamp(width_mm * decoration::kWidthUnitsPerMm + 0.5,
                                                 double{decoration::kLeastWidth},
                                                 double{decoration::kMostWidth}));
}

Stroke motif_stroke(const kiosk::Decorating& decorating, double round_mm, double height_mm) {
    constexpr double kApart = 1.2;
    constexpr double kFewest = 3.0;
    constexpr double kMost = 6.0;
    Stroke stroke{.technique = Technique::kMotif,
                  .motif = static_cast<decoration::Motif>(decorating.motif + 1)};
    double size_mm = kMotifOfWall * height_mm;
    if (decorating.all_round) {
        const bool joins = stroke.motif == decoration::Motif::kWave;  // the waves touch each other
        const double count = std::clamp(std::floor(round_mm / (joins ? size_mm : kApart * size_mm)), kFewest,
                                        joins ? double{decoration::kMostRepeats} : kMost);
        stroke.repeats = static_cast<std::uint8_t>(count);
        size_mm = joins ? round_mm / count : std::min(size_mm, round_mm / count);
    }
    stroke.width = width_units(size_mm);
    return stroke;
}

// Draws the strokes on this pot's wall. If they do not fit the wall, it stays blank.
decoration::Canvas canvas_of(const pot::Pot& wet, const decoration::Strokes& strokes) {
    const decoration::Wall wall = decoration::wall_of(pot::outer_outline(wet));
    auto drawn_on = decoration::Canvas::of(wall, strokes);
    return drawn_on ? std::move(*drawn_on) : decoration::Canvas(wall);
}

}  // namespace

Stroke stroke_of(const kiosk::Decorating& decorating, double round_mm, double height_mm) {
    if (decorating.tool == kiosk::kMotifTool) return motif_stroke(decorating, round_mm, height_mm);
    const auto tool = static_cast<std::size_t>(decorating.tool);
    return {.technique = static_cast<Technique>(decorating.tool + 1),
            .slip = decorating.tool == kiosk::kInlayTool && decorating.black ? decoration::Slip::kBlack
                                                                             : decoration::Slip::kWhite,
            .width = width_units(kWidthsMm[tool][static_cast<std::size_t>(decorating.brush - 1)])};
}

VisitDrawing::Work::Work(const pot::Pot& wet, const decoration::Strokes& strokes)
    : Work(wet, canvas_of(wet, strokes)) {}

VisitDrawing::Work::Work(const pot::Pot& wet, decoration::Canvas drawn_on)
    : dry(pot::fired(wet, clay::Firing::kDry)),
      canvas(std::move(drawn_on)),
      scale(dry.height_mm / wet.height_mm) {
    dressed.dress(canvas.texture(), canvas.wall(), raw_palette());
    static_cast<void>(canvas.take_changed());
}

void VisitDrawing::forget() {
    remembered_.reset();
    forget_pot();
}

std::optional<std::vector<std::byte>> VisitDrawing::take_to_keep() {
    if (!is_to_be_kept_ || draws_ || !work_) return std::nullopt;
    is_to_be_kept_ = false;
    return decoration::bytes_of(work_->canvas.recorded());
}

void VisitDrawing::forget_pot() {
    release();
    pot_.reset();
    work_.reset();
    put_away_.clear();
    is_to_be_kept_ = false;
    hover_px_.reset();
    begun_ = brush_down_ = false;
    dot_rad_ = 0.0;
    dot_fraction_ = 0.5;
}

void VisitDrawing::take(std::shared_ptr<const pot::Pot> pot) {
    pot_ = std::move(pot);
    start_if_ready();
}

void VisitDrawing::begin(const dvec2& heading) {
    begun_ = true;
    turned_rad_ = std::atan2(heading.y, heading.x);
    start_if_ready();
}

void VisitDrawing::start_if_ready() {
    constexpr double kLeastMm = 3.0 * decoration::kMarginMm;
    if (!begun_ || work_ || !pot_ || pot_->ring_count() == 0 || pot_->height_mm < kLeastMm) return;
    if (auto canvas = remembered_canvas()) {
        work_ = std::make_shared<Work>(*pot_, std::move(*canvas));
    } else {
        work_ = std::make_shared<Work>(*pot_, std::exchange(put_away_, {}));
    }
    if (!work_->canvas.is_plain()) tell();
}

// The strokes belong to this pot if they reproduce the recorded hash of the texture.
std::optional<decoration::Canvas> VisitDrawing::remembered_canvas() {
    const auto drawn = std::exchange(remembered_, nullptr);
    if (!drawn || !put_away_.empty()) return std::nullopt;
    auto canvas = decoration::Canvas::of(decoration::wall_of(pot::outer_outline(*pot_)), drawn->strokes);
    if (!canvas || canvas->recorded() != *drawn) return std::nullopt;
    return std::move(*canvas);
}

void VisitDrawing::put_away() {
    release();
    put_away_ = work_->canvas.strokes();
    work_.reset();
    hover_px_.reset();
    begun_ = brush_down_ = false;
    jobs::give_back_freed_memory();
}

dvec2 VisitDrawing::heading() const {
    return {std::cos(turned_rad_), std::sin(turned_rad_)};
}

std::optional<WallPlace> VisitDrawing::place_at(vec2 px) const {
    const auto beside = view_.tool_target_mm(double{px.x}, double{px.y});
    if (!work_ || !beside) return std::nullopt;
    constexpr double kBackMm = 2000.0;  // starts the ray behind the camera
    const dvec3 towards_eye = view_.towards_eye(*beside);
    return decoration::pick(work_->canvas.wall(), work_->scale, heading(), *beside + kBackMm * towards_eye,
                            -towards_eye);
}

std::optional<WallPlace> VisitDrawing::place_of_dot() const {
    if (!work_) return std::nullopt;
    const dvec3 eye = view_.towards_eye({0.0, 0.5 * work_->dry.height_mm, 0.0});
    const double turns = (std::atan2(-eye.z, eye.x) + dot_rad_ - turned_rad_) / kTurn;
    return WallPlace{.turns = turns - std::floor(turns),
                     .height_mm = dot_fraction_ * double{work_->canvas.wall().height_mm},
                     .facing = std::cos(dot_rad_)};
}

void VisitDrawing::press(vec2 px) {
    release();
    put_brush(false);
    finger_px_ = px;
    hover_px_.reset();
    const auto place = place_at(px);
    if (!place) return;
    // A finger at the edge of a pot that stands still turns it.
    constexpr double kEdge = 0.3;
    turns_by_hand_ = !flow_.state().decorating.turns && place->facing < kEdge;
    if (turns_by_hand_) return;
    if (flow_.state().decorating.tool == kiosk::kMotifTool) {
        place_motif(*place);
    } else {
        draw_at(place);
    }
}

void VisitDrawing::drag(vec2 px) {
    if (!finger_px_) return;
    if (turns_by_hand_ && work_) {
        const float widest = *std::max_element(work_->dry.outer_mm.begin(), work_->dry.outer_mm.end());
        const auto left = view_.project({0.0, 0.5 * work_->dry.height_mm, 0.0});
        const auto right = view_.project({double{widest}, 0.5 * work_->dry.height_mm, 0.0});
        const double radius_px = left && right ? std::max(1.0, std::abs(right->x - left->x)) : 200.0;
        turned_rad_ += double{px.x - finger_px_->x} / radius_px;
    }
    finger_px_ = px;
}

void VisitDrawing::release() {
    finger_px_.reset();
    turns_by_hand_ = false;
    draws_ = false;
}

void VisitDrawing::hover(vec2 px) {
    if (!finger_px_) hover_px_ = px;
}

void VisitDrawing::nudge(Button way) {
    constexpr double kStepMm = 4.0;
    constexpr double kMostRad = 1.2;  // so that the dot stays visible
    if (!work_) return;
    hover_px_.reset();
    const double height_mm = double{work_->canvas.wall().height_mm};
    const double round_mm = double{work_->canvas.wall().round_at_along(
        work_->canvas.wall().along_at(static_cast<float>(dot_fraction_ * height_mm)))};
    const double step_rad = kTurn * kStepMm / round_mm;
    if (way == Button::kHandUp) dot_fraction_ += kStepMm / height_mm;
    if (way == Button::kHandDown) dot_fraction_ -= kStepMm / height_mm;
    if (way == Button::kHandLeft) dot_rad_ -= step_rad;
    if (way == Button::kHandRight) dot_rad_ += step_rad;
    const double margin = double{decoration::kMarginMm} / height_mm;
    dot_fraction_ = std::clamp(dot_fraction_, margin, 1.0 - margin);
    dot_rad_ = std::clamp(dot_rad_, -kMostRad, kMostRad);
    if (brush_down_) draw_at(place_of_dot());
}

void VisitDrawing::put_brush(bool down) {
    brush_down_ = false;
    if (!down) {
        draws_ = draws_ && finger_px_.has_value();
        return;
    }
    release();
    const auto place = place_of_dot();
    if (!place) return;
    if (flow_.state().decorating.tool == kiosk::kMotifTool) return place_motif(*place);
    brush_down_ = true;
    draw_at(place);
}

void VisitDrawing::undo() {
    release();
    if (!work_ || !work_->canvas.undo()) return;
    dress();
    tell();
}

void VisitDrawing::clear() {
    release();
    if (!work_ || !work_->canvas.begin({.technique = Technique::kClear})) return;
    dress();
    tell();
}

// Adds a point to the current stroke, or starts one; ends the stroke off the pot.
void VisitDrawing::draw_at(const std::optional<WallPlace>& place) {
    constexpr double kLeastMm = 0.25;  // minimum distance between two points
    if (!work_) return;
    const double height_mm = double{work_->canvas.wall().height_mm};
    const auto point = place ? std::optional(decoration::stroke_point(
                                   place->turns, std::clamp(place->height_mm, 0.0, height_mm)))
                             : std::nullopt;
    if (!point || !*point) {
        draws_ = false;
        return;
    }
    if (draws_) {
        const decoration::StrokePoint& last = work_->canvas.strokes().back().points.back();
        const double round_mm = double{work_->canvas.wall().round_at_along(
            work_->canvas.wall().along_at(static_cast<float>(place->height_mm)))};
        const double across =
            static_cast<std::int16_t>(static_cast<std::uint16_t>(point->value().turn - last.turn)) /
            decoration::kTurnUnits * round_mm;
        const double up = (int{point->value().height} - int{last.height}) / decoration::kHeightUnitsPerMm;
        if (std::hypot(across, up) < kLeastMm || !work_->canvas.add(point->value())) return;
        return dress();
    }
    Stroke stroke = stroke_of(flow_.state().decorating, 0.0, height_mm);
    stroke.points = {point->value()};
    draws_ = static_cast<bool>(work_->canvas.begin(stroke));
    if (!draws_) return;
    dress();
    tell();
}

void VisitDrawing::place_motif(const WallPlace& place) {
    const decoration::Wall& wall = work_->canvas.wall();
    const double height_mm = double{wall.height_mm};
    const double round_mm = double{wall.round_at_along(wall.along_at(static_cast<float>(place.height_mm)))};
    Stroke stroke = stroke_of(flow_.state().decorating, round_mm, height_mm);
    const auto point = decoration::stroke_point(place.turns, std::clamp(place.height_mm, 0.0, height_mm));
    if (!point) return;
    stroke.points = {*point};
    if (!work_->canvas.begin(stroke)) return;
    dress();
    tell();
}

void VisitDrawing::dress() {
    work_->dressed.dress_changed(work_->canvas.texture(), work_->canvas.wall(), raw_palette(),
                                 work_->canvas.take_changed());
}

void VisitDrawing::tell() {
    is_to_be_kept_ = true;
    flow_.dispatch(kiosk::event::Drawn{static_cast<int>(work_->canvas.strokes().size())});
}

void VisitDrawing::pass(double dt_s) {
    constexpr double kTurnS = 10.0;
    const kiosk::Screen screen = flow_.state().screen;
    if (screen == kiosk::Screen::kGlaze && work_) put_away();  // the pot is fired and keeps its texture
    if (open_finger(flow_.state()) != Finger::kBrush) {
        release();
        put_brush(false);
        return;
    }
    if (!work_) return;
    if (flow_.state().decorating.turns) turned_rad_ += kTurn * dt_s / kTurnS;
    if (flow_.state().decorating.tool == kiosk::kMotifTool) return;
    if (finger_px_ && !turns_by_hand_) draw_at(place_at(*finger_px_));
    if (brush_down_) draw_at(place_of_dot());
}

void VisitDrawing::show(wheel::WheelScene& scene) {
    if (!work_) return scene.registry().destroy(in_scene_);
    scene.put_on_wheel(in_scene_, {.pot = &work_->dry, .marks = &work_->dressed.marks()},
                       {.direction = heading()});
}

std::vector<vec2> VisitDrawing::ring(bool keys_lead) const {
    constexpr int kPoints = 40;
    constexpr double kLeastMm = 3.0;
    if (!work_ || finger_px_ || open_finger(flow_.state()) != Finger::kBrush) return {};
    const auto place = keys_lead ? place_of_dot() : hover_px_ ? place_at(*hover_px_) : std::nullopt;
    if (!place) return {};
    const decoration::Wall& wall = work_->canvas.wall();
    const double round_mm = double{wall.round_at_along(wall.along_at(static_cast<float>(place->height_mm)))};
    const Stroke stroke = stroke_of(flow_.state().decorating, round_mm, double{wall.height_mm});
    const double radius_mm = std::max(kLeastMm, 0.5 * stroke.width / decoration::kWidthUnitsPerMm);
    std::vector<vec2> ring;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = kTurn * i / kPoints;
        const auto px = view_.project(decoration::place_of(
            wall, work_->scale, heading(), place->turns + radius_mm * std::cos(angle) / round_mm,
            std::clamp(place->height_mm + radius_mm * std::sin(angle), 0.0, double{wall.height_mm})));
        if (!px) return {};
        ring.push_back(vec2(*px));
    }
    return ring;
}

std::shared_ptr<const decoration::Marks> VisitDrawing::marks() const {
    if (!work_ || work_->canvas.is_plain()) return nullptr;
    return std::make_shared<const decoration::Marks>(work_->canvas.marks());
}

finish::DrawnWith VisitDrawing::drawn_with() const {
    return work_ ? finish::drawn_with(work_->canvas.texture(), work_->canvas.strokes()) : finish::DrawnWith{};
}

}  // namespace onggi::visit
