// The output of the moving picture: a window's surface or none, the Vulkan device, the target and the
// renderer; and recovery when the device is lost, memory runs out or the surface goes. Independent of pots.
// Main thread.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/frame_pacer.h"
#include "engine/jobs/shared_loop.h"
#include "engine/render/quality.h"
#ifdef ONGGI_SHADER_RELOAD
#include "engine/render/shader_reload.h"
#endif
#include "engine/render/upload_ledger.h"
#include "engine/vk/host_target.h"
#include "engine/vk/offscreen.h"
#include "engine/vk/swapchain.h"
#include "engine/window/window.h"

namespace onggi::wheel {

// The class of a device for the quality ladder.
[[nodiscard]] render::DeviceClass device_class(const vk::DeviceDescription& device);

struct LiveScreenOptions {
    window::Size size{1280, 720};  // of an offscreen target
    bool validation = false;
    // For a program that keeps crashing: stays at the lowest quality, and uses a GPU only if nothing else can
    // draw.
    bool is_safe = false;
    int draw_threads = 1;  // for a software device
    render::BackendChoice backend = render::BackendChoice::kAuto;
    std::string quality_note{};  // LiveScreen::quality_note() of an earlier run; empty without one
};

class LiveScreen {
  public:
    // The window must outlive the screen. If no device can present to the window, the screen draws offscreen
    // and adds a remark.
    static Result<std::unique_ptr<LiveScreen>> open(window::Window& window, const LiveScreenOptions& options);
    LiveScreen(const LiveScreen&) = delete;
    LiveScreen& operator=(const LiveScreen&) = delete;

    // Draws one frame, dt_s after the previous one. Recovers from a lost device, a lost surface or lack of
    // memory before it returns, on another device if the same one keeps failing; returns an error if that
    // does not help. has_visitor: a person is watching, so quality seldom changes.
    Result<bool> draw(const render::Scene& scene, const render::Overlay* overlay, double dt_s,
                      bool has_visitor = true);
    Result<void> wait();
    // Waits until the display has shown the last frame, if the display reports this and shows as many frames
    // as are drawn: then it is the frame clock. Returns false if it is not, or on timeout.
    bool wait_for_display();

    // Starts a second thread, on these cores, that shares the drawing of large pictures on a software device.
    // Does nothing if there is no core. Error: the thread cannot start.
    Result<void> share_drawing(std::span<const int> cores);

    void resize(window::Size size);
    [[nodiscard]] VkExtent2D extent() const { return target().extent(); }
    [[nodiscard]] const vk::Device& device() const { return *device_; }
    [[nodiscard]] const std::vector<std::string>& messages() const { return instance_->messages(); }
    [[nodiscard]] const render::FrameStats& stats() const { return renderer_->stats(); }
    // Measures the parts of a frame (FrameStats::parts); costs some per cent of a software device's time.
    void measure_parts(bool measures) {
        measures_parts_ = measures;
        renderer_->measure_parts(measures);
    }
    [[nodiscard]] render::QualityStep quality() const { return ladder_.step(); }
    // The frame rate that suits the display and the device.
    [[nodiscard]] double frame_rate_hz() const;
    // One line: the device and the quality it reached. Pass it to the next run to start there.
    [[nodiscard]] std::string quality_note() const;
    // The last frame; offscreen only.
    Result<std::vector<std::uint8_t>> read_back();

    // Events since the last call for a person to read, one per line.
    [[nodiscard]] std::vector<std::string> take_remarks();
    [[nodiscard]] int mended() const { return mended_; }

  private:
    LiveScreen(window::Window& window, const LiveScreenOptions& options);
    [[nodiscard]] vk::FrameTarget& target() const {
        if (swapchain_) return *swapchain_;
        if (host_) return *host_;
        return *offscreen_;
    }
    [[nodiscard]] vk::DevicePreference preference() const;
    Result<void> open_device();
    void begin_ladder();
    bool avoid_device();
    Result<void> open_target();
    bool open_host_target();
    Result<void> make_renderer();
    Result<void> make_anew();
    Result<bool> draw_once(const render::Scene& scene, const render::Overlay* overlay);
    Result<bool> mend(const Error& error, const render::Scene& scene, const render::Overlay* overlay);

    jobs::SharedLoop loop_;  // outlives the renderer
    window::Window* window_;
    LiveScreenOptions options_;
    render::QualityLadder ladder_;
    render::DeviceClass class_ = render::DeviceClass::kSoftware;  // class for the quality ladder
    int device_index_ = -1;                                       // index of the device; -1 before the first
    int ladder_of_ = -1;                                          // index of the ladder's device
    std::vector<int> avoided_;
    int losses_ = 0;  // losses of this device
    std::vector<std::string> remarks_;
    bool measures_parts_ = false;
    int mended_ = 0;
    int good_frames_ = 0;  // frames since the last recovery
    int in_a_row_ = 0;
    unsigned frames_of_renderer_ = 0;
    double host_ms_ = 0.0;  // processor time of the last frame
    jobs::DisplayBeat beat_;
    render::UploadLedger uploads_;  // of the overlay: a new renderer starts with an empty texture
    std::optional<Error> trouble_;  // found while waiting; the next draw recovers from it
#ifdef ONGGI_SHADER_RELOAD
    Result<void> follow_edited_shaders();
    render::ShaderReload shaders_{ONGGI_SHADER_RELOAD};
    int frames_unwatched_ = 0;
#endif
    // Members in the reverse of Vulkan's order of destruction.
    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Surface> surface_;
    std::unique_ptr<vk::Device> device_;
    std::unique_ptr<vk::Swapchain> swapchain_;  // only one of these three exists
    std::unique_ptr<vk::HostTarget> host_;
    std::unique_ptr<vk::Offscreen> offscreen_;
    std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace onggi::wheel
