// The moving picture: a window (or an unseen target of the same size) that shows a pot on its wheel, as fast
// as it is asked to. It neither waits nor paces: the caller owns the 60 Hz. Main thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/window/events.h"
#include "game/wheel/pot_view.h"

namespace onggi::wheel {

struct LiveViewOptions {
    int width = 1280;
    int height = 720;
    bool headless = false;  // draw into memory; no display needed
    bool full_screen = false;
    bool validation = false;
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

    // What happened in the window since the last call; empty when headless. Call before draw.
    [[nodiscard]] std::vector<window::Event> poll_events();
    [[nodiscard]] bool close_requested() const;
    void set_title(const std::string& title);
    void set_full_screen(bool full_screen);

    // Draws one frame. It waits for the one before it to have left the device, and for no clock. True if a
    // frame was drawn; false while the window is minimised or between two sizes.
    Result<bool> draw(const PotView& pot);

    // Until the last frame has left the device: what a frame took is known only then.
    Result<void> wait();

    // Where a pointer at this pixel puts the tool: on the upright plane through the wheel's axis that faces
    // the camera, mm. Nothing when the pixel looks past that plane.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px) const;

    [[nodiscard]] int width() const;  // of the target now, pixels
    [[nodiscard]] int height() const;
    [[nodiscard]] const std::string& device_name() const;
    // The last frame drawn, when headless; for tests.
    Result<asset::Image> read_back();

  private:
    struct Impl;
    explicit LiveView(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::wheel
