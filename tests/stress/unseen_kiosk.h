// A kiosk without a window: the whole program but its command line, with the picture drawn unseen, the real
// loop, the real keeper and the real disk, and a clock for the visits that runs as fast as frames are drawn.
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
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/clay/studio/studio_clay.h"
#include "game/haptic/messages.h"
#include "game/kiosk/config.h"
#include "game/kiosk/state.h"
#include "game/screens/page/view.h"

namespace onggi::app {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kRateHz = 1000.0;
// A frame of who waits for what works by the clock on the wall, the keeper or whoever composes screens: on a
// busy machine the visit's clock must not run away from them, into attract.
constexpr double kSlowly = 0.002;

struct UnseenOptions {
    clay::StudioClay lump = clay::StudioClay(clay::StudioLump{});  // every lump is that
    bool forgiving = true;                                         // it bears more than real clay
    bool plain = true;                                             // no photographed room
    bool shows = false;                                            // recordings, while nobody is there
    bool real_time = false;                                        // 60 frames a second, no more
    std::chrono::minutes patience{3};  // of until(), by the clock on the wall, on the reference machine
    int most_pots = 100'000;
    int width = kWidth;
    int height = kHeight;
    kiosk::Config config = {};                // but its gallery
    std::function<int()> minute_of_day = {};  // none: the machine's
    KioskSound::MakePlace loudspeaker = {};   // none: no sound
};

// ONGGI_LOOK=FOLDER: pictures of a visit's steps, large enough to be looked at; see UnseenKiosk::look().
[[nodiscard]] UnseenOptions looked_at();

class UnseenKiosk {
  public:
    explicit UnseenKiosk(const std::filesystem::path& gallery, UnseenOptions options = {});
    ~UnseenKiosk();
    UnseenKiosk(const UnseenKiosk&) = delete;
    UnseenKiosk& operator=(const UnseenKiosk&) = delete;

    [[nodiscard]] kiosk::Screen screen() const { return state().screen; }
    [[nodiscard]] const kiosk::State& state() const;
    [[nodiscard]] const KioskSettings& settings() const;
    [[nodiscard]] const haptic::Snapshot& snapshot();
    void frame(double dt_s = 1.0 / 60.0);
    [[nodiscard]] double now_s() const;
    // Where the last frame shows a place on the wheel, px.
    [[nodiscard]] std::optional<dvec2> seen(const dvec3& place_mm) const;
    // Draws frames for that many seconds of the wheel's own clock, which falls behind the wall clock on a
    // slow machine.
    void passes(double seconds);
    // Draws frames until the journal on the disk, which gets a block a second, holds all that has happened so
    // far. False: it does not within the patience.
    [[nodiscard]] bool journal_catches_up();
    // Where somebody asked to see it: a picture of that name, of a scene at rest after so long.
    void look(const std::string& name, double rest_s = 1.2);
    // The last frame.
    [[nodiscard]] asset::Image picture();
    // Frames until it is so; the clock of the visit goes by dt_s a frame. As long as there is patience.
    bool until(const std::function<bool()>& condition, double dt_s = 1.0 / 60.0);

    void does(const window::Event& event);
    void point(double x_px, double y_px);
    void hold(bool pressed);
    void press_key(window::Key which);
    // A finger anywhere.
    void touch();

    // What the screen shows, which is a little later than what the visit has come to.
    [[nodiscard]] std::optional<kiosk::Screen> shown_screen() const;
    [[nodiscard]] int shown_exhibit() const;
    [[nodiscard]] bool shown_closed() const;
    // What it was made from; null before the first.
    [[nodiscard]] std::shared_ptr<const screens::View> shown_view() const;
    // Presses that button of the screen that is shown, as soon as it is there.
    bool press(kiosk::Button button, int value = 0);
    // The pointer over it.
    bool point_at(kiosk::Button button, int value = 0);

    // From attract to clay on the wheel, after no pot of a museum.
    bool begins_to_throw();
    // To the decorating, where the pot can be drawn on; a foot that is thick is left as it is.
    bool dries();
    // From the drying to the glazes, with a band of iron or as it is. False: it did not get there.
    bool fires_it(bool decorates);
    // A hand that presses the wall in, with the pointer.
    void touch_clay(std::mt19937& chance);
    // Opens the clay in the middle and draws its wall up, as a visitor in a hurry does: each touch again
    // until the clay has come on. False: it did not.
    bool throw_a_pot(std::mt19937& chance);
    // A finger along those places of the upright plane through the axis, mm, missed by some; in real time, as
    // the clay goes.
    void stroke(const std::vector<dvec2>& way_mm, double seconds, std::mt19937& chance);

  private:
    // What was looked for, and what is there instead.
    [[nodiscard]] std::string missed(kiosk::Button button, int value) const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::app
