// The moving picture: a window (or an offscreen target of the same size) that shows a pot on its wheel. It
// does not pace itself: the caller owns the clock. Main thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/render/overlay.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/health.h"
#include "engine/window/events.h"
#include "engine/window/gamepad.h"
#include "game/haptic/messages.h"
#include "game/wheel/wheel_scene.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

struct LiveViewOptions {
    int width = 1280;
    int height = 720;
    bool headless = false;  // draw into memory; no display needed
    bool full_screen = false;
    bool validation = false;
    bool paper = false;  // the paper's clay will be shown, with its ball
    bool plain =
        false;  // no photographed room or modelled tools, always lowest quality, a GPU only as a last resort
    int draw_threads = 1;  // for a software Vulkan device; sets the ladder's first step
    render::BackendChoice backend = render::BackendChoice::kAuto;
    std::string quality_note{};           // quality_note() of an earlier run; empty without one
    std::filesystem::path workshop = {};  // folder of a photographed room; empty: the installed one
    std::string title = "Onggi";
};

class LiveView {
  public:
    // Creates window, device and pipelines, and draws one warm-up frame with each, so that the first frame is
    // as fast as later ones. System lacks: no display (and not headless), no Vulkan device.
    static Result<std::unique_ptr<LiveView>> open(const LiveViewOptions& options);
    ~LiveView();
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    // Events of the window since the last call; when headless, the events from feed(). Call before draw.
    [[nodiscard]] std::vector<window::Event> poll_events();
    // For headless tests: the next poll_events() returns this event.
    void feed(const window::Event& event);
    // For headless tests: gamepads() returns these from now on.
    void feed(std::vector<window::Gamepad> pads);
    // State of the window system's gamepads at the last poll; when headless, those from feed().
    [[nodiscard]] std::vector<window::Gamepad> gamepads() const;
    // See window.h.
    [[nodiscard]] std::optional<window::Pen> pen() const;
    void keep_fingers(bool first, bool second);
    [[nodiscard]] bool close_requested() const;
    // The reason why a small still life is shown instead of the room; empty if the room is shown.
    [[nodiscard]] const std::string& workshop_lack() const;
    // The reason why fingers on a touch screen are not read; empty if they are, and when headless.
    [[nodiscard]] const std::string& touch_lack() const;
    void set_title(const std::string& title);
    void set_full_screen(bool full_screen);

    // Draws one frame, dt_s after the previous one; animations follow time, not frames. Recovers within the
    // call from a lost device, a lost surface or lack of memory, while the clay goes on elsewhere. Waits for
    // the previous frame to leave the device, and for no clock. Returns true if a frame was drawn; false
    // while the window is minimised or between two sizes. An overlay is drawn over the scene or instead of
    // it.
    Result<bool> draw(const haptic::Snapshot& snapshot, double dt_s = 1.0 / 60.0,
                      const render::Overlay* overlay = nullptr);

    // The rest of the picture besides the snapshot: view, evening, hands, tools and pots.
    [[nodiscard]] WheelScene& scene();

    // Sways the camera slowly from side to side while the wheel is idle. Needs the photographed room, and a
    // device that is fast enough for a moving camera, which a software device is not.
    void sway(bool sways);

    // Shares the drawing of large pictures with a second thread on these cores, see LiveScreen.
    Result<void> share_drawing(std::span<const int> cores);

    // Waits until the last frame has left the device; its duration is known only then.
    Result<void> wait();

    // Waits until the display has shown the last frame. Returns false if the display does not report this;
    // then pace by frame_rate_hz().
    bool wait_for_display();

    // The tool's place for a pointer at this pixel: on the upright plane through the wheel's axis that faces
    // the camera, mm. Empty if the pixel's ray misses that plane.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px) const;

    // The pixel of a place on the wheel; empty behind the eye.
    [[nodiscard]] std::optional<dvec2> project(const dvec3& place_mm) const;
    // The pixel of a place in a view with that framing; empty without the photographed room.
    [[nodiscard]] std::optional<dvec2> project_framed(View view, const Framing& framing,
                                                      const dvec3& place_mm) const;
    // Unit vector from that place to the eye.
    [[nodiscard]] dvec3 towards_eye(const dvec3& place_mm) const;

    [[nodiscard]] int width() const;  // current size of the target, pixels
    [[nodiscard]] int height() const;
    [[nodiscard]] const std::string& device_name() const;
    [[nodiscard]] int device_index() const;  // in the loader's order
    // Events since the last call for a person to read, one per line: a device that was lost and reopened, a
    // step of quality.
    [[nodiscard]] std::vector<std::string> take_remarks();
    [[nodiscard]] double frame_rate_hz() const;      // the best rate for draw()
    [[nodiscard]] std::string_view quality() const;  // "one software core"
    // One line: the device and the quality it reached. Pass it to the next run to start there.
    [[nodiscard]] std::string quality_note() const;
    [[nodiscard]] const render::FrameStats& frame_stats() const;
    // Whether frame_stats() lists the parts of a frame; costs a software device some per cent.
    void measure_parts(bool measures);
    // For tests: injected failures, and the number of recoveries.
    [[nodiscard]] vk::Health& device_health();
    [[nodiscard]] int mended() const;

    // For tests: the last frame, when headless.
    Result<asset::Image> read_back();

  private:
    struct Impl;
    explicit LiveView(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::wheel
