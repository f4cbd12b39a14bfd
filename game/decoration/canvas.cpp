#include "game/decoration/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/decoration/motifs.h"

namespace onggi::decoration {
namespace {

constexpr std::size_t kStrokesACheckpoint = 16;
constexpr std::size_t kMostCheckpoints = 4;

float turns_of(const StrokePoint& point) {
    return static_cast<float>(point.turn) / static_cast<float>(kTurnUnits);
}

float height_of(const StrokePoint& point) {
    return static_cast<float>(point.height) / static_cast<float>(kHeightUnitsPerMm);
}

float width_of(const Stroke& stroke) {
    return static_cast<float>(stroke.width) / static_cast<float>(kWidthUnitsPerMm);
}

float half_of(const Stroke& stroke, const StrokePoint& point) {
    constexpr float kLightest = 0.4F;
    return 0.5F * width_of(stroke) *
           (kLightest + (1.0F - kLightest) * static_cast<float>(point.pressure) / 255.0F);
}

// E. Catmull and R. Rom, 1974: the point at fraction t between b and c.
MotifPoint between(const MotifPoint& a, const MotifPoint& b, const MotifPoint& c, const MotifPoint& d,
                   float t) {
    const auto of = [t](float p, float q, float r, float s) {
        return 0.5F * (2.0F * q + (r - p) * t + (2.0F * p - 5.0F * q + 4.0F * r - s) * t * t +
                       (3.0F * q - p - 3.0F * r + s) * t * t * t);
    };
    return {of(a.x, b.x, c.x, d.x), of(a.y, b.y, c.y, d.y), b.half + t * (c.half - b.half)};
}

std::vector<MotifPoint> smooth_line(const std::vector<MotifPoint>& points) {
    constexpr int kPieces = 6;
    std::vector<MotifPoint> fine;
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        for (int k = 0; k < kPieces; ++k) {
            fine.push_back(between(points[i > 0 ? i - 1 : 0], points[i], points[i + 1],
                                   points[std::min(i + 2, last)], static_cast<float>(k) / kPieces));
        }
    }
    fine.push_back(points.back());
    return fine;
}

float within_a_turn(float turns) {
    return turns - static_cast<float>(static_cast<int>(turns + 8.0F) - 8);
}

}  // namespace

Canvas::Canvas(const Wall& wall) : wall_(wall) {
    first_row_ = std::clamp(static_cast<int>(wall.row_of_height(kMarginMm) + 0.5F), 0, kRows);
    end_row_ = std::clamp(static_cast<int>(wall.row_of_height(wall.height_mm - kMarginMm) + 0.5F), first_row_,
                          kRows);
}

Result<Canvas> Canvas::of(const Wall& wall, const Strokes& strokes) {
    Canvas canvas(wall);
    for (const Stroke& stroke : strokes) {
        if (auto begun = canvas.begin(stroke); !begun) return begun.error();
    }
    return canvas;
}

float front_of(const Strokes& strokes) {
    float front = kPlainFront;
    bool is_found = false;
    for (const Stroke& stroke : strokes) {
        if (stroke.technique == Technique::kClear) {
            front = kPlainFront;
            is_found = false;
        } else if (!is_found && !stroke.points.empty()) {
            front = turns_of(stroke.points.front());
            is_found = true;
        }
    }
    return front;
}

Texture texture_of(const Marks& marks) {
    auto canvas = Canvas::of(marks.wall, marks.recorded.strokes);
    return canvas ? std::move(canvas->texture_) : Texture();
}

Result<void> Canvas::begin(const Stroke& stroke) {
    if (auto checked = check_stroke(stroke, fmt::format("stroke {}", strokes_.size() + 1)); !checked)
        return checked;
    if (strokes_.size() >= kMostStrokes)
        return bad_input(fmt::format("decoration: expected at most {} strokes, found more", kMostStrokes));
    if (points_ + stroke.points.size() > kMostPoints)
        return bad_input(fmt::format("decoration: expected at most {} points, found more", kMostPoints));
    for (const StrokePoint& point : stroke.points) {
        if (auto checked = check_height(point, strokes_.size() + 1); !checked) return checked;
    }
    if (strokes_.size() % kStrokesACheckpoint == 0) keep_checkpoint();
    strokes_.push_back(stroke);
    points_ += stroke.points.size();
    grows_ = stroke.technique != Technique::kMotif && stroke.technique != Technique::kClear;
    lay(strokes_.back());
    return {};
}

Result<void> Canvas::add(const StrokePoint& point) {
    if (!grows_) return bad_input("decoration: expected a stroke that goes on, found none");
    Stroke& stroke = strokes_.back();
    if (stroke.points.size() >= kMostPointsOfStroke || points_ >= kMostPoints)
        return bad_input(fmt::format("stroke {}: expected no more points, found another", strokes_.size()));
    if (auto checked = check_height(point, strokes_.size()); !checked) return checked;
    const StrokePoint& from = stroke.points.empty() ? point : stroke.points.back();
    const Piece piece = piece_between(from, point, stroke);
    stroke.points.push_back(point);
    ++points_;
    lay_piece(piece, ink_of(stroke.technique, stroke.slip));
    return {};
}

