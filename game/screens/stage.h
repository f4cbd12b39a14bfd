// Draws compositions frame by frame, with cross-fades, pressed tokens and fading cues, and finds the target
// under a finger. Main thread. Times are seconds of the caller's clock.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/ui/atlas.h"
#include "engine/ui/draw_list.h"
#include "game/screens/composer.h"
#include "game/screens/forces.h"
#include "game/screens/page/cue.h"

namespace onggi::screens {

struct StageFrame {
    double now_s = 0.0;
    int pressed = -1;            // target pressed by a finger
    const Band* band = nullptr;  // a warning's band on the pot; hides the cue
    const Cue* cue = nullptr;
    const ForceFrame* forces = nullptr;
};

class Stage {
  public:
    // Takes the composition if it is newer than the last.
    void take(std::shared_ptr<const Composed> composed, double now_s);
    // Takes the current pictures of the turning pots; ignores pots that are not on the stage.
    void turn(std::shared_ptr<const TurnedPots> pots) { turned_ = std::move(pots); }
    // The complete draw list of this frame. Valid until the next call.
    const ui::DrawList& draw(const StageFrame& frame);

    // Whether the scene is completely hidden in this frame.
    [[nodiscard]] bool covers() const { return covers_; }
    // Whether a screen that hides the scene is fading in or out; meanwhile the scene need not be redrawn.
    [[nodiscard]] bool scene_rests() const { return scene_rests_; }
    // The texture uploads of the last draw(), to be passed on with its list.
    [[nodiscard]] std::span<const ui::Atlas::Upload> uploads() const { return uploads_; }
    [[nodiscard]] int atlas_side_px() const { return atlas_.side_px(); }

    [[nodiscard]] const Composed* shown() const { return now_.get(); }
    // Returns the target under a pixel, or -1.
    [[nodiscard]] int target_at(vec2 px) const;
    [[nodiscard]] bool changes(double now_s) const;

  private:
    void fit_atlas();
    // The opacity of a composition, its remaining rise, and the part to draw.
    enum class Part { kAll, kAlike, kOthers };
    struct Fade {
        float alpha = 1.0F;
        float rise_u = 0.0F;
        Part part = Part::kAll;
    };
    void add(const Composed& composed, const StageFrame& frame, const Fade& fade);
    void add_changing(const StageFrame& frame, float fraction);
    void find_alike();
    // Fades the cue in or out.
    void follow_cue(const StageFrame& frame, double step_s);
    void add_guard_words(const Composition& composition);
    [[nodiscard]] std::optional<ui::Rect> place_of(const Item& item);
    [[nodiscard]] bool all_placed(const Composed& composed);

    ui::Atlas atlas_{ui::Atlas::side_px_for(0, 0)};
    std::vector<ui::Atlas::Upload> uploads_;
    ui::DrawList list_;
    // A turning pot alternates between two places in the atlas, so that a picture in use by a frame is never
    // overwritten.
    struct Turning {
        std::shared_ptr<const ui::Painting> shown;
        bool second = false;
    };
    std::unordered_map<std::uint64_t, Turning> turning_;
    std::shared_ptr<const TurnedPots> turned_;
    std::shared_ptr<const Composed> now_;
    std::shared_ptr<const Composed> before_;  // fading out
    // One entry per item: whether both compositions show it alike in the same place, so that it does not
    // fade.
    std::vector<char> alike_before_;
    std::vector<char> alike_now_;
    double since_s_ = 0.0;
    bool covers_ = false;
    bool scene_rests_ = false;
    Cue cue_;  // the cue shown last
    double cue_alpha_ = 0.0;
    double last_s_ = 0.0;
};

}  // namespace onggi::screens
