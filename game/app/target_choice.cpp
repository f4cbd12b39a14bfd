#include "game/app/target_choice.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "engine/files/asset_folder.h"

namespace onggi::app {
namespace {

constexpr const char* kNearest = "nearest";

}  // namespace

void add_target_option(CLI::App& command, std::optional<std::string>& id) {
    command
        .add_option("--target", id,
                    "score the fired pot beside a museum's, or beside the one nearest in shape; an unknown "
                    "name lists those there are")
        ->type_name("ID|nearest");
}

Result<std::optional<TargetChoice>> find_target_choice(const std::optional<std::string>& id) {
    if (!id) return std::optional<TargetChoice>();
    const auto folder = files::find_asset("heritage");
    if (!folder) return folder.error();
    auto targets = heritage::load_targets(*folder);
    if (!targets) return targets.error();
    TargetChoice choice{std::move(targets).value(), std::nullopt};
    if (*id != kNearest) {
        if (const auto known = heritage::find_target(choice.targets, *id); !known)
            return bad_input(fmt::format("--{}", known.error().message));
        for (std::size_t i = 0; i < choice.targets.size(); ++i) {
            if (choice.targets[i].id == *id) choice.chosen = i;
        }
    }
    return std::optional(std::move(choice));
}

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
                   {"nearest", resembled.id},
                   {"nearest_unlikeness", nearest.unlikeness}};
    result.text = heritage::report(score, target);
    if (choice.chosen) {
        result.text += fmt::format("nearest in shape: {} ({:.3f} unlike, 0 the same)\n", resembled.id,
                                   nearest.unlikeness);
    }
    return result;
}

}  // namespace onggi::app