bool Canvas::undo() {
    if (strokes_.empty()) return false;
    grows_ = false;
    points_ -= strokes_.back().points.size();
    strokes_.pop_back();
    while (!checkpoints_.empty() && checkpoints_.back().strokes > strokes_.size())
        checkpoints_.pop_back();
    std::size_t done = 0;
    if (checkpoints_.empty()) {
        texture_ = Texture();
    } else {
        texture_ = checkpoints_.back().texture;
        done = checkpoints_.back().strokes;
    }
    const Strokes all = std::exchange(
        strokes_, Strokes(strokes_.begin(), strokes_.begin() + static_cast<std::ptrdiff_t>(done)));
    for (; done < all.size(); ++done) {
        if (done % kStrokesACheckpoint == 0 && (checkpoints_.empty() || checkpoints_.back().strokes < done))
            keep_checkpoint();
        strokes_.push_back(all[done]);
        lay(strokes_.back());
    }
    changed_ = TextureRect::all();
    return true;
}

Result<void> Canvas::check_height(const StrokePoint& point, std::size_t stroke) const {
    constexpr float kRoundedMm = 0.02F;
    if (height_of(point) <= wall_.height_mm + kRoundedMm) return {};
    return bad_input(fmt::format("stroke {}: expected a height of 0 to {} mm, found {}", stroke,
                                 wall_.height_mm, height_of(point)));
}

// A blank texture needs no checkpoint.
void Canvas::keep_checkpoint() {
    if (strokes_.empty()) return;
    if (checkpoints_.size() >= kMostCheckpoints) checkpoints_.erase(checkpoints_.begin());
    checkpoints_.push_back({strokes_.size(), texture_});
}

TextureRect Canvas::take_changed() {
    return std::exchange(changed_, TextureRect{});
}

void Canvas::lay(const Stroke& stroke) {
    mask_.clear();
    if (stroke.technique == Technique::kClear) {
        texture_ = Texture();
        changed_ = TextureRect::all();
        return;
    }
    if (stroke.technique == Technique::kMotif) return lay_motif(stroke);
    const Ink ink = ink_of(stroke.technique, stroke.slip);
    if (ink == Ink::kWipe) lay_coat();
    under_ = texture_;
    for (std::size_t i = 0; i < stroke.points.size(); ++i)
        lay_piece(piece_between(stroke.points[i > 0 ? i - 1 : 0], stroke.points[i], stroke), ink);
}

Piece Canvas::piece_between(const StrokePoint& from, const StrokePoint& to, const Stroke& stroke) const {
    // The shorter way round, exactly: 16-bit wrap-around.
    const auto on = static_cast<std::int16_t>(static_cast<std::uint16_t>(to.turn - from.turn));
    return {.turns = turns_of(from),
            .along_mm = wall_.along_at(height_of(from)),
            .half_mm = half_of(stroke, from),
            .turns_on = static_cast<float>(on) / static_cast<float>(kTurnUnits),
            .end_along_mm = wall_.along_at(height_of(to)),
            .end_half_mm = half_of(stroke, to)};
}

void Canvas::lay_motif(const Stroke& stroke) {
    const StrokePoint& middle = stroke.points.front();
    const float middle_along = wall_.along_at(height_of(middle));
    const float unit_mm = width_of(stroke) / 100.0F;
    for (const MotifLine& line : lines_of(stroke.motif)) {
        if (line.ink == Ink::kWipe) lay_coat();
        mask_.clear();
        under_ = texture_;
        const std::vector<MotifPoint> points = smooth_line(line.points);
        for (int repeat = 0; repeat < stroke.repeats; ++repeat) {
            const float first =
                turns_of(middle) + static_cast<float>(repeat) / static_cast<float>(stroke.repeats);
            // Each point uses the pot's circumference at its own height, so that the motif keeps its
            // proportions.
            const auto turns_at = [&](const MotifPoint& point) {
                return first + point.x * unit_mm / wall_.round_at_along(middle_along + point.y * unit_mm);
            };
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                const float from = turns_at(points[i]);
                lay_piece({.turns = within_a_turn(from),
                           .along_mm = middle_along + points[i].y * unit_mm,
                           .half_mm = points[i].half * unit_mm,
                           .turns_on = turns_at(points[i + 1]) - from,
                           .end_along_mm = middle_along + points[i + 1].y * unit_mm,
                           .end_half_mm = points[i + 1].half * unit_mm},
                          line.ink);
            }
        }
    }
}

void Canvas::lay_piece(const Piece& piece, Ink ink) {
    if (ink != Ink::kWipe) {
        blend(mask_.lay(piece, tip_of(ink), wall_), ink);
        return;
    }
    // Three fingers of a hand that comes from the side: always one above another, whatever the direction.
    constexpr float kApart = 0.68F;  // fraction of the half width
    constexpr float kFinger = 0.30F;
    TextureRect touched;
    for (const float place : {-kApart, 0.0F, kApart}) {
        Piece finger = piece;
        finger.along_mm += place * piece.half_mm;
        finger.end_along_mm += place * piece.end_half_mm;
        finger.half_mm *= kFinger;
        finger.end_half_mm *= kFinger;
        touched.add(mask_.lay(finger, tip_of(ink), wall_));
    }
    blend(touched, ink);
}

void Canvas::blend(const TextureRect& rect, Ink ink) {
    const int from = std::max(rect.row, first_row_);
    const int end = std::min(rect.row + rect.row_count, end_row_);
    for (int row = from; row < end; ++row) {
        for (int i = 0; i < rect.column_count; ++i) {
            const int column = (rect.column + i) & (kColumns - 1);
            texture_.at(column, row) = inked(under_.at(column, row), ink, mask_.at(column, row), column, row);
        }
    }
    changed_.add(rect);
}

void Canvas::lay_coat() {
    for (int row = first_row_; row < end_row_; ++row) {
        for (int column = 0; column < kColumns; ++column)
            texture_.at(column, row) = coated(texture_.at(column, row), column, row);
    }
    changed_ = TextureRect::all();
}

}  // namespace onggi::decoration
