// The film of a session against the screenshots of its ticks.
#include "game/app/replay/film.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "game/app/command_line/performance.h"
#include "game/app/command_line/throw_outputs.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/session_marks.h"
#include "game/haptic/pot_copy.h"
#include "tests/support/mp4_frames.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/webp_frames.h"

namespace onggi::app {
namespace {

const std::string kTwoHands = test::in_checkout("tests/replay/sessions/two-hands-250hz.onggi");
constexpr int kWidth = 160;
constexpr int kHeight = 120;

LoadedSession two_hands() {
    auto session = load_session(kTwoHands);
    if (!session) throw std::runtime_error(session.error().message);
    return std::move(session).value();
}

FilmDesc short_film() {
    return {.width = kWidth, .height = kHeight, .seconds = 1.0};
}

std::unique_ptr<FilmMaker> maker_of(const FilmDesc& desc) {
    LoadedSession loaded = two_hands();
    auto maker = FilmMaker::create(std::move(loaded.session), std::move(loaded.start), desc);
    if (!maker) throw std::runtime_error(maker.error().message);
    return std::move(maker).value();
}

// Draws the whole film.
std::vector<asset::Image> drawn_by(FilmMaker& maker) {
    std::vector<asset::Image> drawn;
    for (bool goes_on = true; goes_on;) {
        const auto worked = maker.work();
        EXPECT_TRUE(worked) << worked.error().message;
        goes_on = worked && *worked;
        if (maker.pictures_drawn() > drawn.size()) drawn.push_back(maker.picture());
    }
    return drawn;
}

// A band of iron half way up the session's pot.
decoration::Recorded iron_band() {
    LoadedSession loaded = two_hands();
    Replay replay(loaded.session, std::move(loaded.start));
    while (!replay.is_over())
        EXPECT_FALSE(replay.step());
    decoration::Canvas canvas(wall_of(haptic::pot_of(replay.state())));
    decoration::Stroke band{.technique = decoration::Technique::kIron, .width = 1200};
    for (int i = 0; i <= 32; ++i) {
        band.points.push_back(
            decoration::stroke_point(i / 32.0, 0.5 * double{canvas.wall().height_mm}).value());
    }
    EXPECT_TRUE(canvas.begin(band));
    return canvas.recorded();
}

// The picture of `throw --screenshot` after `ticks` ticks of the session.
asset::Image screenshot_after(std::uint64_t ticks) {
    const test::TemporaryFolder folder;
    auto performance = load_performance({.file = kTwoHands});
    if (!performance) throw std::runtime_error(performance.error().message);
    ThrowOutputs outputs;
    outputs.screenshot = (folder / "p.png").string();
    outputs.size = {kWidth, kHeight};
    auto writer = OutputWriter::create(outputs, performance->start);
    haptic::HapticState& state = performance->start.state;
    const auto& parameters = performance->start.parameters;
    haptic::TickResult last;
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        last = haptic::tick(state, performance->player->read_tool(tick, parameters.dt_s()), parameters);
        EXPECT_TRUE(writer->add_tick(state, last));
    }
    const auto finished = writer->finish(state, last, {});
    if (!finished) throw std::runtime_error(finished.error().message);
    const std::string file = test::content_of(folder / "p.png");
    auto image = asset::decode_png(std::as_bytes(std::span(file.data(), file.size())), "p.png");
    if (!image) throw std::runtime_error(image.error().message);
    return std::move(image).value();
}

TEST(Film, ShowsTheScreenshotsOfItsTicksToTheByteAndPacksThemInTheirOrder) {
    const auto maker = maker_of(short_film());
    const auto plan = film_plan(two_hands().session.tick_count(), 1.0);
    ASSERT_EQ(maker->picture_count(), plan.size());
    const std::vector<asset::Image> drawn = drawn_by(*maker);
    ASSERT_EQ(drawn.size(), plan.size());
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}, std::size_t{9}}) {
        ASSERT_FALSE(plan[at].is_finished);
        EXPECT_TRUE(drawn[at] == screenshot_after(plan[at].ticks)) << at;
    }
    EXPECT_FALSE(drawn[4] == drawn[9]);

    auto film = maker->take();
    ASSERT_TRUE(film) << film.error().message;
    const test::WebpFrames frames = test::webp_frames(*film);
    ASSERT_EQ(frames.images.size(), drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        EXPECT_LT(test::mean_difference(frames.images[i], drawn[i]), 3.0) << i;
        EXPECT_EQ(frames.ends_ms[i], kFilmPictureMs * static_cast<int>(i + 1));
    }
}

