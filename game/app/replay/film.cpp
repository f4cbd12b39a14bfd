#include "game/app/replay/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/asset/mp4_film.h"
#include "engine/asset/webp_film.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/session_marks.h"
#include "game/look/lathe_marks.h"
#include "game/wheel/clay_look.h"
#include "game/wheel/still.h"

namespace onggi::app {
namespace {

// Packs each picture in all of these qualities when it is drawn, 12 ms each: drawing all pictures again in
// another quality would cost more.
constexpr std::array kQualities{90.0, 75.0, 50.0, 25.0};
// Likewise; the first keeps an SSIM of 0.99 against what was drawn.
constexpr std::array kMp4Quantisers{26, 28};
constexpr double kMp4BytesPerS = 50'000.0;
constexpr std::uint64_t kTicksASlice = 2000;
// A quick picture has one sample per pixel of its drawing. Drawn three times as large, ridges that are finer
// than a pixel no longer break into dots, which cost an encoder most: 0.991 where 0.988 took as many bytes.
constexpr int kQuickAcross = 3;
constexpr double kStillAt =
    0.8;  // fraction of the making's pictures: there, the hands work on a pot with a recognisable shape
constexpr double kStillQuality = 75.0;

dvec2 turned(const dvec2& direction, double turns) {
    const double angle = kTurn * turns;
    const dvec2 by(std::cos(angle), std::sin(angle));
    return {direction.x * by.x - direction.y * by.y, direction.x * by.y + direction.y * by.x};
}

}  // namespace

std::vector<FilmPicture> film_plan(std::uint64_t tick_count, double seconds) {
    constexpr double kPicturesPerS = 1000.0 / kFilmPictureMs;
    constexpr double kTurnsPerS = 1.0 / 3.0;
    const auto count_of = [](double film_s) {
        return static_cast<std::uint64_t>(std::lround(film_s * kPicturesPerS));
    };
    const std::uint64_t count = count_of(seconds);
    const std::uint64_t turning = tick_count == 0 ? count : std::min(count_of(kFilmTurningS), count / 4);
    const std::uint64_t steps = count - turning - 1;  // between the first and the last picture of the making
    std::vector<FilmPicture> plan;
    plan.reserve(count);
    for (std::uint64_t picture = 0; picture < count - turning; ++picture) {
        // Integer arithmetic without a product that could overflow in a long session.
        plan.push_back({.ticks = tick_count / steps * picture + tick_count % steps * picture / steps});
    }
    for (std::uint64_t picture = 0; picture < turning; ++picture) {
        plan.push_back({.ticks = tick_count,
                        .is_finished = true,
                        .turned = static_cast<double>(picture) * kTurnsPerS / kPicturesPerS});
    }
    return plan;
}

struct FilmMaker::Parts {
    Parts(record::Session of, haptic::Start start, const FilmDesc& with)
        : desc(with),
          session(std::move(of)),
          replay(session, std::move(start)),
          plan(film_plan(session.tick_count(), desc.seconds)) {}

    FilmDesc desc;
    record::Session session;
    Replay replay;
    std::vector<FilmPicture> plan;
    std::size_t drawn = 0;
    std::unique_ptr<wheel::StillCamera> camera;
    std::vector<asset::WebpFilm> films;                // of kQualities
    Result<std::vector<asset::Mp4Film>> mp4{Error{}};  // of kMp4Quantisers
    asset::Image first_picture;
    asset::Image picture;
    asset::Image still;
    const finish::GlazeMaterial* glaze = nullptr;  // null: the body's own
    decoration::Recorded decoration;
    std::optional<look::DressedMarks> dressed;  // set when it is first shown

