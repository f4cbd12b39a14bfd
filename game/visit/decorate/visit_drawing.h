// Decorating: converts input from a finger, keys or a single switch to strokes on the dry pot on the slowly
// turning wheel, and renders the strokes to a texture for the picture. Main thread. mm, px.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "game/decoration/canvas.h"
#include "game/decoration/picking.h"
#include "game/finish/drawn_with.h"
#include "game/look/lathe_marks.h"
#include "game/pot/pot.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/live_view.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::visit {

// Returns an empty stroke in the technique chosen on the ledge. round_mm is the pot's circumference where the
// stroke starts; height_mm is the wall's height.
[[nodiscard]] decoration::Stroke stroke_of(const kiosk::Decorating& decorating, double round_mm,
                                           double height_mm);

class VisitDrawing {
  public:
    // Glaze and decoration must outlive it.
    VisitDrawing(const wheel::LiveView& view, VisitFlow& flow) : view_(view), flow_(flow) {}

    // Takes the wet, cut-off pot. begin() starts the decorating, with the wheel at `heading`.
    void take(std::shared_ptr<const pot::Pot> pot);
    // If the pot was taken back from the kiln, a second call continues its decoration.
    void begin(const dvec2& heading);
    void forget();
    // Drops the pot but keeps a remembered decoration for the next one.
    void forget_pot();
    // Passes the decoration stored before a power cut; it is restored if it belongs to the pot.
    void remember(std::shared_ptr<const decoration::Recorded> drawn) { remembered_ = std::move(drawn); }
    // Returns the decoration to store in case of a power cut, once after each stroke and each undo.
    [[nodiscard]] std::optional<std::vector<std::byte>> take_to_keep();

    // A finger presses, drags and lifts on the picture; a mouse hovers.
    void press(vec2 px);
    void drag(vec2 px);
    void release();
    void hover(vec2 px);
    // Moves the dot of the keys, and lowers or lifts its brush.
    void nudge(kiosk::Button way);
    void put_brush(bool down);
    void undo();
    void clear();
    // Call it once a frame after the input. Turns the pot; a lowered brush draws.
    void pass(double dt_s);

    // Shows the pot with its decoration; has no effect before begin().
    void show(wheel::WheelScene& scene);
    // The ring that marks where the next stroke would start, in pixels; empty off the pot and during a
    // stroke.
    [[nodiscard]] std::vector<vec2> ring(bool keys_lead) const;
    // The decoration, or null.
    [[nodiscard]] std::shared_ptr<const decoration::Marks> marks() const;
    [[nodiscard]] finish::DrawnWith drawn_with() const;

  private:
    struct Work {
        Work(const pot::Pot& wet, const decoration::Strokes& strokes);
        Work(const pot::Pot& wet, decoration::Canvas canvas);

        pot::Pot dry;
        decoration::Canvas canvas;
        look::DressedMarks dressed;
        double scale;  // of the dry pot relative to the wet wall
    };
    void start_if_ready();
    // Frees the working memory and keeps only the strokes.
    void put_away();
    [[nodiscard]] std::optional<decoration::Canvas> remembered_canvas();
    void dress();
    void tell();
    void draw_at(const std::optional<decoration::WallPlace>& place);
    void place_motif(const decoration::WallPlace& place);
    [[nodiscard]] dvec2 heading() const;
    [[nodiscard]] std::optional<decoration::WallPlace> place_at(vec2 px) const;
    [[nodiscard]] std::optional<decoration::WallPlace> place_of_dot() const;

    const wheel::LiveView& view_;
    VisitFlow& flow_;
    std::shared_ptr<const pot::Pot> pot_;
    std::shared_ptr<Work> work_;
    ecs::Entity in_scene_;          // the decorated pot
    decoration::Strokes put_away_;  // the strokes kept for continuing
    std::shared_ptr<const decoration::Recorded> remembered_;
    bool is_to_be_kept_ = false;
    bool begun_ = false;
    double turned_rad_ = 0.0;
    std::optional<vec2> finger_px_;
    std::optional<vec2> hover_px_;
    bool turns_by_hand_ = false;  // the finger grabbed the pot's edge and turns it
    bool draws_ = false;          // a stroke is in progress
    bool brush_down_ = false;     // the keys' brush
    double dot_rad_ = 0.0;        // position of the dot, counter-clockwise from the side facing the camera
    double dot_fraction_ = 0.5;   // fraction of the height
};

}  // namespace onggi::visit
