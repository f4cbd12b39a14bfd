// What a moving picture is drawn on: a window's surface or none, the Vulkan device, the target and the
// renderer; and what keeps them going when the device is lost, memory runs out or the surface goes. Nothing
// here knows pots. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/render/quality.h"
#ifdef ONGGI_SHADER_RELOAD
#include "engine/render/shader_reload.h"
#endif
#include "engine/render/upload_ledger.h"
#include "engine/vk/offscreen.h"
#include "engine/vk/swapchain.h"
#include "engine/window/window.h"

namespace onggi::wheel {

// What the quality ladder asks of a device.
[[nodiscard]] render::DeviceClass device_class(const vk::DeviceDescription& device);

struct LiveScreenOptions {
    window::Size size{1280, 720};  // of an unseen target
    bool validation = false;
    // Of a program that keeps falling: the lowest quality and never more, and no GPU where anything else
    // draws.
    bool is_safe = false;
    int draw_threads = 1;  // that a software device may use
    render::BackendChoice backend = render::BackendChoice::kAuto;
    std::string quality_note{};  // LiveScreen::quality_note() of an earlier one; empty: none
};

class LiveScreen {
  public:
    // The window must outlive it. Where no device presents to the window, it draws unseen, and says so in a
    // remark.
    static Result<std::unique_ptr<LiveScreen>> open(window::Window& window, const LiveScreenOptions& options);
    LiveScreen(const LiveScreen&) = delete;
    LiveScreen& operator=(const LiveScreen&) = delete;

    // Draws one frame, dt_s after the one before. What a lost device, a lost surface or want of memory break
    // is made anew before it returns, on another device where the same one fails again and again; an error is
    // left when that does not help. has_visitor: somebody is at the wheel, in whose view quality seldom
    // changes.
    Result<bool> draw(const render::Scene& scene, const render::Overlay* overlay, double dt_s,
                      bool has_visitor = true);
    Result<void> wait();
    // Until the display has shown the last frame, where it says so and shows as many frames as are drawn: its
    // beat is the clock to go by. False where it is not, or has not come.
    bool wait_for_display();

    void resize(window::Size size);
    [[nodiscard]] VkExtent2D extent() const { return target().extent(); }
    [[nodiscard]] const vk::Device& device() const { return *device_; }
    [[nodiscard]] const std::vector<std::string>& messages() const { return instance_->messages(); }
    [[nodiscard]] const render::FrameStats& stats() const { return renderer_->stats(); }
    // Which part of a frame takes how long: FrameStats::parts, at some per cent of a software device's time.
    void measure_parts(bool measures) {
        measures_parts_ = measures;
        renderer_->measure_parts(measures);
    }
    [[nodiscard]] render::QualityStep quality() const { return ladder_.step(); }
    // At which frames suit the display and whoever draws.
    [[nodiscard]] double frame_rate_hz() const;
    // One line: which device came to draw how well. Whoever keeps it begins there the next time.
    [[nodiscard]] std::string quality_note() const;
    // The last frame; only where it is unseen.
    Result<std::vector<std::uint8_t>> read_back();

    // What happened that somebody should read, a line each, since the last call.
    [[nodiscard]] std::vector<std::string> take_remarks();
    [[nodiscard]] int mended() const { return mended_; }

  private:
    LiveScreen(window::Window& window, const LiveScreenOptions& options);
    [[nodiscard]] vk::FrameTarget& target() const {
        if (swapchain_) return *swapchain_;
        return *offscreen_;
    }
    [[nodiscard]] vk::DevicePreference preference() const;
    Result<void> open_device();
    void begin_ladder();
    bool avoid_device();
    Result<void> open_target();
    Result<void> make_renderer();
    Result<void> make_anew();
    Result<bool> draw_once(const render::Scene& scene, const render::Overlay* overlay);
    Result<bool> mend(const Error& error, const render::Scene& scene, const render::Overlay* overlay);

    window::Window* window_;
    LiveScreenOptions options_;
    render::QualityLadder ladder_;
    render::DeviceClass class_ = render::DeviceClass::kSoftware;  // what the device counts as
    int device_index_ = -1;                                       // of the device; -1: none yet
    int ladder_of_ = -1;                                          // the device's the ladder is of
    std::vector<int> avoided_;
    int losses_ = 0;  // of this device
    std::vector<std::string> remarks_;
    bool measures_parts_ = false;
    int mended_ = 0;
    int good_frames_ = 0;  // since the last time something was mended
    int in_a_row_ = 0;
    unsigned frames_of_renderer_ = 0;
    double host_ms_ = 0.0;  // of the last frame: what the processor did for it
    jobs::DisplayBeat beat_;
    render::UploadLedger uploads_;  // of the overlay: a new renderer has an empty texture
    std::optional<Error> trouble_;  // found while waiting; the next draw mends it
#ifdef ONGGI_SHADER_RELOAD
    Result<void> follow_edited_shaders();
    render::ShaderReload shaders_{ONGGI_SHADER_RELOAD};
    int frames_unwatched_ = 0;
#endif
    // In the reverse of the order in which Vulkan wants them gone.
    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Surface> surface_;
    std::unique_ptr<vk::Device> device_;
    std::unique_ptr<vk::Swapchain> swapchain_;  // one of these two
    std::unique_ptr<vk::Offscreen> offscreen_;
    std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace onggi::wheel