    [[nodiscard]] std::size_t pictures_of_the_making() const {
        const auto first =
            std::find_if(plan.begin(), plan.end(), [](const FilmPicture& one) { return one.is_finished; });
        return static_cast<std::size_t>(first - plan.begin());
    }
    // The index of the still's picture, which shows the finished pot in a film without a making.
    [[nodiscard]] std::size_t place_of_still() const {
        return static_cast<std::size_t>(kStillAt * static_cast<double>(pictures_of_the_making()));
    }

    // The picture as it stands in a film that is repeated.
    [[nodiscard]] asset::Image repeated() const {
        const std::size_t passing = (plan.size() - pictures_of_the_making()) / 3;
        const std::size_t left = plan.size() - drawn;
        if (left > passing) return picture;
        asset::Image mixed = picture;
        for (std::size_t i = 0; i < mixed.rgba.size(); ++i) {
            mixed.rgba[i] = static_cast<std::uint8_t>(
                (picture.rgba[i] * left + first_picture.rgba[i] * (passing + 1 - left)) / (passing + 1));
        }
        return mixed;
    }
    // The WebP film goes on without the MP4.
    void add_to_mp4() {
        if (drawn == 0) first_picture = picture;
        if (!mp4) return;
        const asset::Image shown = repeated();
        for (std::size_t i = 0; mp4 && i < kMp4Quantisers.size(); ++i)
            if (auto added = (*mp4)[i].add(shown); !added) mp4 = added.error();
    }

