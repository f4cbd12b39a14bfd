#include "engine/render/cpu/host_backgrounds.h"

#include <algorithm>
#include <utility>

#include "engine/render/frame/background_pair.h"

namespace onggi::render {
namespace {

HostPhotograph host_photograph(const FrameContext& frame, const asset::Image& picture) {
    return {picture.width, picture.height, picture.rgba, byte_order(frame.desc.colour_format)};
}

std::vector<std::shared_ptr<const Background>> backgrounds_of(const Scene& scene) {
    std::vector<std::shared_ptr<const Background>> backgrounds = scene.backgrounds_at_hand;
    if (scene.background) backgrounds.push_back(scene.background);
    if (scene.next_view && scene.next_view->background) backgrounds.push_back(scene.next_view->background);
    return backgrounds;
}

}  // namespace

Result<void> HostBackgrounds::fit(const FrameContext& frame, const Scene& scene) {
    const std::vector<std::shared_ptr<const Background>> wanted = backgrounds_of(scene);
    const auto is_wanted = [&](const std::unique_ptr<Resident>& resident) {
        return std::find(wanted.begin(), wanted.end(), resident->background) != wanted.end();
    };
    residents_.erase(std::partition(residents_.begin(), residents_.end(), is_wanted), residents_.end());
    for (const std::shared_ptr<const Background>& background : wanted) {
        if (find(background)) continue;
        const auto pair = whole_pair(*background);
        if (!pair) return pair.error();
        residents_.push_back(std::make_unique<Resident>(Resident{
            background, {host_photograph(frame, (*pair)->key), host_photograph(frame, (*pair)->ambient)}}));
        background->photographs->let_go();
    }
    return {};
}

Result<const HostBackground*> HostBackgrounds::find(
    const std::shared_ptr<const Background>& background) const {
    for (const auto& resident : residents_) {
        if (resident->background == background) return &std::as_const(resident->photographs);
    }
    return failed("background: expected one of the scene's, found another");
}

}  // namespace onggi::render
