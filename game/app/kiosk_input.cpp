#include "game/app/kiosk_input.h"

#include <algorithm>
#include <variant>

namespace onggi::app {
namespace {

constexpr double kRadiusStepMm = 1.0;
// The hand may go where the pot is and around it, not behind the picture.
constexpr double kReachMm = 260.0;

}  // namespace

KioskAction KioskInput::handle(const window::Event& event, const PlaceOf& place_of) {
    KioskAction action = KioskAction::kNone;
    if (const auto* pointer = std::get_if<window::PointerEvent>(&event)) {
        if (const auto place = place_of(pointer->x_px, pointer->y_px)) {
            target_.position_mm = glm::clamp(*place, dvec3(-kReachMm), dvec3(kReachMm));
        }
    } else if (const auto* button = std::get_if<window::ButtonEvent>(&event)) {
        if (button->button == window::MouseButton::kLeft) button_held_ = button->pressed;
    } else if (const auto* scroll = std::get_if<window::ScrollEvent>(&event)) {
        change_radius(scroll->steps);
    } else if (const auto* key = std::get_if<window::KeyEvent>(&event)) {
        action = handle_key(*key);
    } else if (std::holds_alternative<window::CloseEvent>(event)) {
        action = KioskAction::kQuit;
    }
    target_.wheel_button = button_held_ || space_held_;
    // The tool rolls on the wheel head, it does not go through.
    target_.position_mm.y = std::max(target_.position_mm.y, target_.radius_mm);
    return action;
}

KioskAction KioskInput::handle_key(const window::KeyEvent& event) {
    if (event.key == window::Key::kSpace) space_held_ = event.pressed;
    if (!event.pressed) return KioskAction::kNone;
    switch (event.key) {
        case window::Key::kLeftBracket:
        case window::Key::kMinus:
            change_radius(-1.0);
            return KioskAction::kNone;
        case window::Key::kRightBracket:
        case window::Key::kPlus:
            change_radius(1.0);
            return KioskAction::kNone;
        default:
            break;
    }
    if (event.repeat) return KioskAction::kNone;  // a held key asks once
    switch (event.key) {
        case window::Key::kEscape:
        case window::Key::kQ:
            return KioskAction::kQuit;
        case window::Key::kR:
            return KioskAction::kFreshLump;
        case window::Key::kE:
            return KioskAction::kSaveModel;
        case window::Key::kS:
            return KioskAction::kSavePicture;
        case window::Key::kF:
        case window::Key::kF11:
            return KioskAction::kToggleFullScreen;
        default:
            return KioskAction::kNone;
    }
}

void KioskInput::change_radius(double steps) {
    target_.radius_mm = std::clamp(target_.radius_mm + kRadiusStepMm * steps, haptics::kMinToolRadiusMm,
                                   haptics::kMaxToolRadiusMm);
}

}  // namespace onggi::app
