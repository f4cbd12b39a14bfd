// What a visitor does - by pointer, keys, one switch, devices and gamepads - as events of the visit and as
// the finger on the clay. Main thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/app/devices/gamepad_finger.h"
#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/finger/kiosk_pointer.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/visit/decorate/visit_drawing.h"
#include "game/visit/jar/visit_jar.h"
#include "game/visit/trim/visit_trim.h"

namespace onggi::app {

// On the upright plane through the axis that faces the camera: how far to the right, and how high, mm.
[[nodiscard]] std::optional<dvec2> place_at(const wheel::LiveView& view, vec2 px);

class VisitInput {
  public:
    // All outlive it.
    VisitInput(const VisitParts& parts, KioskFinger& finger, visit::VisitDrawing& drawing,
               const visit::VisitJar& jar, const visit::VisitTrim& trim, VisitFlow& flow)
        : parts_(parts),
          finger_(finger),
          drawing_(drawing),
          jar_(jar),
          trim_(trim),
          flow_(flow) {}

    // Once a frame.
    void take(const VisitMoment& moment);
    // One press of the pad's buttons on the screen.
    void nudge(kiosk::Button button);

    [[nodiscard]] KioskPointer& pointer() { return pointer_; }
    [[nodiscard]] const KioskPointer& pointer() const { return pointer_; }
    // No pointer has been moved since a key or a button of the pad was pressed.
    [[nodiscard]] bool keys_lead() const { return keys_lead_; }
    void lead_by_keys() { keys_lead_ = true; }
    // A mouse with no button held wants something there: it has moved a moment ago.
    [[nodiscard]] bool hovers(double now_s) const;
    // Somebody has changed something a moment ago at whatever has the tool. What touches the clay without
    // that is a stick that leans, or a finger that nobody lifts.
    [[nodiscard]] bool holder_lives(double now_s) const;
    // The names of devices and controls that do not come to rest.
    [[nodiscard]] const std::vector<std::string>& restless() const { return restless_; }

  private:
    void take_news(const PointerNews& news, double now_s);
    // On the pot that is being decorated; false: it is no such news.
    bool take_drawing(const PointerNews& news);
    // On the clay as it stands on the wheel, however it is seen.
    [[nodiscard]] std::optional<dvec2> finger_place(vec2 px) const;
    bool pick_up(vec2 px);
    void take_devices(double now_s);
    void take_gamepads(const VisitMoment& moment);
    void help_along();  // draws a finger to the outline that is shown
    void name_restless(double now_s);

    const VisitParts& parts_;
    KioskFinger& finger_;
    visit::VisitDrawing& drawing_;
    const visit::VisitJar& jar_;
    const visit::VisitTrim& trim_;
    VisitFlow& flow_;
    KioskPointer pointer_;
    GamepadFinger gamepads_;
    double hovered_s_ = -1e9;  // when a mouse last moved with no button held
    bool keys_lead_ = false;
    bool had_device_ = false;
    std::string holder_;  // the device that has the tool
    double device_lived_s_ = -1e9;
    double finger_lived_s_ = -1e9;  // pointer, keys and gamepads
    std::vector<std::string> restless_;
    std::vector<std::string> named_;  // those that the journal has named
    std::optional<int> helped_;       // along the outline of which target, and how far the lesson had come
    int helped_steps_ = 0;
    kiosk::JarStep helped_jar_ = kiosk::JarStep::kNone;
    bool full_screen_ = false;
};

}  // namespace onggi::app
