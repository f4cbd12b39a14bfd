#include "game/wheel/live_view.h"

#include <fmt/format.h>

#include <array>
#include <variant>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "engine/vk/swapchain.h"
#include "engine/window/window.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {

// Members die in the reverse of this order, which is the order Vulkan asks for.
struct LiveView::Impl {
    std::unique_ptr<window::Window> window;
    std::unique_ptr<vk::Instance> instance;
    std::unique_ptr<vk::Surface> surface;  // null when headless
    std::unique_ptr<vk::Device> device;
    std::unique_ptr<vk::Swapchain> swapchain;  // one of these two
    std::unique_ptr<vk::Offscreen> offscreen;
    std::unique_ptr<render::Renderer> renderer;
    WheelScene scene;
    bool close_requested = false;

    [[nodiscard]] vk::FrameTarget& target() const {
        if (swapchain) return *swapchain;
        return *offscreen;
    }
    Result<void> open(const LiveViewOptions& options);
    Result<void> open_target(const LiveViewOptions& options);
    Result<void> make_renderer();
    Result<bool> draw(const PotView& pot);
};

namespace {

VkExtent2D extent_of(window::Size size) {
    return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
}

}  // namespace

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
    }
    auto made =
        vk::Instance::create({.validation = options.validation, .extensions = window->instance_extensions()});
    if (!made) return made.error();
    instance = std::move(*made);
    if (auto opened = open_target(options); !opened) return opened;
    if (auto renderer_made = make_renderer(); !renderer_made) return renderer_made;

    // Every pipeline is compiled by drawing with it once: a lump and a tool need all of them.
    std::array<float, 200> lump{};
    lump.fill(60.0F);
    auto warmed = draw({.radii_mm = lump});
    if (!warmed) return warmed.error();
    return target().wait();
}

Result<void> LiveView::Impl::open_target(const LiveViewOptions& options) {
    auto made_surface = window->create_surface(instance->handle());
    if (!made_surface) return made_surface.error();
    if (*made_surface != VK_NULL_HANDLE)
        surface = std::make_unique<vk::Surface>(instance->handle(), *made_surface);
    auto chosen = vk::choose_device(*instance, *made_surface);
    if (!chosen) return chosen.error();
    auto made_device = vk::Device::create(*instance, *chosen, surface != nullptr);
    if (!made_device) return made_device.error();
    device = std::move(*made_device);
    if (surface) {
        auto made = vk::Swapchain::create(*device, *surface, extent_of(window->size()));
        if (!made) return made.error();
        swapchain = std::move(*made);
    } else {
        auto made = vk::Offscreen::create(*device, extent_of({options.width, options.height}));
        if (!made) return made.error();
        offscreen = std::move(*made);
    }
    return {};
}

Result<void> LiveView::Impl::make_renderer() {
    const auto desc =
        render::live_desc(target().format(), device->is_cpu(), static_cast<int>(target().extent().height));
    auto made = render::Renderer::create(*device, desc);
    if (!made) return made.error();
    renderer = std::move(*made);
    return {};
}

Result<bool> LiveView::Impl::draw(const PotView& pot) {
    const VkExtent2D extent = target().extent();
    if (extent.width == 0 || extent.height == 0) return false;
    return renderer->draw(scene.apply(pot, static_cast<int>(extent.width), static_cast<int>(extent.height)),
                          target());
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
    for (const window::Event& event : events) {
        if (const auto* resized = std::get_if<window::ResizeEvent>(&event)) {
            if (impl_->swapchain) impl_->swapchain->resize(extent_of({resized->width, resized->height}));
        }
        if (std::holds_alternative<window::CloseEvent>(event)) impl_->close_requested = true;
    }
    return events;
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

Result<bool> LiveView::draw(const PotView& pot) {
    auto drawn = impl_->draw(pot);
    if (!drawn) return drawn;
    const std::vector<std::string>& messages = impl_->instance->messages();
    if (!messages.empty()) {
        return failed(fmt::format("Vulkan validation: expected no message, found {}, the first: {}",
                                  messages.size(), messages.front()));
    }
    return drawn;
}

Result<void> LiveView::wait() {
    return impl_->target().wait();
}

std::optional<dvec3> LiveView::tool_target_mm(double x_px, double y_px) const {
    return impl_->scene.tool_target_mm(x_px, y_px, width(), height());
}

int LiveView::width() const {
    return static_cast<int>(impl_->target().extent().width);
}
int LiveView::height() const {
    return static_cast<int>(impl_->target().extent().height);
}

const std::string& LiveView::device_name() const {
    return impl_->device->description().name;
}

Result<asset::Image> LiveView::read_back() {
    if (!impl_->offscreen) return failed("live view: expected an unseen target to read back, found a window");
    auto pixels = impl_->offscreen->read_back();
    if (!pixels) return pixels.error();
    return asset::Image{.width = width(), .height = height(), .rgba = std::move(*pixels)};
}

}  // namespace onggi::wheel
