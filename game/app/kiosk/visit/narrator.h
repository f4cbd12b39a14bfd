// What a visitor hears: the line of each screen, each button as the focus comes to it, what has come of a
// press, and the clay as it changes. Pure but for what it has already told; main thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/app/kiosk/presentation/kiosk_voice.h"
#include "game/haptic/messages.h"
#include "game/kiosk/strings.h"
#include "game/screens/composer.h"

namespace onggi::app {

// The place of the marker that keys move, as far as keys have another meaning there.
enum class MarkerPlace { kNone, kWall, kRim, kMiddle };
[[nodiscard]] MarkerPlace marker_place(const std::optional<dvec2>& marker_mm, const pot::Pot& shape);

// Where the tip of a device is.
struct TipPlace {
    // From kRight to kBehind: well off the clay; kOutside: near its outer face.
    enum class Where { kButtons, kMiddle, kRim, kRight, kLeft, kFront, kBehind, kOutside, kInside };
    enum class Height { kBase, kHalfway, kTop };
    Where where = Where::kOutside;
    Height height = Height::kBase;  // outside and inside alone
    bool touches = false;

    friend bool operator==(const TipPlace&, const TipPlace&) = default;
};
// `before`: the last one, which a tip at a border of two places keeps; empty: none.
[[nodiscard]] TipPlace tip_place(const haptic::Snapshot& snapshot, bool is_at_buttons,
                                 const std::optional<TipPlace>& before);

struct Hearing {
    const screens::Composed& shown;
    int focus = -1;  // target with the ring
    MarkerPlace marker = MarkerPlace::kNone;
    // Whether a device has the tool; then whether its strokes work the buttons.
    std::optional<bool> device_is_at_buttons = {};
    screens::CueGuard guard = screens::CueGuard::kNone;
    const haptic::Snapshot& snapshot;
    double now_s = 0.0;
    bool is_quiet = true;     // nothing is being said
    bool is_private = false;  // nobody else hears it
    bool has_device = false;  // that is held in a hand
    bool asks_where = false;  // the visitor asks where they are
};

class Narrator {
  public:
    // The lines that are due, once a frame.
    [[nodiscard]] std::vector<SaidLine> look(const Hearing& now);
    // The line of the screen alone, as a museum records them.
    [[nodiscard]] std::vector<SaidLine> look_for_recordings(const screens::View& view);
    // Nobody listens: the next look tells everything.
    void forget() { *this = {}; }

  private:
    struct Clay {
        bool is_solid = true;
        int high_mm = 0;
        int wall_mm = 0;       // 0: solid
        int load_percent = 0;  // in tens; 0: little

        friend bool operator==(const Clay&, const Clay&) = default;
    };
    [[nodiscard]] static Clay clay_of(const haptic::Snapshot& snapshot);
    // Returns whether the screen's line is new.
    bool tell_line(const screens::View& view, bool again);
    void tell_more(const screens::View& view, bool has_device);
    // What the staff's panels write, in English as they are. The digits of a PIN are said in private alone.
    void tell_staff(const Hearing& now);
    void tell_pot(const screens::FiredPot& pot);
    void tell_focus(const Hearing& now, bool is_after_line);
    void tell_clay(const Hearing& now);
    // Where a device's tip has come to rest or slowly goes.
    void tell_tip(const Hearing& now);
    void tell_guard(const Hearing& now);
    void say(std::string_view key, std::string text, bool is_urgent = false);
    void say(std::string_view key);

    std::vector<SaidLine> due_;
    const kiosk::Language* language_ = nullptr;  // during look()
    std::string told_line_;                      // key, language and part of the screen's last line
    std::string told_target_;
    int told_focus_ = -1;
    bool ring_is_devices_ = false;
    MarkerPlace told_marker_ = MarkerPlace::kNone;
    std::optional<TipPlace> tip_;  // in the last frame
    double tip_s_ = 0.0;           // since when it has been there
    std::optional<TipPlace> told_tip_;
    double told_tip_s_ = -1e9;
    bool is_explaining_ = false;  // a screen's line and more, which no place cuts off
    std::optional<Clay> told_clay_;
    double clay_s_ = -1e9;  // when the clay was told
    screens::CueGuard told_guard_ = screens::CueGuard::kNone;
    double guard_s_ = -1e9;  // when that was told
    std::string told_notice_;
    bool told_force_rests_ = false;
    bool has_told_keys_ = false;
    bool has_told_hand_ = false;
};

}  // namespace onggi::app
