#include "game/visit/steps.h"

#include <array>

namespace onggi::visit {

// Each is in the folder of its step.
extern const Step kAttractStep;
extern const Step kChooseStep;
extern const Step kJarStartStep;
extern const Step kThrowStep;
extern const Step kJoinStep;
extern const Step kFailureStep;
extern const Step kFiringStep;
extern const Step kTrimStep;
extern const Step kDecorateStep;
extern const Step kGlazeStep;
extern const Step kYourPotStep;
extern const Step kKeepStep;
extern const Step kResumeStep;
extern const Step kFaultStep;
extern const Overlay kLanguageOverlay;
extern const Overlay kIdleOverlay;
extern const Overlay kPinOverlay;
extern const Overlay kStaffOverlay;
extern const Overlay kCardOverlay;

namespace {

constexpr Overlay kNoOverlay{};

// In the order of Screen and Panel.
constexpr std::array kAllSteps{&kAttractStep, &kChooseStep, &kJarStartStep, &kThrowStep,    &kJoinStep,
                               &kFailureStep, &kFiringStep, &kTrimStep,     &kDecorateStep, &kGlazeStep,
                               &kYourPotStep, &kKeepStep,   &kResumeStep,   &kFaultStep};
static_assert(kAllSteps.size() == kScreenCount);
constexpr std::array kAllOverlays{&kNoOverlay,  &kLanguageOverlay, &kIdleOverlay,
                                  &kPinOverlay, &kStaffOverlay,    &kCardOverlay};
static_assert(kAllOverlays.size() == kPanelCount);

}  // namespace

const Step& step_of(Screen screen) {
    return *kAllSteps[static_cast<std::size_t>(screen)];
}

const Overlay& overlay_of(Panel panel) {
    return *kAllOverlays[static_cast<std::size_t>(panel)];
}

Composition compose(const View& view, ui::Painter& painter, PaintingStore& store) {
    Page page(view, painter, store);
    if (const auto draw = overlay_of(view.state.panel).draw) {
        draw(page);
    } else {
        step_of(view.state.screen).draw(page);
        if (view.closed) {
            const ui::Colour shade = ui::hex(0x000000, 0.85F);
            page.box({0.0F, 0.0F, page.width(), page.height()}, {shade, shade, shade, shade});
        }
    }
    store.forget_unused();
    Composition composed = page.take();
    composed.plays_by_itself =
        step_of(view.state.screen).whose == Whose::kNobody && view.state.panel == Panel::kNone;
    return composed;
}

std::string_view spoken_key(const State& state) {
    if (state.panel != Panel::kNone) return overlay_of(state.panel).spoken;
    return step_of(state.screen).spoken(state);
}

}  // namespace onggi::visit
