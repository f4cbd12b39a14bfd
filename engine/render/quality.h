// The quality ladder: how much of the picture a machine has time for, from one processor core that draws in
// software to a graphics card. Where it stands is decided by what frames really take, with patience, so that
// a picture does not change its mind. Pure; any thread; time comes from the caller. ms, s.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/render/renderer.h"

namespace onggi::render {

// Two ladders, one above the other: what the processor draws, and what a GPU does. No device leaves its own.
enum class QualityStep {
    kSpare,          // a software core that is too slow or too short of memory for the next
    kOneCore,        // one software core, 60 frames a second at 1280x720
    kTwoCores,       // finer outlines, for a processor that has time left
    kSlowestGpu,     // one sample a pixel, of a picture of half the size
    kSlowerGpu,      // of three quarters
    kSlowGpu,        // one sample a pixel
    kIntegratedGpu,  // four
    kDiscreteGpu,    // the same with as many rings and sectors as a still
};
[[nodiscard]] std::string_view quality_name(QualityStep step);  // "one software core"
[[nodiscard]] std::optional<QualityStep> quality_named(std::string_view name);

// Whether a camera on its way is drawn as quickly as one at rest: a software core keeps the room as one
// camera sees it.
[[nodiscard]] constexpr bool has_time_for_moving_camera(QualityStep step) {
    return step >= QualityStep::kSlowestGpu;
}

// What a step asks of the renderer, for a picture of this height.
[[nodiscard]] RendererDesc quality_desc(QualityStep step, VkFormat colour_format, int height_px);

// The steps of a device: where a ladder begins, and how far it may go each way.
struct QualityRange {
    QualityStep first = QualityStep::kOneCore;
    QualityStep lowest = QualityStep::kSpare;
    QualityStep highest = QualityStep::kTwoCores;
    // A step changes what is seen: it is changed while nobody looks, in view of a visitor once at most and
    // only downwards, and what was too slow once is not tried again.
    bool settles = false;

    friend bool operator==(const QualityRange&, const QualityRange&) = default;
};
enum class DeviceClass { kSoftware, kIntegratedGpu, kDiscreteGpu };
// Who is to draw, whatever the machine has.
enum class BackendChoice {
    kAuto,  // the device, where that is a GPU; else the processor
    kGpu,   // the device, be it software that stands for a GPU
    kCpu,   // the processor
};
[[nodiscard]] std::string_view backend_choice_name(BackendChoice choice);  // "gpu"
[[nodiscard]] std::optional<BackendChoice> backend_choice_named(std::string_view name);
// What a device counts as then.
[[nodiscard]] DeviceClass class_for(BackendChoice choice, DeviceClass device);
// threads: that a software device draws with, 1 or more; a GPU ignores it.
[[nodiscard]] QualityRange quality_range(DeviceClass device, int threads);

class QualityLadder {
  public:
    explicit QualityLadder(const QualityRange& range, double frame_budget_ms = 1000.0 / 60.0)
        : range_(range),
          step_(range.first),
          budget_ms_(frame_budget_ms) {}

    [[nodiscard]] QualityStep step() const { return step_; }

    // One frame more: what it took to draw, and how long after the one before it came. True if the step has
    // changed. in_view: a visitor looks at it.
    bool frame(double drawn_ms, double dt_s, bool in_view = true);
    // Nobody sees the scene now, drawn or not. True if the step has changed, as frame() would have liked
    // before.
    bool unseen();

    // There is no memory for this step. False at the bottom of the ladder.
    bool step_down();

  private:
    bool go_to(QualityStep step);
    bool judge_what_settles(double slowest_tenth_ms, bool in_view);
    [[nodiscard]] QualityStep fitting_step(double drawn_ms) const;

    QualityRange range_;
    QualityStep step_;
    double budget_ms_;
    std::vector<double> window_ms_{};  // of the frames since the last judgement
    double window_s_ = 0.0;
    int slow_windows_ = 0;
    double easy_s_ = 0.0;      // for how long there has been time to spare
    double patience_s_ = 5.0;  // of it before a step up; doubles with each that did not last
    double since_up_s_ = 1e9;
    std::optional<QualityStep> wanted_{};  // for when nobody looks
    bool changed_in_view_ = false;         // since somebody looks
};

}  // namespace onggi::render
