// Which moment of a session each picture of its film shows. Pure; any thread. Times in s.
#pragma once

#include <cstdint>
#include <vector>

namespace onggi::app {

constexpr int kFilmPictureMs = 80;     // how long each is shown: 12.5 a second
constexpr double kFilmTurningS = 1.5;  // the finished pot, at the end of the film
constexpr double kLeastFilmS = 1.0;
constexpr double kLongestFilmS = 60.0;

struct FilmPicture {
    std::uint64_t ticks = 0;   // how many of the session are behind it
    bool is_finished = false;  // the pot alone, as it was fired
    double turned = 0.0;       // how far it has been turned to be looked at, in turns

    friend bool operator==(const FilmPicture&, const FilmPicture&) = default;
};

// For `seconds` of film, kLeastFilmS to kLongestFilmS: the making, evenly from before the first tick to
// behind the last, then the finished pot, for kFilmTurningS and at most a quarter of the film. Where no tick
// was recorded, the pot is all there is to see.
[[nodiscard]] std::vector<FilmPicture> film_plan(std::uint64_t tick_count, double seconds);

}  // namespace onggi::app
