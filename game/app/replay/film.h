// The film of a making: a session replayed to the bit, drawn picture by picture, packed as animated WebP. In
// slices, so that whoever makes it can show how far it is, or stop. Any one thread at a time; has a Vulkan
// device of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/clay/studio/pot.h"
#include "game/decoration/stroke.h"
#include "game/finish/glaze.h"
#include "game/haptic/start_state.h"
#include "game/record/session.h"

namespace onggi::app {

// Which moment of a session each picture of its film shows. Pure; any thread. Times in s.
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

struct FilmDesc {
    int width = 480;  // pixels, 16 to 8192 each
    int height = 360;
    double seconds = 8.0;                        // kLeastFilmS to kLongestFilmS
    clay::Firing finished = clay::Firing::kWet;  // the stage that its last part shows
    std::size_t most_bytes = 1'500'000;          // of the file
    // Drawn as the live window of a processor is (see wheel::StillOptions), for beside the frame. Otherwise
    // each picture is, to the byte, the screenshot of its tick.
    bool quick = false;
};

class FilmMaker {
  public:
    // Bad input: a size or a length outside its bounds; system lacks: no Vulkan device.
    [[nodiscard]] static Result<std::unique_ptr<FilmMaker>> create(record::Session session,
                                                                   haptic::Start start, const FilmDesc& desc);
    ~FilmMaker();
    FilmMaker(const FilmMaker&) = delete;
    FilmMaker& operator=(const FilmMaker&) = delete;

    // Some ticks, or one picture; some tens of ms where it is drawn quickly. True while there is more to do.
    // kFailed: a tick differs from its recording.
    [[nodiscard]] Result<bool> work();
    // From here on the finished pot is shown under that glaze, not under its body's own. Where it is drawn
    // already, nothing becomes of it.
    void finish_in(const finish::GlazeMaterial& glaze);
    // Likewise with that drawn on it.
    void decorate(const decoration::Recorded& decoration);
    // Whether the making is drawn, and the finished pot comes next.
    [[nodiscard]] bool has_drawn_the_making() const;
    [[nodiscard]] std::size_t picture_count() const;
    [[nodiscard]] std::size_t pictures_drawn() const;
    // The one drawn last; none before the first.
    [[nodiscard]] const asset::Image& picture() const;
    // What stands for the film where it does not move: from late in the making, as WebP; of a film that is
    // whole. Bad input: as asset::WebpFilm.
    [[nodiscard]] Result<std::vector<std::byte>> still() const;
    // The whole file, once, when no more is to do: in the best of a few qualities that fits. Bad input: none
    // of them does.
    [[nodiscard]] Result<std::vector<std::byte>> take();

  private:
    FilmMaker();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::app
