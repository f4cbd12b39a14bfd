#include "tests/bench/frame_case.h"

#include <time.h>

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>

#include "engine/files/asset_folder.h"
#include "engine/jobs/clock.h"
#include "engine/ui/painter.h"
#include "game/finish/glaze.h"

namespace onggi::bench {
namespace {

constexpr std::size_t kRings = 2000;
constexpr double kHeightMm = 200.0;
constexpr double kFloorMm = 10.0;
constexpr double kWallMm = 5.0;
constexpr double kFrameS = 1.0 / 60.0;

double processor_now_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The wall's outer radius at a height: a belly, and throwing rings of 0.3 mm.
double outer_at(double y_mm) {
    const double belly = (y_mm - 70.0) / 52.0;
    return 32.0 + 24.0 * std::exp(-belly * belly) +
           0.3 * std::sin(y_mm * 0.78 + 2.3 * std::sin(y_mm * 0.026));
}

}  // namespace

Result<std::unique_ptr<FrameCase>> FrameCase::open(const FrameCaseDesc& desc) {
    std::unique_ptr<FrameCase> self(new FrameCase(desc));
    if (auto created = self->create(); !created) return created.error();
    // Pipelines are compiled by the first draw with each; hands need half a second to come.
    constexpr int kFramesToSettle = 60;
    for (int frame = 0; frame < kFramesToSettle; ++frame) {
        if (auto drawn = self->frame(); !drawn) return drawn.error();
    }
    return self;
}

FrameCase::~FrameCase() = default;

Result<void> FrameCase::create() {
    auto drawn_by = vk::OffscreenDevice::open();
    if (!drawn_by) return drawn_by.error();
    instance_ = std::move(drawn_by->instance);
    device_ = std::move(drawn_by->device);
    auto target = vk::Offscreen::create(
        *device_, {static_cast<std::uint32_t>(desc_.width), static_cast<std::uint32_t>(desc_.height)});
    if (!target) return target.error();
    target_ = std::move(*target);
    render::RendererDesc desc = render::quality_desc(desc_.step, vk::Offscreen::kFormat, desc_.height);
    desc.measures_parts = desc_.measures_parts;
    desc.host_clock = jobs::ThreadClock::now_ns;
    if (desc_.second_thread_on >= 0) {
        if (auto started = loop_.start(std::span(&desc_.second_thread_on, 1), "picture"); !started)
            return started;
        desc.loop = &loop_;
    }
    desc.sectors = desc_.sectors.value_or(desc.sectors);
    desc.max_rings = desc_.max_rings.value_or(desc.max_rings);
    auto renderer = render::Renderer::create(*device_, desc);
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    std::filesystem::path room;
    if (desc_.is_modelled) {
        auto found = files::find_asset("workshop");
        if (!found) return found.error();
        room = *found / "room.glb";
    }
    opened_ = wheel::open_scene(room, desc_.width, desc_.height);
    if (!opened_.lack.empty()) return system_lacks(opened_.lack);

    for (std::size_t i = 0; i < kRings; ++i) {
        pot_.top_mm.push_back(static_cast<float>((static_cast<double>(i) + 1.0) * kHeightMm / kRings));
        pot_.film.push_back(0.7F);
        pot_.liquidity.push_back(0.6F);
    }
    pot_.height_mm = kHeightMm;
    pot_.floor_mm = kFloorMm;
    pot_.outer_mm.resize(kRings);
    pot_.inner_mm.resize(kRings);
    write_a_line();
    return {};
}

// One line of text near the top, as on the throwing screen.
void FrameCase::write_a_line() {
    ui::Painter painter;
    const float px_per_u = static_cast<float>(desc_.height) / 720.0F;
    ui::Writing writing{.at = {0.0F, 0.0F},
                        .text = {.words = "Press with both hands and bring the wall up.", .style = {}}};
    writing.text.style.colour = ui::hex(0xF4ECE0);
    const ui::TextSize size = painter.measure(writing.text);
    ui::Sketch sketch{.size = {size.width, size.height}, .px_per_u = px_per_u};
    sketch.add(writing);
    const auto painting = std::make_shared<const ui::Painting>(painter.paint(sketch));
    const auto place = atlas_.place(sketch.hash(), painting);
    uploads_ = atlas_.take_uploads();
    if (!place) return;
    const vec2 corner(0.5F * (static_cast<float>(desc_.width) - place->width), 40.0F * px_per_u);
    list_.add_picture(corner, *place, 1.0F);
}

// The pot shrinks slightly each frame and grows back.
void FrameCase::throw_a_little() {
    const double breath = 0.2 * std::sin(0.1 * static_cast<double>(number_));
    const double groove_rad_per_mm = 2.0 * std::numbers::pi * desc_.grooves / kHeightMm;
    for (std::size_t i = 0; i < kRings; ++i) {
        const double y_mm = (static_cast<double>(i) + 0.5) * kHeightMm / kRings;
        const double radius_mm = outer_at(y_mm) + 0.25 * std::sin(groove_rad_per_mm * y_mm) + breath;
        pot_.outer_mm[i] = static_cast<float>(radius_mm);
        pot_.inner_mm[i] = y_mm < kFloorMm ? 0.0F : static_cast<float>(radius_mm - kWallMm);
    }
    ++number_;
}

// A band that goes round the pot and climbs; when it is complete the next one begins.
Result<void> FrameCase::draw_a_little() {
    constexpr int kPointsInAStroke = 600;
    constexpr std::uint16_t kWidth = 2000;  // 20 mm
    if (!canvas_) {
        const std::vector<vec2> outline{{56.0F, 0.0F}, {56.0F, static_cast<float>(kHeightMm)}};
        canvas_.emplace(decoration::wall_of(outline));
        marks_.dress(canvas_->texture(), canvas_->wall(), finish::wet_clay().marks);
        static_cast<void>(canvas_->take_changed());
    }
    const auto point = decoration::stroke_point(0.004 * static_cast<double>(number_),
                                                60.0 + 60.0 * std::sin(0.01 * static_cast<double>(number_)));
    if (!point) return point.error();
    const bool begins = canvas_->is_plain() || number_ % kPointsInAStroke == 0;
    if (begins && !canvas_->is_plain()) canvas_->undo();
    const auto drawn =
        begins ? canvas_->begin(
                     {.technique = decoration::Technique::kFinger, .width = kWidth, .points = {*point}})
               : canvas_->add(*point);
    if (!drawn) return drawn.error();
    marks_.dress_changed(canvas_->texture(), canvas_->wall(), finish::wet_clay().marks,
                         canvas_->take_changed());
    return {};
}

haptic::Snapshot FrameCase::shown() {
    constexpr double kHandMm = 10.0;
    const double angle = 0.2 * static_cast<double>(number_);
    const double height_mm = 110.0 + 30.0 * std::sin(0.02 * static_cast<double>(number_));
    const double wall_mm = outer_at(height_mm);
    constexpr double kTurnsRadS = 12.0;
    wheel::WheelScene& wheel = *opened_.scene;
    wheel.lead_hands(
        std::array{wheel::DrawnHand{.position_mm = {wall_mm + kHandMm, height_mm, 0.0},
                                    .radius_mm = kHandMm,
                                    .tool = desc_.is_trimmed ? tool::Tool::kTrimmer : tool::Tool::kHand,
                                    .side = tool::Side::kOut,
                                    .shown = desc_.with_hands,
                                    .touching = true},
                   wheel::DrawnHand{.position_mm = {wall_mm - kWallMm - kHandMm, height_mm, 0.0},
                                    .radius_mm = kHandMm,
                                    .side = tool::Side::kIn,
                                    .shown = desc_.with_hands,
                                    .touching = true,
                                    .is_second = true}});
    if (desc_.is_trimmed) {
        wheel.shave(wheel::Shavings::kCurlMm3 * static_cast<double>(number_), {wall_mm, height_mm, 0.0});
        wheel.lay_on_bench(tool::Tool::kRib, true);
    }
    if (canvas_) wheel.put_on_wheel(on_wheel_, {.pot = &pot_, .marks = &marks_.marks()});
    return {.wheel_direction = {std::cos(angle), std::sin(angle)},
            .wheel_turning = true,
            .wheel_speed_rad_s = kTurnsRadS,
            .pot = &pot_};
}

Result<FrameTime> FrameCase::frame(const render::Overlay* overlay) {
    throw_a_little();
    const double processor_s = processor_now_s();
    const auto start = std::chrono::steady_clock::now();
    if (desc_.is_drawn_on) {
        if (auto drawn = draw_a_little(); !drawn) return drawn.error();
    }
    const haptic::Snapshot moment = shown();
    const render::Scene& scene = opened_.scene->apply(moment, desc_.width, desc_.height, kFrameS);
    view_changes_ = scene.next_view || scene.fade_in;
    light_changes_ = scene.levels.key != key_level_;
    key_level_ = scene.levels.key;
    const render::Overlay line{
        .list = &list_, .uploads = uploads_, .atlas_side_px = atlas_.side_px(), .covers = false};
    if (overlay == nullptr && desc_.with_text) overlay = &line;
    const auto drawn = renderer_->draw(scene, *target_, overlay);
    if (!drawn) return drawn.error();
    if (!*drawn) return failed("frame: expected one to be drawn, found none");
    if (auto waited = target_->wait(); !waited) return waited.error();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    if (renderer_->stats().next_view_ready) opened_.scene->next_view_is_ready();
    uploads_.clear();
    return FrameTime{.wall_s = wall.count(), .processor_s = processor_now_s() - processor_s};
}

Result<asset::Image> FrameCase::read_back() {
    auto pixels = target_->read_back();
    if (!pixels) return pixels.error();
    return asset::Image{.width = desc_.width, .height = desc_.height, .rgba = std::move(*pixels)};
}

}  // namespace onggi::bench
