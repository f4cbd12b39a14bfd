#include "game/app/command_line/target_choice.h"

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

}  // namespace onggi::app
