#include "game/wheel/live_view.h"

#include <fmt/format.h>

#include <variant>

#include "engine/jobs/thread_setup.h"
#include "engine/window/window.h"
#include "game/wheel/live_screen.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

struct LiveView::Impl {
    std::unique_ptr<window::Window> window;
    std::unique_ptr<LiveScreen> screen;  // destroyed before the window
    std::unique_ptr<WheelScene> scene;
    std::string workshop_lack;
    std::string touch_lack;
    std::vector<window::Event> fed;
    std::vector<window::Gamepad> fed_pads;
    bool close_requested = false;
    bool may_sway = false;

    BackgroundLoader backgrounds;
    window::Size backgrounds_for{};  // the picture size of the last request
    std::vector<std::string> remarks;

    [[nodiscard]] int width() const { return static_cast<int>(screen->extent().width); }
    [[nodiscard]] int height() const { return static_cast<int>(screen->extent().height); }
    Result<void> open(const LiveViewOptions& options);
    Result<bool> draw(const haptic::Snapshot& snapshot, double dt_s, const render::Overlay* overlay);
    void follow_shape();
};

Result<void> LiveView::Impl::open(const LiveViewOptions& options) {
    const window::WindowDesc desc{.width = options.width,
                                  .height = options.height,
                                  .title = options.title,
                                  .full_screen = options.full_screen};
    if (options.headless) {
        window = window::open_headless(desc);
    } else {
        auto opened = window::open_window(desc);
        if (!opened) return opened.error();
        window = std::move(*opened);
        remarks.push_back("window: on " + window->platform());
        if (std::string lack = window->why_no_touches(); !lack.empty())
            touch_lack = "window: no touch screen is read: " + std::move(lack);
    }
    auto made = LiveScreen::open(*window, {.size = {options.width, options.height},
                                           .validation = options.validation,
                                           .is_safe = options.plain,
                                           .draw_threads = options.draw_threads,
                                           .backend = options.backend,
                                           .quality_note = options.quality_note});
    if (!made) return made.error();
    screen = std::move(*made);

    OpenedScene opened = options.plain ? OpenedScene{std::make_unique<WheelScene>(), {}}
                                       : open_scene(options.workshop, width(), height());
    scene = std::move(opened.scene);
    workshop_lack = std::move(opened.lack);
    if (workshop_lack.empty() && !opened.note.empty()) workshop_lack = "room: not drawn: " + opened.note;
    backgrounds_for = {width(), height()};

    // The search for a device ran code of every driver; release its pages.
    jobs::give_back_code();
    // Drawing once compiles each pipeline: a lump with hands needs most of them, and one with a ball the
    // rest, if a ball will be shown.
    constexpr double kAboveMm = 260.0;
    pot::Pot lump;
    lump.outer_mm.assign(200, 60.0F);
    lump.height_mm = 200.0;
    pot::Pot with_tops = lump;
    for (std::size_t ring = 0; ring < lump.outer_mm.size(); ++ring)
        with_tops.top_mm.push_back(static_cast<float>(ring + 1));
    const bool has_ball = options.paper || !scene->has_tools();
    for (const bool with_hands : {true, false}) {
        if (!with_hands && !has_ball) continue;
        auto warmed =
            draw({.tool = {.position_mm = {0.0, kAboveMm, 0.0}}, .pot = with_hands ? &with_tops : &lump}, 0.0,
                 nullptr);
        if (!warmed) return warmed.error();
        if (auto waited = screen->wait(); !waited) return waited;
    }
    auto done = screen->wait();
    jobs::give_back_freed_memory();  // 40 MB of the driver's compiler
    jobs::give_back_code();
    return done;
}

// Another aspect ratio may need other backgrounds. Until they are loaded, the current ones are cropped to
// their middle.
void LiveView::Impl::follow_shape() {
    if (auto loaded = backgrounds.take()) {
        for (auto& [camera, background] : loaded->backgrounds)
            scene->add_background(camera, std::move(background));
        remarks.insert(remarks.end(), loaded->lacks.begin(), loaded->lacks.end());
        scene->drop_backgrounds_of_other_shapes(width(), height());
    }
    const bool is_same = backgrounds_for.width == width() && backgrounds_for.height == height();
    if (is_same || backgrounds.busy() || !scene->has_backgrounds()) return;
    backgrounds_for = {width(), height()};
    std::vector<BackgroundCamera> missing;
    for (const BackgroundCamera* camera : scene->missing_backgrounds(width(), height()))
        missing.push_back(*camera);
    if (missing.empty()) return;
    if (auto started = backgrounds.load(scene->workshop(), std::move(missing)); !started)
        remarks.push_back(started.error().message);
}

Result<bool> LiveView::Impl::draw(const haptic::Snapshot& snapshot, double dt_s,
                                  const render::Overlay* overlay) {
    if (width() == 0 || height() == 0) return false;
    follow_shape();
    scene->sway(may_sway && render::has_time_for_moving_camera(screen->quality()));
    auto drawn = screen->draw(scene->apply(snapshot, width(), height(), dt_s), overlay, dt_s, !may_sway);
    if (drawn && *drawn && screen->stats().next_view_ready) scene->next_view_is_ready();
    return drawn;
}