    void dress(const pot::Pot& wet) {
        const decoration::Marks marks{wall_of(wet), decoration};
        dressed.emplace().dress(decoration::texture_of(marks), marks.wall,
                                (glaze != nullptr ? *glaze : finish::wet_clay()).marks);
    }
    Result<asset::Image> draw(const FilmPicture& shown) {
        haptic::Snapshot snapshot;
        haptic::fill_snapshot(snapshot, replay.state(), replay.last(), replay.parameters());
        pot::Pot pot = haptic::pot_of(replay.state());
        if (shown.is_finished) {
            if (!dressed && !decoration.strokes.empty() && pot.ring_count() > 0) dress(pot);
            pot = pot::fired(pot, desc.finished);
        }
        snapshot.pot = &pot;
        if (!shown.is_finished) return camera->take(snapshot, wheel::StillView::kThrowing);
        std::optional<render::LatheMaterial> worn;
        if (glaze != nullptr)
            worn = look::glazed_lathe(wheel::clay_material(pot.body, clay::Firing::kGlaze), *glaze);
        ecs::Entity finished;
        camera->scene().put_on_wheel(finished,
                                     {.pot = &pot,
                                      .material = worn ? &*worn : nullptr,
                                      .marks = dressed ? &dressed->marks() : nullptr},
                                     {.direction = turned(snapshot.wheel_direction, shown.turned)});
        auto taken = camera->take(snapshot, wheel::StillView::kPortrait);
        camera->scene().registry().destroy(finished);
        return taken;
    }
};

FilmMaker::FilmMaker() = default;
FilmMaker::~FilmMaker() = default;

namespace {

Result<std::vector<asset::Mp4Film>> mp4_films(const FilmDesc& desc) {
    std::vector<asset::Mp4Film> films;
    for (const int quantiser : kMp4Quantisers) {
        auto film = asset::Mp4Film::create({desc.width, desc.height, kFilmPictureMs, quantiser});
        if (!film) return film.error();
        films.push_back(std::move(film).value());
    }
    return films;
}

}  // namespace

Result<std::unique_ptr<FilmMaker>> FilmMaker::create(record::Session session, haptic::Start start,
                                                     const FilmDesc& desc) {
    if (!(desc.seconds >= kLeastFilmS && desc.seconds <= kLongestFilmS)) {
        return bad_input(fmt::format("film: expected {} to {} seconds, found {}", kLeastFilmS, kLongestFilmS,
                                     desc.seconds));
    }
    auto mp4 = desc.as_mp4 ? mp4_films(desc) : Result<std::vector<asset::Mp4Film>>(Error{});
    if (!mp4 && mp4.error().kind == ErrorKind::kBadInput) return mp4.error();
    const int most_across = wheel::kMostStillPx / std::max({desc.width, desc.height, 1});
    auto camera = wheel::StillCamera::create(
        desc.width, desc.height,
        {.quick = desc.quick, .across = desc.quick ? std::clamp(most_across, 1, kQuickAcross) : 1});
    if (!camera) return camera.error();
    std::unique_ptr<FilmMaker> maker(new FilmMaker);
    maker->parts_ = std::make_unique<Parts>(std::move(session), std::move(start), desc);
    Parts& parts = *maker->parts_;
    parts.camera = std::move(*camera);
    parts.mp4 = std::move(mp4);
    for (const double quality : kQualities) {
        auto film = asset::WebpFilm::create({desc.width, desc.height, quality});
        if (!film) return film.error();
        parts.films.push_back(std::move(film).value());
    }
    if (const auto other = parts.replay.compare_start()) return failed(sentence_for(*other));
    return maker;
}

Result<bool> FilmMaker::work() {
    Parts& parts = *parts_;
    const FilmPicture& next = parts.plan[parts.drawn];
    const std::uint64_t until = std::min(next.ticks, parts.replay.ticks() + kTicksASlice);
    while (parts.replay.ticks() < until) {
        if (const auto difference = parts.replay.step()) return failed(sentence_for(*difference));
    }
    if (until < next.ticks) return true;
    auto picture = parts.draw(next);
    if (!picture) return picture.error();
    parts.picture = std::move(picture).value();
    for (asset::WebpFilm& film : parts.films) {
        if (auto added = film.add(parts.picture, kFilmPictureMs); !added) return added.error();
    }
    parts.add_to_mp4();
    if (parts.drawn == parts.place_of_still()) parts.still = parts.picture;
    return ++parts.drawn < parts.plan.size();
}

void FilmMaker::finish_in(const finish::GlazeMaterial& glaze) {
    parts_->desc.finished = clay::Firing::kGlaze;
    parts_->glaze = &glaze;
}

void FilmMaker::decorate(const decoration::Recorded& decoration) {
    parts_->decoration = decoration;
}

bool FilmMaker::has_drawn_the_making() const {
    return parts_->drawn >= parts_->pictures_of_the_making();
}

std::size_t FilmMaker::picture_count() const {
    return parts_->plan.size();
}

std::size_t FilmMaker::pictures_drawn() const {
    return parts_->drawn;
}

const asset::Image& FilmMaker::picture() const {
    return parts_->picture;
}

Result<std::vector<std::byte>> FilmMaker::still() const {
    const asset::Image& image = parts_->still;
    auto film = asset::WebpFilm::create({image.width, image.height, kStillQuality});
    if (!film) return film.error();
    if (auto added = film->add(image, kFilmPictureMs); !added) return added.error();
    return film->finish();
}

Result<std::vector<std::byte>> FilmMaker::take() {
    if (auto closed = parts_->camera->close(); !closed) return closed.error();
    std::size_t least = 0;
    for (asset::WebpFilm& film : parts_->films) {
        auto file = film.finish();
        if (!file || file->size() <= parts_->desc.most_bytes) return file;
        least = file->size();
    }
    return bad_input(
        fmt::format("film: expected at most {} bytes, found {} in the lowest quality: a smaller size or "
                    "fewer seconds fit",
                    parts_->desc.most_bytes, least));
}

Result<std::vector<std::byte>> FilmMaker::take_mp4() {
    if (!parts_->mp4) return parts_->mp4.error();
    Result<std::vector<std::byte>> file(Error{});
    for (asset::Mp4Film& film : *parts_->mp4) {
        file = film.finish();
        if (!file || static_cast<double>(file->size()) <= kMp4BytesPerS * parts_->desc.seconds) break;
    }
    return file;
}

}  // namespace onggi::app
