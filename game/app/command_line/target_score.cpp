#include "game/app/command_line/target_score.h"

#include <fmt/format.h>

#include "game/heritage/advice.h"

namespace onggi::app {

TargetScore score_beside(const TargetChoice& choice, const clay::StudioClay& clay) {
    const heritage::PotForm form = heritage::form_of(clay);
    const heritage::Nearest nearest = heritage::nearest(form, choice.targets);
    const heritage::Target& target = choice.targets[choice.chosen.value_or(nearest.target)];
    const heritage::Score score = heritage::score(form, target, clay.lump().body);
    const heritage::Target& resembled = choice.targets[nearest.target];

    nlohmann::ordered_json measures;
    for (const heritage::Measure& measure : score.measures) {
        nlohmann::ordered_json museum = nullptr;  // not published
        if (measure.target) museum = *measure.target;
        measures[measure.name] = {{"pot", measure.pot}, {"museum", museum}};
    }
    const heritage::Advice advice =
        heritage::advise(form, target, choice.chosen ? std::optional(score.size.fraction) : std::nullopt);
    TargetScore result;
    result.json = {{"id", target.id},
                   {"text", heritage::sentence(target)},
                   {"source", target.source},
                   {"fraction", score.size.fraction},
                   {"wet_scale", score.size.wet_scale},
                   {"measures", measures},
                   {"profile_rms_mm", score.profile_rms_mm},
                   {"published_points", score.published_points},
                   {"drawn_points", score.drawn_points},
                   {"mean_off_mm", score.mean_off_mm},
                   {"good", heritage::good_key(advice)},
                   {"try_next", heritage::next_key(advice)},
                   {"nearest", resembled.id},
                   {"nearest_unlikeness", nearest.unlikeness}};
    result.text = heritage::report(score, target) + heritage::report(advice);
    if (choice.chosen) {
        result.text += fmt::format("nearest in shape: {} ({:.3f} unlike, 0 the same)\n", resembled.id,
                                   nearest.unlikeness);
    }
    return result;
}

}  // namespace onggi::app
