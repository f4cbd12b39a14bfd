// The events of a visit, and the effects that it requests from the program. Any thread.
#pragma once

#include <optional>
#include <type_traits>
#include <variant>

#include "game/kiosk/state.h"

namespace onggi::kiosk {

namespace event {

struct Tick {};  // time has passed
// Pointer, key, or a device's motion above its noise.
struct Input {
    bool by_key = false;
};
// A button, on its release.
struct Pressed {
    Button button = Button::kNone;
    int value = 0;  // as the button says
};
// By the visitor's hand.
struct ClayTouched {
    bool goes_on = false;  // the touch continues
};
// The visitor's hand works the clay, or has let go.
struct Held {
    bool holds = false;
};
struct ShowOver {};  // the demonstration has ended
struct Soaked {};    // one turn of the sponge: water drops by one dot
// Judged by the pot.
struct Progress {
    int steps_done = 0;     // of kTeachingSteps
    bool is_solid = false;  // the clay has no hollow
    int thick_mm = 0;       // of a wall that another pull would do good; 0: it is thin enough
};
struct Warned {
    Warning warning = Warning::kNone;
};
struct Collapsed {
    Warning cause = Warning::kNone;
};
// Whether the clay on the wheel could be a half of a jar.
struct Bowl {
    bool is_bowl = false;
};
struct SetAside {};  // the first bowl has been set aside
// The rims of the two bowls are close enough to join.
struct Rims {
    int apart_mm = 0;
};
struct RimsApart {};  // too far apart to join
struct Joined {};     // the two bowls are one jar, on the wheel
struct JarStays {};   // the requested move of the bowls failed
struct UndoneAll {};  // the clay on the wheel has nothing left to undo
struct ThickFoot {};  // the pot that was cut off has spare clay at its foot
struct Trimmed {
    int taken_g = 0;  // so far
};
struct Drawn {
    int strokes = 0;  // on the pot
};
struct Saved {
    int number = 0;  // number within the day
};
struct SaveFailed {};  // disk full, no permission: the visitor sees "shelf full", the staff the reason
struct Shared {
    int number = 0;  // of the pot, that day
    ShareOutcome outcome = ShareOutcome::kReady;
};
struct Device {
    bool is_there = false;
};
// A device fault has stopped the force, or is over; throwing goes on.
struct Force {
    bool rests = false;
};
// Headphones were plugged in or pulled out.
struct Headphones {
    bool are_in = false;
};
// A voice has begun or ended to speak.
struct Spoken {
    bool speaks = false;
};
struct Fault {};  // the wheel cannot work
struct FaultOver {};
// An interrupted pot was found.
struct InterruptedSession {
    std::optional<InterruptedJar> jar{};  // empty: an ordinary pot
    InterruptedPot pot{};
};
struct CornerHeld {};  // the staff's corner was held long enough
struct CloseAsked {};  // the window's close button, Esc, Alt+F4, Ctrl+Q, Ctrl+C

}  // namespace event

using Event = std::variant<event::Tick, event::Input, event::Pressed, event::ClayTouched, event::Held,
                           event::ShowOver, event::Soaked, event::Progress, event::Warned, event::Collapsed,
                           event::Bowl, event::SetAside, event::Rims, event::RimsApart, event::Joined,
                           event::JarStays, event::UndoneAll, event::ThickFoot, event::Trimmed, event::Drawn,
                           event::Saved, event::SaveFailed, event::Shared, event::Device, event::Force,
                           event::Headphones, event::Spoken, event::Fault, event::FaultOver,
                           event::InterruptedSession, event::CornerHeld, event::CloseAsked>;

namespace effect {

struct StartDemo {};  // attract: recorded sessions on the wheel
struct FreshClay {
    std::optional<int> target{};  // empty: free throwing

    bool operator==(const FreshClay&) const = default;
};
struct Undo {};            // undoes the last touch
struct BeforeCollapse {};  // back to 2 s before the collapse began
// The lump on the wheel becomes the first bowl.
struct BeginJar {
    int target = 0;

