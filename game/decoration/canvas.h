// Draws on a pot's wall: strokes in, texture out. A stroke that grows point by point, an undo, and a redraw
// of all strokes lead to the same bytes. Any one thread at a time.
#pragma once

#include <vector>

#include "engine/core/result.h"
#include "game/decoration/ink.h"
#include "game/decoration/stroke.h"
#include "game/decoration/stroke_mask.h"
#include "game/decoration/texture.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// A stored decoration: its wall and its strokes.
struct Marks {
    Wall wall;
    Recorded recorded;

    friend bool operator==(const Marks&, const Marks&) = default;
};
// The texture of those marks; blank if the strokes do not fit the wall.
[[nodiscard]] Texture texture_of(const Marks& marks);

// The direction, in turns, from which a pot is shown: that of its first stroke. Without strokes, a quarter of
// a turn before the pot's own direction 0.
constexpr float kPlainFront = -0.25F;
[[nodiscard]] float front_of(const Strokes& strokes);

// Margin without drawing at foot and rim.
constexpr float kMarginMm = 4.0F;

class Canvas {
  public:
    explicit Canvas(const Wall& wall);
    // A canvas with all those strokes. Bad input: as begin() and add().
    [[nodiscard]] static Result<Canvas> of(const Wall& wall, const Strokes& strokes);

    // Starts a stroke with the points it has. Bad input: check_stroke(), more strokes or points than can be
    // recorded, or a point above the wall; then nothing has changed.
    Result<void> begin(const Stroke& stroke);
    // Extends the newest stroke to a point. Bad input: as begin(), and if the stroke is a motif or older than
    // the last undo.
    Result<void> add(const StrokePoint& point);
    // Undoes the newest stroke. Returns false if there are no strokes.
    bool undo();

    [[nodiscard]] const Wall& wall() const { return wall_; }
    [[nodiscard]] const Strokes& strokes() const { return strokes_; }
    [[nodiscard]] const Texture& texture() const { return texture_; }
    [[nodiscard]] bool is_plain() const { return strokes_.empty(); }
    [[nodiscard]] Recorded recorded() const { return {strokes_, texture_.hash()}; }
    [[nodiscard]] Marks marks() const { return {wall_, recorded()}; }
    // Returns the part of the texture changed since the last call.
    [[nodiscard]] TextureRect take_changed();

  private:
    friend Texture texture_of(const Marks& marks);
    void lay(const Stroke& stroke);
    void lay_motif(const Stroke& stroke);
    void lay_piece(const Piece& piece, Ink ink);
    void blend(const TextureRect& rect, Ink ink);
    void lay_coat();
    [[nodiscard]] Piece piece_between(const StrokePoint& from, const StrokePoint& to,
                                      const Stroke& stroke) const;
    void keep_checkpoint();
    [[nodiscard]] Result<void> check_height(const StrokePoint& point, std::size_t stroke) const;

    struct Checkpoint {
        std::size_t strokes = 0;
        Texture texture;
    };

    Wall wall_;
    int first_row_ = 0;  // rows [first_row_, end_row_) may be drawn on
    int end_row_ = kRows;
    Strokes strokes_;
    std::size_t points_ = 0;  // of all strokes
    bool grows_ = false;      // add() may extend the newest stroke
    Texture texture_;
    Texture under_;  // the texture below the newest stroke
    StrokeMask mask_;
    TextureRect changed_ = TextureRect::all();
    std::vector<Checkpoint> checkpoints_;  // newest last; undo starts from these
};

}  // namespace onggi::decoration