TEST(Film, AsMp4PassesOverIntoItsFirstPictureAndHasThePicturesOfTheWebp) {
    FilmDesc desc = short_film();
    desc.quick = desc.as_mp4 = true;
    desc.seconds = 4.0;
    const auto maker = maker_of(desc);
    const std::vector<asset::Image> drawn = drawn_by(*maker);
    const auto webp = maker->take();
    const auto mp4 = maker->take_mp4();
    ASSERT_TRUE(webp && mp4);
    const test::Mp4Frames frames = test::mp4_frames(*mp4);
    ASSERT_EQ(frames.images.size(), drawn.size());
    EXPECT_EQ(frames.lasts_ms, test::webp_frames(*webp).ends_ms.back());
    // A third of the finished pot's twelve pictures passes over.
    for (std::size_t i = 0; i + 4 < drawn.size(); ++i)
        EXPECT_LT(test::mean_difference(frames.images[i], drawn[i]), 3.0) << i;
    EXPECT_LT(test::mean_difference(frames.images.back(), drawn.front()),
              test::mean_difference(frames.images.back(), drawn.back()));
}

// The kiosk's film is WebP all the same.
TEST(Film, WithoutAnMp4SaysSoAndIsWhole) {
    FilmDesc desc = short_film();
    desc.quick = true;
    const auto maker = maker_of(desc);
    drawn_by(*maker);
    EXPECT_FALSE(maker->take_mp4());
    EXPECT_TRUE(maker->take());
}

// Draws the whole film. Returns the file.
Result<std::vector<std::byte>> film_of(const FilmDesc& desc) {
    const auto maker = maker_of(desc);
    for (bool goes_on = true; goes_on;) {
        const auto worked = maker->work();
        if (!worked) return worked.error();
        goes_on = *worked;
    }
    return maker->take();
}

TEST(Film, StaysBelowItsBytesInALowerQualityOrSaysThatItCannot) {
    FilmDesc desc = short_film();
    desc.quick = true;
    const auto best = film_of(desc);
    ASSERT_TRUE(best);
    EXPECT_EQ(*best, *film_of(desc)) << "the same session, the same film";
    desc.most_bytes = best->size() / 2;
    const auto smaller = film_of(desc);
    ASSERT_TRUE(smaller);
    EXPECT_LE(smaller->size(), desc.most_bytes);
    EXPECT_EQ(test::webp_frames(*smaller).images.size(), test::webp_frames(*best).images.size());
    desc.most_bytes = 1000;
    const auto none = film_of(desc);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(none.error().message.find("expected at most 1000 bytes"), std::string::npos);
}

// At the size of the kiosk's films.
TEST(Film, DrawnQuicklyShowsTheSame) {
    FilmDesc desc = short_film();
    desc.width = 480;
    desc.height = 360;
    const auto fine = test::webp_frames(*film_of(desc));
    desc.quick = true;
    const auto film = test::webp_frames(*film_of(desc));
    ASSERT_EQ(film.images.size(), fine.images.size());
    for (std::size_t i = 0; i < film.images.size(); ++i)
        EXPECT_LT(test::mean_difference(film.images[i], fine.images[i]), 2.0) << i;
}

// As the film holds it, but for the sixteen steps below black (Rec. ITU-R BT.601).
std::vector<double> brightness(const asset::Image& image) {
    constexpr double kScale = 219.0 / 255.0;
    std::vector<double> bright;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        bright.push_back(kScale *
                         (0.299 * image.rgba[i] + 0.587 * image.rgba[i + 1] + 0.114 * image.rgba[i + 2]));
    return bright;
}

