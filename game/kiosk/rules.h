// The parameters of a visit's flow, from the configuration. Any thread.
#pragma once

#include <vector>

namespace onggi::kiosk {

// Times are seconds.
struct Rules {
    double idle_s = 45.0;
    double countdown_s = 20.0;
    double listens_most_s = 180.0;  // of speech that does not count as idle time
    double works_most_s = 180.0;    // for how long the program's own work stops the idle timeout
    double hint_again_s = 6.0;      // time without progress until the cue for the next move returns
    bool shows_by_itself = true;    // the wheel's hands demonstrate a step unasked
    double show_after_s = 8.0;      // time without progress until they do
    double show_stuck_s = 20.0;     // the same for a visitor who does not rest
    double show_rests_s = 3.0;      // pause after a touch or a demonstration
    double show_most_s = 20.0;      // longest demonstration; its hands wait for a slow machine's clay
    double aside_s = 6.0;           // how long the bowl that was set aside is shown
    double jar_idle_s = 180.0;      // replaces idle_s while a jar of two bowls is made
    double staff_locks_s = 120.0;   // without a touch
    double cut_s = 1.2;
    double dry_s = 1.4;
    double fire_s = 2.4;
    int language_count = 3;
    int default_language = 0;
    int default_volume = 3;
    int default_text_size = 1;
    bool offers_speech = false;  // visitors can switch it on and off
    bool speaks = false;         // visits begin with speech
    int target_count = 4;
    std::vector<int> jars{};  // the targets that are made of two bowls
    int glaze_count = 6;
    bool shares = false;    // kept pots can go home by phone
    bool has_wifi = false;  // the phone must join the museum's Wi-Fi first
    bool has_wall = false;  // there is a wall of the day
    bool locked = false;    // only the staff can quit
    int pin = 0;            // of pin_digits; with 0 digits the staff panel cannot be opened
    int pin_digits = 0;
    int pin_tries = 3;         // from this many wrong PINs in a row on, each costs a wait
    double pin_wait_s = 15.0;  // doubles with each wrong PIN
    double pin_longest_wait_s = 900.0;
};

}  // namespace onggi::kiosk
