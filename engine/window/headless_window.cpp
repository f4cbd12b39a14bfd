#include "engine/window/window.h"

namespace onggi::window {
namespace {

class HeadlessWindow final : public Window {
  public:
    explicit HeadlessWindow(const WindowDesc& desc) : size_{desc.width, desc.height} {}

    [[nodiscard]] std::vector<std::string> instance_extensions() const override { return {}; }
    Result<VkSurfaceKHR> create_surface(VkInstance) override { return VkSurfaceKHR{VK_NULL_HANDLE}; }
    [[nodiscard]] std::unique_ptr<vk::HostSurface> host_surface() override { return nullptr; }
    [[nodiscard]] std::vector<Event> poll_events() override { return {}; }
    [[nodiscard]] std::vector<Gamepad> gamepads() const override { return {}; }
    [[nodiscard]] std::optional<Pen> pen() const override { return std::nullopt; }
    void keep_fingers(bool, bool) override {}
    [[nodiscard]] bool close_requested() const override { return false; }
    [[nodiscard]] Size size() const override { return size_; }
    [[nodiscard]] double refresh_hz() const override { return 0.0; }
    [[nodiscard]] std::string platform() const override { return {}; }
    [[nodiscard]] std::string why_no_touches() const override { return {}; }
    void set_title(const std::string&) override {}
    void set_full_screen(bool) override {}

  private:
    Size size_;
};

}  // namespace

std::unique_ptr<Window> open_headless(const WindowDesc& desc) {
    return std::make_unique<HeadlessWindow>(desc);
}

}  // namespace onggi::window
