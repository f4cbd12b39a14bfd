#include "game/wheel/live_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "engine/jobs/clock.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/jobs/thread_setup.h"

namespace onggi::wheel {
namespace {

VkExtent2D extent_of(window::Size size) {
    return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
}

}  // namespace

render::DeviceClass device_class(const vk::DeviceDescription& device) {
    switch (device.type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return render::DeviceClass::kDiscreteGpu;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return render::DeviceClass::kSoftware;
        default:
            return render::DeviceClass::kIntegratedGpu;
    }
}

LiveScreen::LiveScreen(window::Window& window, const LiveScreenOptions& options)
    : window_(&window),
      options_(options),
      ladder_(render::QualityRange{}) {}

Result<std::unique_ptr<LiveScreen>> LiveScreen::open(window::Window& window,
                                                     const LiveScreenOptions& options) {
    std::unique_ptr<LiveScreen> self(new LiveScreen(window, options));
    auto made =
        vk::Instance::create({.validation = options.validation, .extensions = window.instance_extensions()});
    if (!made) return made.error();
    self->instance_ = std::move(*made);
    auto opened = self->make_anew();
    // A driver may fail where another driver works, so try the other devices.
    while (!opened && opened.error().kind != ErrorKind::kBadInput && self->avoid_device()) {
        self->remarks_.push_back(fmt::format("{}; trying another device", opened.error().message));
        opened = self->make_anew();
    }
    if (!opened) return opened.error();
    return self;
}

vk::DevicePreference LiveScreen::preference() const {
    return {.cpu_first = options_.backend == render::BackendChoice::kCpu,
            .avoided = avoided_,
            .avoids_gpus = options_.is_safe};
}

Result<void> LiveScreen::open_device() {
    auto made_surface = window_->create_surface(instance_->handle());
    if (!made_surface) return made_surface.error();
    if (*made_surface != VK_NULL_HANDLE)
        surface_ = std::make_unique<vk::Surface>(instance_->handle(), *made_surface);
    const std::string request = vk::device_request_of_environment();
    auto chosen = vk::choose_device(*instance_, *made_surface, request, preference());
    if (!chosen && surface_ && chosen.error().kind == ErrorKind::kSystemLacks) {
        // A device that cannot present may still draw: for the staff, for recordings, for a display attached
        // later.
        surface_.reset();
        auto unseen = vk::choose_device(*instance_, VK_NULL_HANDLE, request, preference());
        if (!unseen) return unseen.error();
        remarks_.push_back(
            fmt::format("{}; drawing offscreen on {}", chosen.error().message, unseen->description.name));
        chosen = std::move(unseen);
    }
    if (!chosen) return chosen.error();
    device_index_ = chosen->description.index;
    // A program that keeps crashing may crash in its driver, so it uses as few driver features as possible.
    const auto with_window = options_.is_safe ? vk::Presenting::kImages : vk::Presenting::kImagesInStep;
    auto made = vk::Device::create(*instance_, *chosen, surface_ ? with_window : vk::Presenting::kNone);
    if (!made) return made.error();
    device_ = std::move(*made);
#ifdef ONGGI_SHADER_RELOAD
    device_->replace_spirv(shaders_.replacements());
#endif
    begin_ladder();
    return {};
}

// Keeps the ladder's step if the same device is reopened.
void LiveScreen::begin_ladder() {
    if (ladder_of_ == device_index_) return;
    ladder_of_ = device_index_;
    losses_ = 0;
    const vk::DeviceDescription& device = device_->description();
    // A program that keeps crashing uses only the backend that suits this device.
    const auto choice = options_.is_safe ? render::BackendChoice::kAuto : options_.backend;
    class_ = render::class_for(choice, device_class(device));
    if (choice == render::BackendChoice::kGpu && device.is_cpu())
        remarks_.push_back(
            fmt::format("backend gpu: expected a GPU, found none; {} stands for one", device.name));
    render::QualityRange range = render::quality_range(class_, options_.draw_threads);
    if (options_.is_safe) range.first = range.highest = range.lowest;
    const std::string& note = options_.quality_note;
    const std::size_t tab = note.find('\t');
    if (tab != std::string::npos && note.substr(tab + 1) == device.name) {
        const auto step = render::quality_named(note.substr(0, tab));
        if (step && *step >= range.lowest && *step <= range.highest) range.first = *step;
    }
    ladder_ = render::QualityLadder(range, 1000.0 / frame_rate_hz());
}

double LiveScreen::frame_rate_hz() const {
    constexpr double kMostHz = 75.0;
    constexpr double kMostOnDiscreteGpuHz = 150.0;  // more is not visible, and heats the kiosk
    return jobs::frame_rate_hz(window_->refresh_hz(),
                               class_ == render::DeviceClass::kDiscreteGpu ? kMostOnDiscreteGpuHz : kMostHz);
}

std::string LiveScreen::quality_note() const {
    return fmt::format("{}\t{}", render::quality_name(ladder_.step()), device_->description().name);
}

// Avoids the current device. Returns false if no other device can draw.
bool LiveScreen::avoid_device() {
    const std::vector<int> before = avoided_;
    if (device_index_ < 0) return false;
    if (std::find(before.begin(), before.end(), device_index_) != before.end()) return false;
    avoided_.push_back(device_index_);
    const VkSurfaceKHR surface = surface_ ? surface_->handle() : VK_NULL_HANDLE;
    const auto other =
        vk::choose_device(*instance_, surface, vk::device_request_of_environment(), preference());
    if (other && other->description.index != device_index_) return true;
    avoided_ = before;
    return false;
}

// A software driver may send each picture to the X server through a socket
// (findings/lavapipe-sends-pictures-through-the-socket.sh), so the processor's pictures are shared with it.
// Returns false if they cannot be: then the driver's images serve.
bool LiveScreen::open_host_target() {
    const bool is_told = device_->wait_for_present() != nullptr;
    if (class_ != render::DeviceClass::kSoftware || is_told || device_->host_pointer_properties() == nullptr)
        return false;
    auto memory = window_->host_surface();
    if (!memory) return false;
    auto made = vk::HostTarget::create(*device_, std::move(memory), extent_of(window_->size()));
    if (made) host_ = std::move(*made);
    return host_ != nullptr;
}

Result<void> LiveScreen::open_target() {
    if (surface_) {
        if (open_host_target()) return {};
        auto made = vk::Swapchain::create(*device_, *surface_, extent_of(window_->size()));
        if (!made) return made.error();
        swapchain_ = std::move(*made);
    } else {
        auto made = vk::Offscreen::create(*device_, extent_of(options_.size));
        if (!made) return made.error();
        offscreen_ = std::move(*made);
    }
    return {};
}

Result<void> LiveScreen::make_renderer() {
    renderer_.reset();
    uploads_.lost();
    render::RendererDesc desc =
        render::quality_desc(ladder_.step(), target().format(), static_cast<int>(extent().height));
    desc.measures_parts = measures_parts_;
    desc.host_clock = jobs::ThreadClock::now_ns;
    if (desc.backend == render::Backend::kCpu) desc.loop = &loop_;
    auto made = render::Renderer::create(*device_, desc);
    if (!made) return made.error();
    renderer_ = std::move(*made);
    frames_of_renderer_ = 0;
    return {};
}

// Recreates everything but the instance. A surface belongs to the window and would survive, but is cheap to
// create.
Result<void> LiveScreen::make_anew() {
    renderer_.reset();
    swapchain_.reset();
    host_.reset();
    offscreen_.reset();
    device_.reset();
    surface_.reset();
    if (auto opened = open_device(); !opened) return opened;
    if (auto opened = open_target(); !opened) return opened;
    return make_renderer();
}

Result<bool> LiveScreen::mend(const Error& error, const render::Scene& scene,
                              const render::Overlay* overlay) {
    // A failure that comes back at once is permanent.
    constexpr int kSteadyFrames = 60;
    constexpr int kMostInARow = 3;
    // After this many losses another device takes over, if there is one.
    constexpr int kLossesInARow = 2;
    constexpr int kMostLosses = 5;
    Error last = error;
    in_a_row_ = good_frames_ >= kSteadyFrames ? 0 : in_a_row_;
    while (in_a_row_ < kMostInARow) {
        // Without a device, its creation failed; a retry may succeed after the driver restarts.
        const vk::Trouble trouble = device_ ? device_->health().trouble() : vk::Trouble::kLost;
        if (trouble == vk::Trouble::kNone) return last;
        ++in_a_row_;
        good_frames_ = 0;
        std::string remark = last.message;
        // If there is no lower step, another device may have memory, or this one after all of ours is freed.
        const bool is_too_much = trouble == vk::Trouble::kOutOfMemory && !ladder_.step_down();
        if (trouble == vk::Trouble::kLost) ++losses_;
        const bool fails_often =
            trouble == vk::Trouble::kLost && (in_a_row_ >= kLossesInARow || losses_ >= kMostLosses);
        if ((is_too_much || fails_often) && avoid_device()) in_a_row_ = 0;
        if (auto made = make_anew(); !made) {
            last = made.error();
            continue;
        }
        auto drawn = draw_once(scene, overlay);
        if (!drawn) {
            last = drawn.error();
            continue;
        }
        ++mended_;
        remarks_.push_back(fmt::format("{}; recreated on {}, quality: {}", remark,
                                       device_->description().name, render::quality_name(ladder_.step())));
        return drawn;
    }
    return last;
}

Result<bool> LiveScreen::draw_once(const render::Scene& scene, const render::Overlay* overlay) {
    if (overlay == nullptr) return renderer_->draw(scene, target(), nullptr);
    render::Overlay with_uploads = *overlay;
    with_uploads.uploads = uploads_.wanted();
    auto drawn = renderer_->draw(scene, target(), &with_uploads);
    if (drawn && *drawn) uploads_.done();
    return drawn;
}

#ifdef ONGGI_SHADER_RELOAD
// Polls twice a second, which is as often as an editor saves. A shader that does not compile is reported, and
// the picture stays.
Result<void> LiveScreen::follow_edited_shaders() {
    constexpr int kFramesBetween = 30;
    if (++frames_unwatched_ < kFramesBetween) return {};
    frames_unwatched_ = 0;
    const auto changed = shaders_.poll();
    if (!changed) remarks_.push_back(changed.error().message);
    if (!changed || !*changed) return {};
    if (auto waited = target().wait(); !waited) return waited;
    device_->replace_spirv(shaders_.replacements());
    remarks_.emplace_back("shaders: recompiled");
    return make_renderer();
}
#endif

Result<bool> LiveScreen::draw(const render::Scene& scene, const render::Overlay* overlay, double dt_s,
                              bool has_visitor) {
    if (overlay != nullptr) uploads_.bring(overlay->uploads, overlay->atlas_side_px);
    if (trouble_) {
        const Error found = *trouble_;
        trouble_.reset();
        return mend(found, scene, overlay);
    }
#ifdef ONGGI_SHADER_RELOAD
    if (auto followed = follow_edited_shaders(); !followed) return mend(followed.error(), scene, overlay);
#endif
    const double host_ms_before = std::exchange(host_ms_, 0.0);
    const std::int64_t began_ns = jobs::ThreadClock::now_ns();
    auto drawn = draw_once(scene, overlay);
    if (!drawn) return mend(drawn.error(), scene, overlay);
    if (!*drawn) return drawn;
    // A GPU keeps working while the processor waits for it or for its screen.
    host_ms_ = class_ == render::DeviceClass::kSoftware
                   ? static_cast<double>(jobs::ThreadClock::now_ns() - began_ns) * 1e-6
                   : renderer_->stats().host_ms;
    ++good_frames_;
    // A software driver compiles shaders in the first frames; after the last of these it has all it needs.
    // Code pages are released at each doubling of the frame count up to then.
    constexpr unsigned kCompiledFrames = 128;
    if (std::has_single_bit(++frames_of_renderer_) && frames_of_renderer_ <= kCompiledFrames) {
        jobs::give_back_code();
        if (frames_of_renderer_ == kCompiledFrames) jobs::give_back_freed_memory();
    }
    // A change of view costs a software core more than a static picture, for a moment, so it must not change
    // the quality. A screen that covers the scene is no reason to raise the quality.
    const render::FrameStats& stats = renderer_->stats();
    const bool changes_view = scene.next_view || scene.fade_in;
    const bool is_measured = stats.device_ms > 0.0 && stats.device_drew_scene && !changes_view;
    const bool in_view = has_visitor && (overlay == nullptr || !overlay->covers);
    const double drawn_ms = stats.device_ms + host_ms_before;
    // The ladder's times are real time: slow frames do not slow it down.
    const bool has_changed = is_measured ? ladder_.frame(drawn_ms, std::max(dt_s, 1e-3 * drawn_ms), in_view)
                                         : !in_view && ladder_.unseen();
    if (has_changed) {
        if (auto waited = target().wait(); !waited) return mend(waited.error(), scene, overlay);
        if (auto made = make_renderer(); !made) return mend(made.error(), scene, overlay);
        remarks_.push_back(
            fmt::format("picture: quality is now that of {}", render::quality_name(ladder_.step())));
    }
    return drawn;
}

Result<void> LiveScreen::wait() {
    auto waited = target().wait();
    if (waited || device_->health().trouble() == vk::Trouble::kNone) return waited;
    trouble_ = waited.error();
    return {};
}

bool LiveScreen::wait_for_display() {
    if (!swapchain_ || trouble_ || !swapchain_->awaits_showing()) return false;
    // If the display shows more frames than are drawn, it cannot be the frame clock.
    if (window_->refresh_hz() > frame_rate_hz()) return false;
    if (!beat_.is_asked(jobs::MonotonicClock::now_ns())) return false;
    constexpr std::uint64_t kMostNs = 100'000'000;  // several frames of the slowest display
    const auto shown = swapchain_->wait_until_shown(kMostNs);
    if (!shown && device_->health().trouble() != vk::Trouble::kNone) trouble_ = shown.error();
    if (shown && *shown)
        beat_.was_told();
    else
        beat_.was_not_told(jobs::MonotonicClock::now_ns());
    return shown && *shown;
}

Result<void> LiveScreen::share_drawing(std::span<const int> cores) {
    if (class_ != render::DeviceClass::kSoftware) return {};
    return loop_.start(cores, "picture");
}

void LiveScreen::resize(window::Size size) {
    target().resize(extent_of(size));
}

Result<std::vector<std::uint8_t>> LiveScreen::read_back() {
    if (!offscreen_) return failed("live view: expected an offscreen target to read back, found a window");
    return offscreen_->read_back();
}

std::vector<std::string> LiveScreen::take_remarks() {
    return std::exchange(remarks_, {});
}

}  // namespace onggi::wheel
