// What there is to hear at the wheel, in physical terms: what the main thread says once a frame, and what the
// synthesiser makes sound of. Plain values; any thread.
#pragma once

#include <cstdint>

namespace onggi::sound {

struct SoundScene {
    double wheel_rev_min = 0.0;  // as it turns, not as it was asked to: a wheel under load sounds lower
    double motor_load = 0.0;     // 0 idle to 1 nearly stalled
    double contact_n = 0.0;      // how hard the tool presses
    double slip_mm_s = 0.0;      // how fast what turns passes under it
    double wetness = 0.0;        // 0 leather-dry to 1 dripping
    bool is_hard_tool = false;   // a hard tool scrapes, a hand or a soft one strokes
    double place = 0.0;          // where the tool is, -1 left to 1 right
    std::uint32_t slaps = 0;     // counts lumps thrown on the wheel: each new one is heard once
    bool is_plucked = false;     // a taut string gives way: heard once each time that this begins
    std::uint32_t chimes = 0;    // counts tests of the loudspeakers: left, right, then both, once for each
    bool fire_burns = false;     // a pot is fired: a low roar that comes and goes
    double volume = 0.5;         // 0 silent to 1
};

}  // namespace onggi::sound
