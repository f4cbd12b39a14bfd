// Converts the visitor's input (pointer, keys, one switch, devices, gamepads) to events of the visit and to
// the finger on the clay. Main thread.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "game/app/devices/gamepad_finger.h"
#include "game/app/kiosk/finger/device_strokes.h"
#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/finger/kiosk_pointer.h"
#include "game/app/kiosk/visit/bench_tools.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/visit/decorate/visit_drawing.h"
#include "game/visit/jar/visit_jar.h"
#include "game/visit/trim/visit_trim.h"

namespace onggi::app {

// The place of a pixel on the vertical plane through the axis that faces the camera: distance to the right
// and height, mm.
[[nodiscard]] std::optional<dvec2> place_at(const wheel::LiveView& view, vec2 px);

class VisitInput {
  public:
    // All references must outlive it.
    VisitInput(const VisitParts& parts, KioskFinger& finger, visit::VisitDrawing& drawing,
               const visit::VisitJar& jar, const visit::VisitTrim& trim, VisitFlow& flow)
        : parts_(parts),
          finger_(finger),
          drawing_(drawing),
          jar_(jar),
          trim_(trim),
          flow_(flow) {}

    // Call it once a frame.
    void take(const VisitMoment& moment);
    // A press of a button of the screen's hand pad.
    void nudge(kiosk::Button button);

    [[nodiscard]] KioskPointer& pointer() { return pointer_; }
    [[nodiscard]] const KioskPointer& pointer() const { return pointer_; }
    // Whether a key or pad button was pressed since the last pointer motion.
    [[nodiscard]] bool keys_lead() const { return keys_lead_; }
    void lead_by_keys() { keys_lead_ = true; }
    // Whether the visitor has asked where they are since the last call.
    [[nodiscard]] bool take_question() { return std::exchange(asks_where_, false); }
    // Whether the strokes of the device that has the tool work the buttons: for a visitor by ear, off the
    // clay.
    [[nodiscard]] bool device_is_at_buttons() const { return device_is_at_buttons_; }
    // Whether a mouse without a pressed button has moved recently.
    [[nodiscard]] bool hovers(double now_s) const;
    // Whether a person has just changed a control of the device that has the tool. Without that, a touch of
    // the clay comes from a leaning stick or from a stuck touch.
    [[nodiscard]] bool holder_lives(double now_s) const;
    // The names of devices and controls that do not come to rest.
    [[nodiscard]] const std::vector<std::string>& restless() const { return restless_; }

  private:
    void take_news(const PointerNews& news, double now_s);
    // An arrow key moves the focus ring, where it is no hand or the ring was taken by arrow keys. Returns
    // whether it did.
    bool walks(kiosk::Button arrow);
    // An arrow key that moves the hand or the upper bowl.
    void take_arrow(const PointerNews& news);
    // Handles input on the pot that is being decorated; returns false for other input.
    bool take_drawing(const PointerNews& news);
    // The place on the clay as it is on the wheel, also in the view upside down.
    [[nodiscard]] std::optional<dvec2> finger_place(vec2 px) const;
    // A tap on a tool of the bench takes it when the finger is lifted. Returns whether one lies there.
    bool begins_on_bench(vec2 px);
    // press: of the first finger, or of the second.
    void touch_clay(vec2 px, void (KioskFinger::*press)(const dvec2&));
    void take_pen();
    void take_devices(const VisitMoment& moment);
    void take_strokes(const VisitMoment& moment);
    void take_gamepads(const VisitMoment& moment);
    void help_along();  // attracts the finger to the shown outline
    void name_restless(double now_s);

    const VisitParts& parts_;
    KioskFinger& finger_;
    visit::VisitDrawing& drawing_;
    const visit::VisitJar& jar_;
    const visit::VisitTrim& trim_;
    VisitFlow& flow_;
    KioskPointer pointer_;
    BenchTouch bench_;
    GamepadFinger gamepads_;
    DeviceStrokes strokes_;
    bool device_is_at_buttons_ = false;
    double hovered_s_ = -1e9;  // time of the last mouse motion without a button
    bool keys_lead_ = false;
    bool asks_where_ = false;
    bool had_device_ = false;
    std::string holder_;  // the device with the tool
    double device_lived_s_ = -1e9;
    double finger_lived_s_ = -1e9;  // pointer, keys and gamepads
    std::vector<std::string> restless_;
    std::vector<std::string> named_;  // those already named in the journal
    std::optional<int> helped_;       // the target of the shown outline and the lesson's progress
    int helped_steps_ = 0;
    kiosk::JarStep helped_jar_ = kiosk::JarStep::kNone;
    bool full_screen_ = false;
};

}  // namespace onggi::app
