// The scene for timing frames: the photographed workshop, a hollow pot whose outline changes every frame and
// turns, a hand outside and one inside, their shadows, a line of text, outlines smoothed; drawn into memory
// at a fixed step of quality. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/shared_loop.h"
#include "engine/render/quality.h"
#include "engine/ui/atlas.h"
#include "engine/ui/draw_list.h"
#include "engine/vk/offscreen.h"
#include "game/decoration/canvas.h"
#include "game/look/lathe_marks.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::bench {

struct FrameCaseDesc {
    int width = 1280;
    int height = 720;
    int grooves = 0;  // up the pot, 0.25 mm deep; 150 are a pixel each at 1280x720
    bool with_hands = true;
    bool with_text = true;
    bool is_drawn_on = false;  // by a finger through the wet coat, one point per frame
    bool is_modelled = false;  // the room is a model without photographs
    bool is_trimmed = false;   // shavings fly and lie about, and the rib is on the bench
    bool measures_parts = false;
    int second_thread_on = -1;  // the core of a second drawing thread; -1: none
    render::QualityStep step = render::QualityStep::kOneCore;
    std::optional<int> sectors{};  // otherwise the quality step's value at this size
    std::optional<int> max_rings{};
};

// The time of one frame.
struct FrameTime {
    double wall_s = 0.0;       // from the scene to a finished picture
    double processor_s = 0.0;  // of all threads of the process: depends less on other processes
};

class FrameCase {
  public:
    static Result<std::unique_ptr<FrameCase>> open(const FrameCaseDesc& desc);
    ~FrameCase();
    FrameCase(const FrameCase&) = delete;
    FrameCase& operator=(const FrameCase&) = delete;

    // Draws the next frame, a sixtieth of a second after the last, and waits for it. The overlay is a line of
    // text, or the given one.
    Result<FrameTime> frame(const render::Overlay* overlay = nullptr);

    [[nodiscard]] wheel::WheelScene& scene() { return *opened_.scene; }
    [[nodiscard]] const render::FrameStats& stats() const { return renderer_->stats(); }
    [[nodiscard]] bool view_changes() const { return view_changes_; }
    [[nodiscard]] bool light_changes() const { return light_changes_; }
    [[nodiscard]] const std::string& device_name() const { return device_->description().name; }
    [[nodiscard]] Result<asset::Image> read_back();

  private:
    explicit FrameCase(const FrameCaseDesc& desc) : desc_(desc) {}
    Result<void> create();
    void write_a_line();
    void throw_a_little();
    Result<void> draw_a_little();
    [[nodiscard]] haptic::Snapshot shown();

    FrameCaseDesc desc_;
    jobs::SharedLoop loop_;
    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Device> device_;
    std::unique_ptr<vk::Offscreen> target_;
    std::unique_ptr<render::Renderer> renderer_;
    wheel::OpenedScene opened_;
    ui::Atlas atlas_{1024};
    ui::DrawList list_;
    std::vector<ui::Atlas::Upload> uploads_;
    pot::Pot pot_;
    std::optional<decoration::Canvas> canvas_;  // if it is drawn on
    look::DressedMarks marks_;
    ecs::Entity on_wheel_;  // the pot, where it is drawn on
    std::int64_t number_ = 0;
    bool view_changes_ = false;
    bool light_changes_ = false;
    float key_level_ = 1.0F;
};

}  // namespace onggi::bench