    bool operator==(const BeginJar&) const = default;
};
struct SetAside {};  // sets the first bowl aside and makes room for the second
// Puts a bowl back on the wheel as it was.
struct TakeBack {
    int bowl = 1;  // 1 or 2

    bool operator==(const TakeBack&) const = default;
};
struct HoldTogether {};  // holds the first bowl over the bowl on the wheel
struct JoinBowls {
    int shift_mm = 0;  // of the upper bowl, to the right

    bool operator==(const JoinBowls&) const = default;
};
struct MoveHand {
    Button direction = Button::kHandUp;  // of the pad

    bool operator==(const MoveHand&) const = default;
};
struct CutRim {};  // cuts the rim at the wire
// The wheel's hands demonstrate a step on the visitor's clay.
struct ShowStep {
    ShownStep step = ShownStep::kPress;

    bool operator==(const ShowStep&) const = default;
};
struct StopShow {};   // ends the demonstration; the clay stays as it is
struct CutOff {};     // turns the clay into a pot: stop the wheel, take its profile
struct BeginTrim {};  // the pot is leather hard and stands on its rim
struct EndTrim {
    bool took_clay = false;  // so the pot has a new profile

    bool operator==(const EndTrim&) const = default;
};
struct BeginDrawing {};  // the pot has dried and is on the wheel
struct UndoStroke {};
struct ClearDrawing {};
// Puts the brush down or lifts it; places a motif.
struct PutBrush {
    bool down = false;

    bool operator==(const PutBrush&) const = default;
};
struct EndDrawing {};  // the decoration is final and goes to the kiln
struct Save {};
struct Share {};  // offers the kept pot to phones
// Puts the kept pot on the wall of the day, or takes it down.
struct Wall {
    bool up = false;

    bool operator==(const Wall&) const = default;
};
struct ForgetPot {};  // drops everything of the last visit
struct Resume {};
struct DropInterrupted {};
struct SetVolume {
    int volume = 0;  // 0 to kMostVolume

    bool operator==(const SetVolume&) const = default;
};
struct KeepHouse {};   // stores the default volume and language that the staff set
struct VisitBegan {};  // for the statistics, which hold only counts
struct VisitEnded {
    int dwell_s = 0;
    Screen last = Screen::kAttract;  // where it ended

    bool operator==(const VisitEnded&) const = default;
};
struct TestForce {};
struct TestSound {};
struct DeletePot {
    int pot = 0;  // of the gallery

    bool operator==(const DeletePot&) const = default;
};
// Phones no longer find the pot.
struct WithdrawCode {
    int pot = 0;

    bool operator==(const WithdrawCode&) const = default;
};
struct Restart {};
struct Quit {};

// All effects without a field are equal to their like.
template <typename Same>
requires std::is_empty_v<Same>
constexpr bool operator==(const Same& /*a*/, const Same& /*b*/) {
    return true;
}

}  // namespace effect

using Effect =
    std::variant<effect::StartDemo, effect::FreshClay, effect::Undo, effect::BeforeCollapse, effect::BeginJar,
                 effect::SetAside, effect::TakeBack, effect::HoldTogether, effect::JoinBowls,
                 effect::MoveHand, effect::CutRim, effect::ShowStep, effect::StopShow, effect::CutOff,
                 effect::BeginTrim, effect::EndTrim, effect::BeginDrawing, effect::UndoStroke,
                 effect::ClearDrawing, effect::PutBrush, effect::EndDrawing, effect::Save, effect::Share,
                 effect::Wall, effect::ForgetPot, effect::Resume, effect::DropInterrupted, effect::SetVolume,
                 effect::KeepHouse, effect::VisitBegan, effect::VisitEnded, effect::TestForce,
                 effect::TestSound, effect::DeletePot, effect::WithdrawCode, effect::Restart, effect::Quit>;

}  // namespace onggi::kiosk
