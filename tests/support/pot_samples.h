// Pots for tests, benchmarks and the browser checks: each stresses another part of an export. Any thread.
#pragma once

#include <string>
#include <vector>

#include "game/exporter/pot_rings.h"

namespace onggi::support {

struct PotSample {
    std::string name;
    double height_mm = 0.0;
    std::vector<float> radii_mm;  // bottom first
    // Smooth enough for the finest setting: the export must stay within 0.02 mm of the outline.
    bool hand_made = true;

    [[nodiscard]] exporter::PotRings rings() const { return exporter::rings_of(height_mm, radii_mm); }
};

// A belly, a narrow neck, a flaring lip and throwing rings of 0.5 mm.
PotSample vase(int element_count);

// A tool of radius 10 mm, pressed into a straight wall of 60 mm at several heights and depths: arcs, walls
// left untouched, and the edges between.
PotSample pressed_lump(int element_count);

// The pot that the gesture assets/gestures/vase.csv throws from the paper's clay at 1000 Hz. Reads that file;
// throws std::runtime_error if it cannot.
PotSample thrown_vase();

// All of them: the thrown vase, a straight lump, vases of 100, 2000 and 200000 elements, a neck at the 2 mm
// floor, sharp steps, a single element, and roughness such as no hand makes.
std::vector<PotSample> all_pot_samples();

}  // namespace onggi::support
