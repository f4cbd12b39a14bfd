// The moving picture: a window (or an unseen target of the same size) that shows a pot on its wheel, as fast
// as it is asked to. It does not pace: the caller owns the clock. Main thread only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
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
#include "game/wheel/framing.h"
#include "game/wheel/wheel_view.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

struct LiveViewOptions {
    int width = 1280;
    int height = 720;
    bool headless = false;  // draw into memory; no display needed
    bool full_screen = false;
    bool validation = false;
    bool paper = false;  // the paper's clay will be shown, and its ball with it
    bool plain =
        false;  // no photographed room, no modelled tools, the lowest quality for good, no GPU if it can be
    int draw_threads = 1;  // that a software Vulkan device may use: where the quality ladder begins
    render::BackendChoice backend = render::BackendChoice::kAuto;
    std::string quality_note{};           // quality_note() of an earlier run; empty: none
    std::filesystem::path workshop = {};  // folder of a photographed room; empty: the program's own
    std::string title = "Onggi";
};

class LiveView {
  public:
    // Window, device, pipelines, and one warm-up frame of each, so that the first frame is as quick as any.
    // System lacks: no display (and not headless), no Vulkan device.
    static Result<std::unique_ptr<LiveView>> open(const LiveViewOptions& options);
    ~LiveView();
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    // What happened in the window since the last call; when headless, what was fed. Call before draw.
    [[nodiscard]] std::vector<window::Event> poll_events();
    // A person at a window that nobody sees, for tests: poll_events() gives it next.
    void feed(const window::Event& event);
    // The gamepads of the window system, as they are since then; none when headless.
    [[nodiscard]] std::vector<window::Gamepad> gamepads() const;
    [[nodiscard]] bool close_requested() const;
    // Why the room is not shown but a small still life; empty: it is shown.
    [[nodiscard]] const std::string& workshop_lack() const;
    void set_title(const std::string& title);
    void set_full_screen(bool full_screen);

    // A device that is lost, a surface that goes and memory that runs out are mended within the call, while
    // the clay goes on elsewhere. Draws one frame, dt_s after the one before: what moves by itself eases in
    // time and not in frames. It waits for the one before it to have left the device, and for no clock. True
    // if a frame was drawn; false while the window is minimised or between two sizes. An overlay is laid over
    // the scene, or stands in its place.
    Result<bool> draw(const WheelView& shown, double dt_s = 1.0 / 60.0,
                      const render::Overlay* overlay = nullptr);

    // The camera goes to another view; it sways slowly while nobody throws; day becomes evening, 0 to 1. Each
    // takes about a second, and needs the photographed room; without it only the evening is seen. On a
    // processor, which has no time for a moving camera, it sways nowhere, and is cut to another view some
    // frames later, which fades in within a quarter of a second.
    void look_at(View view);
    void set_framing(const Framing& framing);
    void sway(bool sways);
    void move_less(bool less);  // for who asked for it: it is cut, and nothing fades
    void set_evening(double evening);
    // The next frame shows the camera where it is wanted: for while something else covers the scene.
    void jump();

    // Until the last frame has left the device: what a frame took is known only then.
    Result<void> wait();

    // Until the display has shown the last frame; false where it does not say so, and frames go by a clock of
    // frame_rate_hz().
    bool wait_for_display();

    // Where a pointer at this pixel puts the tool: on the upright plane through the wheel's axis that faces
    // the camera, mm. Nothing when the pixel looks past that plane.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px) const;

    // Where a place on the wheel is seen, pixels; nothing behind the eye.
    [[nodiscard]] std::optional<dvec2> project(const dvec3& place_mm) const;
    // Where it would be seen from a view framed so; nothing without the photographed room.
    [[nodiscard]] std::optional<dvec2> project_framed(View view, const Framing& framing,
                                                      const dvec3& place_mm) const;
    // The way from that place to the eye, unit length.
    [[nodiscard]] dvec3 towards_eye(const dvec3& place_mm) const;

    [[nodiscard]] int width() const;  // of the target now, pixels
    [[nodiscard]] int height() const;
    [[nodiscard]] const std::string& device_name() const;
    [[nodiscard]] int device_index() const;  // in the loader's order
    // What happened that somebody should read, a line each, since the last call: a device that was lost and
    // made anew, a step of quality.
    [[nodiscard]] std::vector<std::string> take_remarks();
    [[nodiscard]] double frame_rate_hz() const;      // at which draw() is best called
    [[nodiscard]] std::string_view quality() const;  // "one software core"
    // One line: which device came to draw how well. Whoever keeps it begins there the next time.
    [[nodiscard]] std::string quality_note() const;
    [[nodiscard]] const render::FrameStats& frame_stats() const;
    // Whether frame_stats() names the parts of a frame; costs a software device some per cent.
    void measure_parts(bool measures);
    // For tests: failures on purpose, and how often something was made anew after one.
    [[nodiscard]] vk::Health& device_health();
    [[nodiscard]] int mended() const;

    // The last frame drawn, when headless; for tests.
    Result<asset::Image> read_back();

  private:
    struct Impl;
    explicit LiveView(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::wheel
