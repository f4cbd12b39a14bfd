// Decorating: what a finger, keys or one switch draw on the pot that waits, dry, on the slowly turning wheel,
// as strokes; and the texture they come to, as the wheel's picture shows it. Main thread. mm, px.
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
#include "game/wheel/wheel_scene.h"

namespace onggi::visit {

// A stroke without points, of the way that is chosen on the ledge. round_mm: how far round the pot is where
// it begins; height_mm: of its wall.
[[nodiscard]] decoration::Stroke stroke_of(const kiosk::Decorating& decorating, double round_mm,
                                           double height_mm);

class VisitDrawing {
  public:
    // Both outlive it.
    VisitDrawing(const wheel::LiveView& view, VisitFlow& flow) : view_(view), flow_(flow) {}

    // The pot that was cut off, wet; it is drawn on from begin() on, as far as the wheel has turned then.
    void take(std::shared_ptr<const pot::Pot> pot);
    // Once more where it went to the kiln and was wanted back: with what was drawn.
    void begin(const dvec2& heading);
    void forget();
    // Another pot will be taken: what was drawn before a power cut waits for that one.
    void forget_pot();
    // What was drawn before a power cut: it is on the pot again, where the pot is the same.
    void remember(std::shared_ptr<const decoration::Recorded> drawn) { remembered_ = std::move(drawn); }
    // What is to be kept of it, for a power cut: once after each stroke, and after what takes one back.
    [[nodiscard]] std::optional<std::vector<std::byte>> take_to_keep();

    // A finger comes down on the picture, goes on, leaves it; or a mouse is over it.
    void press(vec2 px);
    void drag(vec2 px);
    void release();
    void hover(vec2 px);
    // The dot that keys lead, and their brush.
    void nudge(kiosk::Button way);
    void put_brush(bool down);
    void undo();
    void clear();
    // Once a frame, after what was done: the pot turns, and a brush that is down draws.
    void pass(double dt_s);

    // The pot as it is then, with what was drawn; nothing before begin().
    void show(wheel::WheelScene& scene);
    // Where a stroke would begin, as the camera sees it; empty: nowhere, or one is being drawn.
    [[nodiscard]] std::vector<vec2> ring(bool keys_lead) const;
    // What was drawn; null: nothing.
    [[nodiscard]] std::shared_ptr<const decoration::Marks> marks() const;
    [[nodiscard]] finish::DrawnWith drawn_with() const;

  private:
    struct Work {
        Work(const pot::Pot& wet, const decoration::Strokes& strokes);
        Work(const pot::Pot& wet, decoration::Canvas canvas);

        pot::Pot dry;
        decoration::Canvas canvas;
        look::DressedMarks dressed;
        double scale;  // of the dry pot, beside the wall
    };
    void start_if_ready();
    // What it is drawn with takes room; the strokes alone stay.
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
    ecs::Entity in_scene_;          // its pot
    decoration::Strokes put_away_;  // to go on from
    std::shared_ptr<const decoration::Recorded> remembered_;
    bool is_to_be_kept_ = false;
    bool begun_ = false;
    double turned_rad_ = 0.0;
    std::optional<vec2> finger_px_;
    std::optional<vec2> hover_px_;
    bool turns_by_hand_ = false;  // the finger at the pot's edge
    bool draws_ = false;          // a stroke goes on
    bool brush_down_ = false;     // of the keys
    double dot_rad_ = 0.0;        // counter-clockwise from the side that faces the eye
    double dot_fraction_ = 0.5;   // of the height
};

}  // namespace onggi::visit