LiveView::LiveView(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveView::~LiveView() = default;

Result<std::unique_ptr<LiveView>> LiveView::open(const LiveViewOptions& options) {
    auto impl = std::make_unique<Impl>();
    if (auto opened = impl->open(options); !opened) return opened.error();
    return std::unique_ptr<LiveView>(new LiveView(std::move(impl)));
}

std::vector<window::Event> LiveView::poll_events() {
    std::vector<window::Event> events = impl_->window->poll_events();
    events.insert(events.end(), impl_->fed.begin(), impl_->fed.end());
    impl_->fed.clear();
    for (const window::Event& event : events) {
        if (const auto* resized = std::get_if<window::ResizeEvent>(&event)) {
            impl_->screen->resize({resized->width, resized->height});
        }
        if (std::holds_alternative<window::CloseEvent>(event)) impl_->close_requested = true;
    }
    return events;
}

void LiveView::feed(const window::Event& event) {
    impl_->fed.push_back(event);
}

void LiveView::feed(std::vector<window::Gamepad> pads) {
    impl_->fed_pads = std::move(pads);
}

std::vector<window::Gamepad> LiveView::gamepads() const {
    std::vector<window::Gamepad> pads = impl_->window->gamepads();
    pads.insert(pads.end(), impl_->fed_pads.begin(), impl_->fed_pads.end());
    return pads;
}

std::optional<window::Pen> LiveView::pen() const {
    return impl_->window->pen();
}

void LiveView::keep_fingers(bool first, bool second) {
    impl_->window->keep_fingers(first, second);
}

const std::string& LiveView::workshop_lack() const {
    return impl_->workshop_lack;
}

const std::string& LiveView::touch_lack() const {
    return impl_->touch_lack;
}

bool LiveView::close_requested() const {
    return impl_->close_requested;
}

void LiveView::set_title(const std::string& title) {
    impl_->window->set_title(title);
}

void LiveView::set_full_screen(bool full_screen) {
    impl_->window->set_full_screen(full_screen);
}

Result<bool> LiveView::draw(const haptic::Snapshot& snapshot, double dt_s, const render::Overlay* overlay) {
    auto drawn = impl_->draw(snapshot, dt_s, overlay);
    if (!drawn) return drawn;
    const std::vector<std::string>& messages = impl_->screen->messages();
    if (!messages.empty()) {
        return failed(fmt::format("Vulkan validation: expected no message, found {}, the first: {}",
                                  messages.size(), messages.front()));
    }
    return drawn;
}

WheelScene& LiveView::scene() {
    return *impl_->scene;
}

void LiveView::sway(bool sways) {
    impl_->may_sway = sways;
}

Result<void> LiveView::wait() {
    return impl_->screen->wait();
}

std::optional<dvec3> LiveView::tool_target_mm(double x_px, double y_px) const {
    return impl_->scene->tool_target_mm(x_px, y_px, width(), height());
}

std::optional<dvec2> LiveView::project(const dvec3& place_mm) const {
    const auto seen =
        render::project(impl_->scene->camera_now(width(), height()), width(), height(), place_mm);
    return seen ? std::optional<dvec2>(seen->pixel) : std::nullopt;
}

std::optional<dvec2> LiveView::project_framed(View view, const Framing& framing,
                                              const dvec3& place_mm) const {
    return impl_->scene->project_framed(view, framing, width(), height(), place_mm);
}

dvec3 LiveView::towards_eye(const dvec3& place_mm) const {
    return glm::normalize(dvec3(impl_->scene->camera_now(width(), height()).eye_mm) - place_mm);
}

int LiveView::width() const {
    return impl_->width();
}
int LiveView::height() const {
    return impl_->height();
}

const std::string& LiveView::device_name() const {
    return impl_->screen->device().description().name;
}

int LiveView::device_index() const {
    return impl_->screen->device().description().index;
}

std::vector<std::string> LiveView::take_remarks() {
    std::vector<std::string> remarks = impl_->screen->take_remarks();
    remarks.insert(remarks.end(), impl_->remarks.begin(), impl_->remarks.end());
    impl_->remarks.clear();
    return remarks;
}
std::string LiveView::quality_note() const {
    return impl_->screen->quality_note();
}
double LiveView::frame_rate_hz() const {
    return impl_->screen->frame_rate_hz();
}
Result<void> LiveView::share_drawing(std::span<const int> cores) {
    return impl_->screen->share_drawing(cores);
}
bool LiveView::wait_for_display() {
    return impl_->screen->wait_for_display();
}
std::string_view LiveView::quality() const {
    return render::quality_name(impl_->screen->quality());
}
const render::FrameStats& LiveView::frame_stats() const {
    return impl_->screen->stats();
}
void LiveView::measure_parts(bool measures) {
    impl_->screen->measure_parts(measures);
}
vk::Health& LiveView::device_health() {
    return impl_->screen->device().health();
}
int LiveView::mended() const {
    return impl_->screen->mended();
}

Result<asset::Image> LiveView::read_back() {
    auto pixels = impl_->screen->read_back();
    if (!pixels) return pixels.error();
    return asset::Image{.width = width(), .height = height(), .rgba = std::move(*pixels)};
}

}  // namespace onggi::wheel
