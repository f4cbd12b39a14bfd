#include "engine/render/quality.h"

#include <algorithm>
#include <utility>

namespace onggi::render {
namespace {

constexpr double kWindowS = 0.75;  // frame times are judged over this window
constexpr int kSlowWindows = 2;    // slow windows in a row before a step down
constexpr double kSlow = 0.92;     // fraction of the budget; the 90th percentile above it is too slow
// Fraction of the budget; below it there is time for the next step, which costs up to twice as much.
constexpr double kEasy = 0.45;
constexpr double kTriedS = 20.0;  // a step up that lasted this long was right
constexpr double kMostPatienceS = 600.0;

// The settings in which a GPU's steps differ from a still's.
struct GpuSteps {
    int samples = 4;
    float scale = 1.0F;
    int sectors = 0;
    int max_rings = kMaxRings;
    float ring_error_px = 0.0F;
};

RendererDesc gpu_desc(VkFormat colour_format, const GpuSteps& steps) {
    RendererDesc desc = still_desc(colour_format);
    desc.samples = steps.samples;
    desc.scale = steps.scale;
    desc.sectors = steps.sectors;
    desc.max_rings = steps.max_rings;
    desc.ring_error_px = steps.ring_error_px;
    return desc;
}

constexpr int index_of(QualityStep step) {
    return static_cast<int>(step);
}

constexpr QualityStep below(QualityStep step) {
    return static_cast<QualityStep>(index_of(step) - 1);
}
constexpr QualityStep above(QualityStep step) {
    return static_cast<QualityStep>(index_of(step) + 1);
}

// Relative cost of a frame on a GPU, 1 for the highest step: about half scales with samples and pixels, and
// some is constant.
double cost_of(QualityStep step) {
    switch (step) {
        case QualityStep::kSlowestGpu:
            return 0.25;
        case QualityStep::kSlowerGpu:
            return 0.4;
        case QualityStep::kSlowGpu:
            return 0.6;
        case QualityStep::kIntegratedGpu:
            return 0.95;
        default:
            return 1.0;
    }
}

}  // namespace

std::string_view quality_name(QualityStep step) {
    switch (step) {
        case QualityStep::kSpare:
            return "one slow software core";
        case QualityStep::kOneCore:
            return "one software core";
        case QualityStep::kTwoCores:
            return "two software cores";
        case QualityStep::kSlowestGpu:
            return "slowest GPU";
        case QualityStep::kSlowerGpu:
            return "slower GPU";
        case QualityStep::kSlowGpu:
            return "slow GPU";
        case QualityStep::kIntegratedGpu:
            return "integrated GPU";
        case QualityStep::kDiscreteGpu:
            return "discrete GPU";
    }
    return "";
}

std::optional<QualityStep> quality_named(std::string_view name) {
    for (int step = 0; step <= index_of(QualityStep::kDiscreteGpu); ++step) {
        if (quality_name(static_cast<QualityStep>(step)) == name) return static_cast<QualityStep>(step);
    }
    return std::nullopt;
}

std::string_view backend_choice_name(BackendChoice choice) {
    switch (choice) {
        case BackendChoice::kAuto:
            return "auto";
        case BackendChoice::kGpu:
            return "gpu";
        case BackendChoice::kCpu:
            return "cpu";
    }
    return "";
}

std::optional<BackendChoice> backend_choice_named(std::string_view name) {
    for (const BackendChoice choice : {BackendChoice::kAuto, BackendChoice::kGpu, BackendChoice::kCpu}) {
        if (backend_choice_name(choice) == name) return choice;
    }
    return std::nullopt;
}

DeviceClass class_for(BackendChoice choice, DeviceClass device) {
    if (choice == BackendChoice::kCpu) return DeviceClass::kSoftware;
    if (choice == BackendChoice::kGpu && device == DeviceClass::kSoftware) return DeviceClass::kIntegratedGpu;
    return device;
}

RendererDesc quality_desc(QualityStep step, VkFormat colour_format, int height_px) {
    RendererDesc software = live_desc(colour_format, true, height_px);
    switch (step) {
        case QualityStep::kSpare:
            software.sectors = software.sectors * 3 / 4;
            software.max_rings = software.max_rings * 2 / 3;
            software.ring_error_px *= 2.0F;
            software.sector_error_px *= 2.0F;
            return software;
        case QualityStep::kOneCore:
            return software;
        case QualityStep::kTwoCores:
            software.sectors = software.sectors * 5 / 4;
            software.max_rings = std::min(software.max_rings * 5 / 2, kMaxRings);
            software.ring_error_px *= 0.6F;
            software.sector_error_px *= 0.6F;
            return software;
        case QualityStep::kSlowestGpu:
            return gpu_desc(
                colour_format,
                {.samples = 1, .scale = 0.5F, .sectors = 72, .max_rings = 128, .ring_error_px = 0.25F});
        case QualityStep::kSlowerGpu:
            return gpu_desc(
                colour_format,
                {.samples = 1, .scale = 0.75F, .sectors = 84, .max_rings = 128, .ring_error_px = 0.25F});
        case QualityStep::kSlowGpu:
            return gpu_desc(colour_format,
                            {.samples = 1, .sectors = 96, .max_rings = 128, .ring_error_px = 0.25F});
        case QualityStep::kIntegratedGpu:
            return gpu_desc(colour_format, {.sectors = 128, .ring_error_px = 0.1F});
        case QualityStep::kDiscreteGpu:
            break;
    }
    return still_desc(colour_format);
}

QualityRange quality_range(DeviceClass device, int threads) {
    switch (device) {
        case DeviceClass::kIntegratedGpu:
            return {QualityStep::kIntegratedGpu, QualityStep::kSlowestGpu, QualityStep::kDiscreteGpu, true};
        case DeviceClass::kDiscreteGpu:
            return {QualityStep::kDiscreteGpu, QualityStep::kSlowestGpu, QualityStep::kDiscreteGpu, true};
        case DeviceClass::kSoftware:
            break;
    }
    const QualityStep highest = threads > 1 ? QualityStep::kTwoCores : QualityStep::kOneCore;
    return {highest, QualityStep::kSpare, QualityStep::kTwoCores};
}

bool QualityLadder::go_to(QualityStep step) {
    window_ms_.clear();
    window_s_ = 0.0;
    slow_windows_ = 0;
    easy_s_ = 0.0;
    wanted_.reset();
    if (step == step_) return false;
    step_ = step;
    return true;
}

bool QualityLadder::step_down() {
    if (step_ == range_.lowest) return false;
    if (range_.settles) range_.highest = below(step_);
    return go_to(below(step_));
}

// Returns the highest lower step that should be quick enough.
QualityStep QualityLadder::fitting_step(double drawn_ms) const {
    constexpr double kQuickEnough = 0.8;  // of the budget
    QualityStep step = below(step_);
    while (step != range_.lowest && drawn_ms * cost_of(step) > kQuickEnough * budget_ms_ * cost_of(step_))
        step = below(step);
    return step;
}

bool QualityLadder::judge_what_settles(double slowest_tenth_ms, bool in_view) {
    if (slow_windows_ >= kSlowWindows && step_ != range_.lowest) {
        range_.highest = below(step_);
        const QualityStep step = fitting_step(slowest_tenth_ms);
        if (in_view && std::exchange(changed_in_view_, true)) {
            wanted_ = step;
            return false;
        }
        return go_to(step);
    }
    if (easy_s_ >= patience_s_ && step_ != range_.highest) wanted_ = above(step_);
    return in_view ? false : unseen();
}

bool QualityLadder::unseen() {
    changed_in_view_ = false;
    return wanted_ ? go_to(*wanted_) : false;
}

bool QualityLadder::frame(double drawn_ms, double dt_s, bool in_view) {
    since_up_s_ += dt_s;
    window_ms_.push_back(drawn_ms);
    window_s_ += dt_s;
    if (window_s_ < kWindowS) return false;

    const auto tenth = static_cast<std::ptrdiff_t>(window_ms_.size() * 9 / 10);
    std::nth_element(window_ms_.begin(), window_ms_.begin() + tenth, window_ms_.end());
    const double slowest_tenth_ms = window_ms_[static_cast<std::size_t>(tenth)];
    const double judged_s = window_s_;
    window_ms_.clear();
    window_s_ = 0.0;

    slow_windows_ = slowest_tenth_ms > kSlow * budget_ms_ ? slow_windows_ + 1 : 0;
    easy_s_ = slowest_tenth_ms < kEasy * budget_ms_ ? easy_s_ + judged_s : 0.0;
    if (range_.settles) return judge_what_settles(slowest_tenth_ms, in_view);
    if (slow_windows_ >= kSlowWindows) {
        // Wait longer before retrying a step that had to be given up.
        if (since_up_s_ < kTriedS) patience_s_ = std::min(2.0 * patience_s_, kMostPatienceS);
        return step_down();
    }
    if (easy_s_ >= patience_s_ && step_ != range_.highest) {
        since_up_s_ = 0.0;
        return go_to(above(step_));
    }
    return false;
}

}  // namespace onggi::render
