#include "game/app/command_line/live_forces.h"

#include "game/kiosk/strings.h"

namespace onggi::app {

const render::Overlay* LiveForces::look(const haptic::Snapshot& snapshot, const wheel::WheelView& shown,
                                        const wheel::LiveView& view, double now_s) {
    forces_.look(snapshot, now_s);
    if (!shown_ || view.width() <= 0 || view.height() <= 0) return nullptr;
    if (!asked_ || asked_->width_px != view.width() || asked_->height_px != view.height()) {
        screens::View request;
        request.width_px = view.width();
        request.height_px = view.height();
        request.only_forces = true;
        request.state.comfort.forces = true;
        request.languages = std::make_shared<const std::vector<kiosk::Language>>(kiosk::built_in_languages());
        asked_ = std::make_shared<const screens::View>(std::move(request));
        composer_.ask(asked_);
    }
    stage_.take(composer_.latest(), now_s);
    const screens::ForceFrame frame = forces_.frame(snapshot, shown, sight_of(view), true);
    overlay_.list = &stage_.draw({.now_s = now_s, .forces = &frame});
    overlay_.uploads = stage_.uploads();
    overlay_.atlas_side_px = stage_.atlas_side_px();
    return &overlay_;
}

}  // namespace onggi::app