// The mean over windows of 8x8 pixels, four apart, of brightness (Wang, Bovik, Sheikh, Simoncelli, 2004).
double ssim(const asset::Image& one, const asset::Image& other) {
    constexpr int kSide = 8;
    constexpr double kCount = kSide * kSide;
    constexpr double kDark = 0.01 * 255 * 0.01 * 255;
    constexpr double kFlat = 0.03 * 255 * 0.03 * 255;
    const std::vector<double> a = brightness(one);
    const std::vector<double> b = brightness(other);
    double sum = 0.0;
    int windows = 0;
    for (int top = 0; top + kSide <= one.height; top += kSide / 2) {
        for (int left = 0; left + kSide <= one.width; left += kSide / 2, ++windows) {
            double of_a = 0.0;
            double of_b = 0.0;
            double squares = 0.0;
            double products = 0.0;
            for (int k = 0; k < kSide * kSide; ++k) {
                const auto at = static_cast<std::size_t>((top + k / kSide) * one.width + left + k % kSide);
                of_a += a[at] / kCount;
                of_b += b[at] / kCount;
                squares += (a[at] * a[at] + b[at] * b[at]) / kCount;
                products += a[at] * b[at] / kCount;
            }
            const double both = of_a * of_a + of_b * of_b;
            sum += (2.0 * of_a * of_b + kDark) * (2.0 * (products - of_a * of_b) + kFlat) /
                   ((both + kDark) * (squares - both + kFlat));
        }
    }
    return sum / windows;
}

// Its ridges are finer than a pixel: the hardest pot for an encoder.
TEST(Film, OfACollapseIsFineWithinTheBytesOfAPhone) {
    auto loaded = load_session(test::in_checkout("assets/demonstrations/collapse.onggi"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    auto maker = FilmMaker::create(std::move(loaded->session), std::move(loaded->start),
                                   {.quick = true, .as_mp4 = true});
    ASSERT_TRUE(maker) << maker.error().message;
    (*maker)->finish_in(*finish::find_glaze("ash"));
    const std::vector<asset::Image> drawn = drawn_by(**maker);
    const auto film = (*maker)->take_mp4();
    ASSERT_TRUE(film) << film.error().message;
    EXPECT_LE(film->size(), 400'000U);
    const std::vector<asset::Image> shown = test::mp4_frames(*film).images;
    ASSERT_EQ(shown.size(), drawn.size());
    const std::size_t passing = 6;  // the last pictures, which pass over into the first
    double sum = 0.0;
    for (std::size_t i = 0; i + passing < drawn.size(); ++i)
        sum += ssim(shown[i], drawn[i]);
    EXPECT_GE(sum / static_cast<double>(drawn.size() - passing), 0.99);
}

TEST(Film, RejectsALengthAndASizeThatCannotBe) {
    for (FilmDesc desc : {FilmDesc{.seconds = 0.5}, FilmDesc{.seconds = 61.0},
                          FilmDesc{.seconds = std::nan("")}, FilmDesc{.width = 8}}) {
        LoadedSession loaded = two_hands();
        const auto maker = FilmMaker::create(std::move(loaded.session), std::move(loaded.start), desc);
        ASSERT_FALSE(maker);
        EXPECT_EQ(maker.error().kind, ErrorKind::kBadInput);
    }
}

TEST(Film, ShowsTheDecorationOnlyOnTheFinishedPot) {
    const auto last_of = [](bool decorates, asset::Image& making) {
        const auto maker = maker_of(short_film());
        maker->finish_in(*finish::find_glaze("porcelain"));
        if (decorates) maker->decorate(iron_band());
        for (bool goes_on = true; goes_on;) {
            const bool made = maker->has_drawn_the_making();
            const auto worked = maker->work();
            EXPECT_TRUE(worked);
            goes_on = worked && *worked;
            if (!made) making = maker->picture();
        }
        return maker->picture();
    };
    asset::Image plain_making;
    asset::Image drawn_making;
    const asset::Image plain = last_of(false, plain_making);
    const asset::Image drawn = last_of(true, drawn_making);
    EXPECT_EQ(plain_making.rgba, drawn_making.rgba);
    int darker = 0;
    for (std::size_t i = 0; i < plain.rgba.size(); i += 4)
        darker += plain.rgba[i] > drawn.rgba[i] + 40 ? 1 : 0;
    EXPECT_GT(darker, 40);
}

}  // namespace
}  // namespace onggi::app
