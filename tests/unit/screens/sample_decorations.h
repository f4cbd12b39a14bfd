// Pots that were drawn on, for tests and pictures.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "game/pot/section.h"

namespace onggi::screens {

// Once round at a height, where `swing_mm` is not 0 up and down six times.
inline decoration::Stroke stroke_round(decoration::Technique technique, double height_mm, double width_mm,
                                       double swing_mm = 0.0) {
    constexpr int kPoints = 192;
    constexpr double kWaves = 6.0;
    decoration::Stroke stroke{.technique = technique,
                              .width = static_cast<std::uint16_t>(width_mm * decoration::kWidthUnitsPerMm)};
    for (int i = 0; i <= kPoints; ++i) {
        const double turns = static_cast<double>(i) / kPoints;
        stroke.points.push_back(
            decoration::stroke_point(turns,
                                     height_mm + swing_mm * std::sin(2.0 * std::numbers::pi * kWaves * turns))
                .value());
    }
    return stroke;
}

inline decoration::Stroke motif_round(decoration::Motif motif, double height_mm, double size_mm,
                                      std::uint8_t repeats) {
    return {.technique = decoration::Technique::kMotif,
            .motif = motif,
            .repeats = repeats,
            .width = static_cast<std::uint16_t>(size_mm * decoration::kWidthUnitsPerMm),
            .points = {decoration::stroke_point(0.75, height_mm).value()}};
}

// The same shape with those strokes on it. Precondition: they may be drawn there.
inline pot::Section drawn_on(pot::Section shape, const decoration::Strokes& strokes) {
    auto canvas = decoration::Canvas::of(decoration::wall_of(shape.outside), strokes);
    shape.marks = std::make_shared<const decoration::Marks>(std::move(canvas).value().marks());
    return shape;
}

// The decoration of the design's sheet, on a cylinder: five materials, from the rim down.
inline pot::Section sheet_cylinder() {
    using decoration::Technique;
    constexpr double kHeightMm = 150.0;
    std::vector<vec2> outline;
    for (int i = 0; i <= 30; ++i)
        outline.push_back({24.0F, static_cast<float>(kHeightMm * i / 30.0)});
    decoration::Stroke black = stroke_round(Technique::kInlay, 104.0, 8.0);
    black.slip = decoration::Slip::kBlack;
    return drawn_on(pot::hollowed(outline, 4.0F, 6.0F),
                    {stroke_round(Technique::kFinger, 40.0, 14.0, 6.0),
                     stroke_round(Technique::kBrushedSlip, 134.0, 12.0), black,
                     stroke_round(Technique::kIron, 88.0, 7.0), stroke_round(Technique::kCobalt, 72.0, 7.0)});
}

}  // namespace onggi::screens
