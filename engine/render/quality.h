// The quality ladder: how much detail a machine can draw in time, from one software core to a graphics card.
// The step follows the measured frame times, with hysteresis so that the picture does not flicker between
// steps. Pure; any thread; the caller supplies the time. ms, s.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/render/renderer.h"

namespace onggi::render {

// Two ladders in one list: the CPU backend's steps and the GPU's. A device stays on its own ladder.
enum class QualityStep {
    kSpare,          // a software core that is too slow or has too little memory for kOneCore
    kOneCore,        // one software core, 60 frames a second at 1280x720
    kTwoCores,       // finer outlines, for a processor with time to spare
    kSlowestGpu,     // one sample a pixel, half the resolution
    kSlowerGpu,      // one sample a pixel, three quarters of the resolution
    kSlowGpu,        // one sample a pixel
    kIntegratedGpu,  // four samples a pixel
    kDiscreteGpu,    // four samples, and the rings and sectors of a still
};
[[nodiscard]] std::string_view quality_name(QualityStep step);  // "one software core"
[[nodiscard]] std::optional<QualityStep> quality_named(std::string_view name);

// Whether a moving camera is drawn as quickly as a resting one. A software core is not: it keeps the room as
// drawn for one camera.
[[nodiscard]] constexpr bool has_time_for_moving_camera(QualityStep step) {
    return step >= QualityStep::kSlowestGpu;
}

// Returns the renderer's settings for a step, for a picture of this height.
[[nodiscard]] RendererDesc quality_desc(QualityStep step, VkFormat colour_format, int height_px);

// The steps of a device: the first, the lowest and the highest.
struct QualityRange {
    QualityStep first = QualityStep::kOneCore;
    QualityStep lowest = QualityStep::kSpare;
    QualityStep highest = QualityStep::kTwoCores;
    // A step is visible, so the ladder settles: it changes steps only while no visitor looks, except for one
    // change downwards in view of a visitor, and never retries a step that was too slow.
    bool settles = false;

    friend bool operator==(const QualityRange&, const QualityRange&) = default;
};
enum class DeviceClass { kSoftware, kIntegratedGpu, kDiscreteGpu };
// Which backend draws, independent of the machine's devices.
enum class BackendChoice {
    kAuto,  // the GPU if there is one; else the CPU backend
    kGpu,   // the Vulkan backend, even on a software device
    kCpu,   // the CPU backend
};
[[nodiscard]] std::string_view backend_choice_name(BackendChoice choice);  // "gpu"
[[nodiscard]] std::optional<BackendChoice> backend_choice_named(std::string_view name);
// Returns the class that `device` counts as under this choice.
[[nodiscard]] DeviceClass class_for(BackendChoice choice, DeviceClass device);
// threads: drawing threads of a software device, at least 1; ignored for a GPU.
[[nodiscard]] QualityRange quality_range(DeviceClass device, int threads);

class QualityLadder {
  public:
    explicit QualityLadder(const QualityRange& range, double frame_budget_ms = 1000.0 / 60.0)
        : range_(range),
          step_(range.first),
          budget_ms_(frame_budget_ms) {}

    [[nodiscard]] QualityStep step() const { return step_; }

    // Adds a frame: its drawing time, and the time since the previous frame. in_view: a visitor is looking at
    // it. Returns whether the step changed.
    bool frame(double drawn_ms, double dt_s, bool in_view = true);
    // Call while no visitor sees the scene, whether drawn or not. Applies the step that frame() postponed.
    // Returns whether the step changed.
    bool unseen();

    // Steps down because memory is short. False at the bottom of the ladder.
    bool step_down();

  private:
    bool go_to(QualityStep step);
    bool judge_what_settles(double slowest_tenth_ms, bool in_view);
    [[nodiscard]] QualityStep fitting_step(double drawn_ms) const;

    QualityRange range_;
    QualityStep step_;
    double budget_ms_;
    std::vector<double> window_ms_{};  // frame times since the last judgement
    double window_s_ = 0.0;
    int slow_windows_ = 0;
    double easy_s_ = 0.0;  // how long there has been time to spare
    // How long there must be time to spare before a step up; doubles with each step up that did not last.
    double patience_s_ = 5.0;
    double since_up_s_ = 1e9;
    std::optional<QualityStep> wanted_{};  // step to take when no visitor looks
    bool changed_in_view_ = false;         // a step was taken since a visitor began to look
};

}  // namespace onggi::render
