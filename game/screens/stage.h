// Puts compositions on the screen frame by frame: cross-fades, tokens that sink, cues that come and go; and
// says what lies under a finger. Main thread. Times are seconds of the caller's clock.
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
    int pressed = -1;            // target that a finger holds down
    const Band* band = nullptr;  // a warning's place on the pot; it hides a cue
    const Cue* cue = nullptr;
    const ForceFrame* forces = nullptr;
};

class Stage {
  public:
    // Takes a newer composition, if it is newer.
    void take(std::shared_ptr<const Composed> composed, double now_s);
    // The pots that turn, as they stand now; what is not on the stage is left out.
    void turn(std::shared_ptr<const TurnedPots> pots) { turned_ = std::move(pots); }
    // All of this frame. Good until the next call.
    const ui::DrawList& draw(const StageFrame& frame);

    // Nothing of the scene is seen this frame.
    [[nodiscard]] bool covers() const { return covers_; }
    // A screen that covers all is on its way in or out: whoever draws the scene may let it stand still.
    [[nodiscard]] bool scene_rests() const { return scene_rests_; }
    // What the last draw() needs in the texture; to be handed on with it.
    [[nodiscard]] std::span<const ui::Atlas::Upload> uploads() const { return uploads_; }
    [[nodiscard]] int atlas_side_px() const { return atlas_.side_px(); }

    [[nodiscard]] const Composed* shown() const { return now_.get(); }
    // The target under a pixel; -1: none.
    [[nodiscard]] int target_at(vec2 px) const;
    [[nodiscard]] bool changes(double now_s) const;

  private:
    void fit_atlas();
    // How much of a composition is seen, how far it still has to rise, and which part of it is drawn.
    enum class Part { kAll, kAlike, kOthers };
    struct Fade {
        float alpha = 1.0F;
        float rise_u = 0.0F;
        Part part = Part::kAll;
    };
    void add(const Composed& composed, const StageFrame& frame, const Fade& fade);
    void add_changing(const StageFrame& frame, float fraction);
    void find_alike();
    // The cue comes, stays or goes.
    void follow_cue(const StageFrame& frame, double step_s);
    void add_guard_words(const Composition& composition);
    [[nodiscard]] std::optional<ui::Rect> place_of(const Item& item);
    [[nodiscard]] bool all_placed(const Composed& composed);

    ui::Atlas atlas_{ui::Atlas::side_px_for(0, 0)};
    std::vector<ui::Atlas::Upload> uploads_;
    ui::DrawList list_;
    // Of a pot that turns: two places take turns, so that no picture is changed that a frame is drawn from.
    struct Turning {
        std::shared_ptr<const ui::Painting> shown;
        bool second = false;
    };
    std::unordered_map<std::uint64_t, Turning> turning_;
    std::shared_ptr<const TurnedPots> turned_;
    std::shared_ptr<const Composed> now_;
    std::shared_ptr<const Composed> before_;  // fading out
    // Items that both show alike at the same place, which need not fade; one entry each.
    std::vector<char> alike_before_;
    std::vector<char> alike_now_;
    double since_s_ = 0.0;
    bool covers_ = false;
    bool scene_rests_ = false;
    Cue cue_;  // as it was last seen
    double cue_alpha_ = 0.0;
    double last_s_ = 0.0;
};

}  // namespace onggi::screens
