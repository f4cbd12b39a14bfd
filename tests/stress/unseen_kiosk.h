// A kiosk without a window: the whole program except its command line, with the picture drawn offscreen, the
// real loop, keeper and disk, and a clock for the visits that advances with each frame.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/math/math.h"
#include "engine/window/events.h"
#include "engine/window/gamepad.h"
#include "game/app/devices/attached_devices.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/presentation/kiosk_voice.h"
#include "game/clay/studio/studio_clay.h"
#include "game/haptic/messages.h"
#include "game/kiosk/config.h"
#include "game/kiosk/state.h"
#include "game/screens/page/view.h"

namespace onggi::app {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kRateHz = 1000.0;
// The time step while waiting for threads that run in real time, the keeper and the composer: on a busy
// machine the visit's clock must not run ahead to the attract timeout.
constexpr double kSlowly = 0.002;

struct UnseenOptions {
    clay::StudioClay lump = clay::StudioClay(clay::StudioLump{});  // for every lump
    bool forgiving = true;                                         // the clay is stronger than real clay
    bool plain = true;                                             // without the photographed room
    bool shows = false;                                            // demonstrations on the attract screen
    bool real_time = false;                                        // at most 60 frames a second
    std::chrono::minutes patience{3};  // timeout of until(), in real time, on the reference machine
    int most_pots = 100'000;
    int width = kWidth;
    int height = kHeight;
    kiosk::Config config = {};                // except its gallery
    std::function<int()> minute_of_day = {};  // none: the machine's
    KioskSound::MakePlace loudspeaker = {};   // none: no sound
    KioskVoice::Synthesise speech = {};       // none: nothing is spoken
};

// ONGGI_LOOK=FOLDER: saves pictures of a visit's steps, large enough to inspect; see UnseenKiosk::look().
[[nodiscard]] UnseenOptions looked_at();

class UnseenKiosk {
  public:
    // arm: a device besides the pointer.
    explicit UnseenKiosk(const std::filesystem::path& gallery, UnseenOptions options = {},
                         std::optional<OtherDevice> arm = {});
    ~UnseenKiosk();
    UnseenKiosk(const UnseenKiosk&) = delete;
    UnseenKiosk& operator=(const UnseenKiosk&) = delete;

    [[nodiscard]] kiosk::Screen screen() const { return state().screen; }
    [[nodiscard]] const kiosk::State& state() const;
    [[nodiscard]] const KioskSettings& settings() const;
    [[nodiscard]] const haptic::Snapshot& snapshot();
    void frame(double dt_s = 1.0 / 60.0);
    [[nodiscard]] double now_s() const;
    // The pixel of a position on the wheel in the last frame.
    [[nodiscard]] std::optional<dvec2> seen(const dvec3& place_mm) const;
    // Draws frames for that many seconds of the wheel's clock, which falls behind real time on a slow
    // machine.
    void passes(double seconds);
    // Draws frames until the journal on disk, which gets one block per second, contains everything so far.
    // Returns false after a timeout.
    [[nodiscard]] bool journal_catches_up();
    // If ONGGI_LOOK is set: saves a picture of that name, after the scene has rested for rest_s.
    void look(const std::string& name, double rest_s = 1.2);
    // The last frame.
    [[nodiscard]] asset::Image picture();
    // Draws frames until the condition holds; the visit's clock advances by dt_s per frame. Returns false
    // after a timeout.
    bool until(const std::function<bool()>& condition, double dt_s = 1.0 / 60.0);

    void does(const window::Event& event);
    // The gamepads that are plugged in from now on.
    void plug_in(std::vector<window::Gamepad> pads);
    void point(double x_px, double y_px);
    void hold(bool pressed);
    void press_key(window::Key which);
    // A finger anywhere.
    void touch();

    // The screen that is shown, which follows the visit's state with a short delay.
    [[nodiscard]] std::optional<kiosk::Screen> shown_screen() const;
    [[nodiscard]] int shown_exhibit() const;
    [[nodiscard]] bool shown_closed() const;
    [[nodiscard]] std::uint64_t frames_shown() const;
    // The view it was composed from; null before the first.
    [[nodiscard]] std::shared_ptr<const screens::View> shown_view() const;
    // Presses that button of the current screen as soon as it exists.
    bool press(kiosk::Button button, int value = 0);
    // Moves the pointer over it.
    bool point_at(kiosk::Button button, int value = 0);

    // From the attract screen to clay on the wheel, without a museum's pot as a model.
    bool begins_to_throw();
    // Cuts the pot off, also one whose walls are so thick that the kiosk asks first.
    bool ends_throwing();
    // To the decorating screen; skips the trimming of a thick foot.
    bool dries();
    // From drying to the glazes, with a band of iron or undecorated. Returns false if it did not get there.
    bool fires_it(bool decorates);
    // Presses the wall in with the pointer.
    void touch_clay(std::mt19937& chance);
    // Opens the clay in the middle and pulls its wall up, as a visitor in a hurry does, repeating each touch
    // until it has worked. Returns false if it did not.
    bool throw_a_pot(std::mt19937& chance);
    // Moves a finger along those positions of the vertical plane through the axis, mm, with random errors; in
    // real time, like the clay.
    void stroke(const std::vector<dvec2>& way_mm, double seconds, std::mt19937& chance);

  private:
    // The missing button, and the buttons that exist.
    [[nodiscard]] std::string missed(kiosk::Button button, int value) const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::app
