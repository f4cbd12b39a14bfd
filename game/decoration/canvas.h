// A pot's wall while it is drawn on: strokes in, texture out. A stroke that grows point by point, one that is
// taken back, and the whole laid anew from its strokes come to the same bytes. Any one thread at a time.
#pragma once

#include <vector>

#include "engine/core/result.h"
#include "game/decoration/ink.h"
#include "game/decoration/stroke.h"
#include "game/decoration/stroke_mask.h"
#include "game/decoration/texture.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// A decoration as it is kept: what it is drawn on, and its strokes.
struct Marks {
    Wall wall;
    Recorded recorded;

    friend bool operator==(const Marks&, const Marks&) = default;
};
// What they come to; blank where they were never drawn on that wall.
[[nodiscard]] Texture texture_of(const Marks& marks);

// Which way the pot is turned to be looked at: the direction, in turns, that was drawn on first. Where
// nothing is drawn, a quarter of a turn before the pot's own direction 0.
constexpr float kPlainFront = -0.25F;
[[nodiscard]] float front_of(const Strokes& strokes);

// Nothing is drawn nearer to foot and rim.
constexpr float kMarginMm = 4.0F;

class Canvas {
  public:
    explicit Canvas(const Wall& wall);
    // With all those strokes laid. Bad input: as begin() and add().
    [[nodiscard]] static Result<Canvas> of(const Wall& wall, const Strokes& strokes);

    // A new stroke, with what points it has. Bad input: check_stroke(), more strokes or points than may be
    // recorded, or a point above the wall; then nothing has changed.
    Result<void> begin(const Stroke& stroke);
    // The newest stroke goes on to a point. Bad input: likewise, and where it is a motif, or older than the
    // last undoing.
    Result<void> add(const StrokePoint& point);
    // The newest stroke was never drawn; false: there is none.
    bool undo();

    [[nodiscard]] const Wall& wall() const { return wall_; }
    [[nodiscard]] const Strokes& strokes() const { return strokes_; }
    [[nodiscard]] const Texture& texture() const { return texture_; }
    [[nodiscard]] bool is_plain() const { return strokes_.empty(); }
    [[nodiscard]] Recorded recorded() const { return {strokes_, texture_.hash()}; }
    [[nodiscard]] Marks marks() const { return {wall_, recorded()}; }
    // What has changed of the texture since this was asked last.
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
    int first_row_ = 0;  // that may be drawn on, and behind the last
    int end_row_ = kRows;
    Strokes strokes_;
    std::size_t points_ = 0;  // of all of them
    bool grows_ = false;      // the newest may go on
    Texture texture_;
    Texture under_;  // what the stroke in the making lies on
    StrokeMask mask_;
    TextureRect changed_ = TextureRect::all();
    std::vector<Checkpoint> checkpoints_;  // the newest last; undoing begins from there
};

}  // namespace onggi::decoration
