// Judges whether a visitor's result is a pot worth keeping, by its shape, not by the actions.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::visitors {

struct Verdict {
    double height_mm = 0.0;
    double capacity_ml = 0.0;
    double thinnest_mm = 0.0;
    double thickest_mm = 0.0;
    double steep_fraction = 0.0;  // fraction of the height that leans more than 2 to 1
    double mean_wall_mm = 0.0;    // across the wall, from 6 mm above the floor to the rim
    double thickest_up_mm = 0.0;  // the same
    double thinnest_up_mm = 0.0;  // the same
    double drawn_rms_mm = 0.0;    // from the intended outline; 0 without one
    bool is_pot = false;
    std::string why_not = {};
    bool is_good = false;
    std::string why_not_good = {};
};

// A pot holds 60 ml and stands 45 mm high, is nowhere thinner than 2.5 mm, and no more than a tenth of its
// height leans more than 2 to 1. A dish, 160 mm wide and more, may stand 24 mm high and lean more. A good pot
// is hollow and holds 150 ml; from 6 mm above its floor, its wall is nowhere thicker than 15 mm or thinner
// than 2.5 mm, and at most 10 mm thick in the mean.
Verdict judge(const clay::StudioClay& clay, const std::vector<dvec2>& drawn_mm);

// Judges the clay at the end of a session, which is replayed. Error: as start_pot().
Result<Verdict> judge_session(const std::string& file);

// "412 ml, 96 mm high, walls 4.1 to 12.3 mm, steep on 0 % of its height": one line.
std::string words_for(const Verdict& verdict);

}  // namespace onggi::visitors
