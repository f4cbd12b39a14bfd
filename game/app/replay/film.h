// The film of a making: replays a session exactly, draws it picture by picture and packs it as animated WebP,
// and as MP4 if asked. It works in slices, so that the caller can show progress or stop. One thread at a
// time; has its own Vulkan device.
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

// Selects the moment of a session for each picture of its film. Pure; any thread. Times in s.
constexpr int kFilmPictureMs = 80;     // duration of each: 12.5 a second
constexpr double kFilmTurningS = 1.5;  // the finished pot, at the end of the film
constexpr double kLeastFilmS = 1.0;
constexpr double kLongestFilmS = 60.0;

struct FilmPicture {
    std::uint64_t ticks = 0;   // number of ticks before it
    bool is_finished = false;  // the pot alone, as it was fired
    double turned = 0.0;       // the pot's rotation for viewing, in turns

    friend bool operator==(const FilmPicture&, const FilmPicture&) = default;
};

// Plans `seconds` of film, kLeastFilmS to kLongestFilmS: the making, sampled evenly from before the first
// tick to after the last; then the finished pot, for kFilmTurningS but at most a quarter of the film. A
// session without ticks shows only the pot.
[[nodiscard]] std::vector<FilmPicture> film_plan(std::uint64_t tick_count, double seconds);

struct FilmDesc {
    int width = 480;  // pixels, 16 to 8192 each
    int height = 360;
    double seconds = 8.0;                        // kLeastFilmS to kLongestFilmS
    clay::Firing finished = clay::Firing::kWet;  // the stage in its last part
    std::size_t most_bytes = 1'500'000;          // of the file
    // Draws like the CPU backend of the live window (see wheel::StillOptions), while a kiosk runs, and
    // averages three pixels each way. Otherwise each picture equals the screenshot of its tick, to the byte.
    bool quick = false;
    bool as_mp4 = false;  // for take_mp4()
};

class FilmMaker {
  public:
    // Bad input: a size or a length outside its bounds, or a size that MP4 cannot have; system lacks: no
    // Vulkan device.
    [[nodiscard]] static Result<std::unique_ptr<FilmMaker>> create(record::Session session,
                                                                   haptic::Start start, const FilmDesc& desc);
    ~FilmMaker();
    FilmMaker(const FilmMaker&) = delete;
    FilmMaker& operator=(const FilmMaker&) = delete;

    // Does some ticks or one picture; some tens of ms in quick mode. Returns true while there is more to do.
    // kFailed: a tick differs from its recording.
    [[nodiscard]] Result<bool> work();
    // From here on the finished pot is shown under that glaze instead of its body's own. Has no effect once
    // the pot is drawn.
    void finish_in(const finish::GlazeMaterial& glaze);
    // Sets the decoration in the same way.
    void decorate(const decoration::Recorded& decoration);
    // Whether the making is drawn and the finished pot is next.
    [[nodiscard]] bool has_drawn_the_making() const;
    [[nodiscard]] std::size_t picture_count() const;
    [[nodiscard]] std::size_t pictures_drawn() const;
    // The last picture drawn; empty before the first.
    [[nodiscard]] const asset::Image& picture() const;
    // The film's still picture, from late in the making, as WebP. Precondition: the film is complete. Bad
    // input: as asset::WebpFilm.
    [[nodiscard]] Result<std::vector<std::byte>> still() const;
    // The file, once, when the work is done: in the best quality that fits into most_bytes. Bad input: no
    // quality fits.
    [[nodiscard]] Result<std::vector<std::byte>> take();
    // The same pictures as MP4, once, when the work is done. It is made to be repeated: the last third of the
    // finished pot's pictures pass over into the first picture. In a lower quality if it is over 50 kB per
    // second. kFailed: the encoder failed. Precondition: FilmDesc::as_mp4.
    [[nodiscard]] Result<std::vector<std::byte>> take_mp4();

  private:
    FilmMaker();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::app
