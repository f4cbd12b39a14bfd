// A pot as archaeologists draw it: half a section, hatched, at the left of the axis, half an elevation at the
// right, rim, height, a scale bar and the measures, at 1:1. Any thread but the haptic one, one at a time (it
// writes text).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/ui/painter.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::look {

// The kind for a path's extension. kBadInput for any other than .svg and .pdf.
[[nodiscard]] Result<ui::VectorKind> drawing_kind_of(std::string_view path);

// The file. Its lines are those of the exported solid: the section is cut at the clay's direction 0, x to the
// right, and the elevation is the silhouette towards it. Line weights in mm: outlines 0.5, rim and base 0.35,
// axis and edges 0.25, dimensions 0.18, hatching 0.13. `credit` is written below the measures, in any
// language, and is a PDF's subject. The same pot gives the same bytes on one machine. kBadInput: see
// exporter::build_pot_solid().
[[nodiscard]] Result<std::vector<std::byte>> pot_drawing(const clay::StudioClay& clay, clay::Firing stage,
                                                         ui::VectorKind kind, const std::string& credit = {});

}  // namespace onggi::look
