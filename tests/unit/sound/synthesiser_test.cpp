// The wheel's sound, listened to offline: no device, no thread, no clock.
#include "engine/sound/synthesiser.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "engine/core/hash.h"
#include "tests/unit/sound/listening.h"

namespace onggi::sound {
namespace {

using testing::brightness_hz;
using testing::largest_step;
using testing::left_of;
using testing::level_db;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr SoundScene kTurning{.rev_min = 120.0, .volume = 1.0};
constexpr SoundScene kPressing{
    .rev_min = 120.0, .contact_n = 1.0, .slip_mm_s = 700.0, .wetness = 0.8, .volume = 1.0};

std::vector<Sample> played(Synthesiser& synthesiser, const SoundScene& scene, double seconds) {
    std::vector<Sample> samples(static_cast<std::size_t>(seconds * kSampleRateHz));
    synthesiser.render(scene, samples);
    return samples;
}
// Half a second of samples, after all parameters have settled.
std::vector<double> heard(const SoundScene& scene) {
    Synthesiser synthesiser;
    played(synthesiser, scene, 0.6);
    return left_of(played(synthesiser, scene, 0.5));
}

struct SynthesiserTest : ::testing::Test {
    Synthesiser synthesiser;
};

TEST_F(SynthesiserTest, IsExactlySilentWhenNothingMoves) {
    for (const double sample : heard({.volume = 1.0}))
        ASSERT_EQ(sample, 0.0);
    played(synthesiser, kPressing, 1.0);
    played(synthesiser, {.volume = 1.0}, 4.0);
    for (const double sample : left_of(played(synthesiser, {.volume = 1.0}, 0.1)))
        ASSERT_EQ(sample, 0.0) << "and again after it has come to rest";
}

TEST_F(SynthesiserTest, RoarsLowAndUnevenlyWhileTheKilnBurns) {
    constexpr SoundScene kFiring{.fire_burns = true, .volume = 1.0};
    EXPECT_LT(level_db(heard(kFiring)), -18.0);
    EXPECT_GT(level_db(heard(kFiring)), -34.0);
    EXPECT_LT(brightness_hz(heard(kFiring)), brightness_hz(heard(kPressing)));
    EXPECT_LT(brightness_hz(heard(kFiring)), 300.0);
    played(synthesiser, kFiring, 1.0);
    const auto fading = left_of(played(synthesiser, {.volume = 1.0}, 6.0));
    EXPECT_LT(largest_step(fading), 0.02) << "no click";
    EXPECT_EQ(fading.back(), 0.0) << "and then exactly nothing";
}

TEST_F(SynthesiserTest, IsCalm) {
    for (const SoundScene& scene : {kTurning, kPressing}) {
        EXPECT_LT(level_db(heard(scene)), -18.0);
        EXPECT_GT(level_db(heard(scene)), -32.0);
    }
    SoundScene softer = kPressing;
    softer.volume = 0.25;
    EXPECT_NEAR(level_db(heard(kPressing)) - level_db(heard(softer)), 12.0, 2.0);
    softer.volume = 0.0;
    EXPECT_LT(level_db(heard(softer)), -100.0);
}

std::vector<double> right_of(const std::vector<Sample>& samples) {
    std::vector<double> right;
    for (const Sample& sample : samples)
        right.push_back(static_cast<double>(sample.right));
    return right;
}

TEST_F(SynthesiserTest, TestsOneLoudspeakerAfterTheOtherAndThenBothOnce) {
    played(synthesiser, {.chimes = 3, .volume = 1.0}, 0.5);
    for (const double sample : left_of(played(synthesiser, {.chimes = 3, .volume = 1.0}, 0.2)))
        ASSERT_EQ(sample, 0.0) << "what was asked for before it listened is no wish";
    const SoundScene asked{.chimes = 4, .volume = 1.0};
    const std::vector<Sample> first = played(synthesiser, asked, 0.4);
    const std::vector<Sample> second = played(synthesiser, asked, 0.4);
    const std::vector<Sample> both = played(synthesiser, asked, 0.4);
    EXPECT_GT(level_db(left_of(first)), -24.0);
    EXPECT_LT(level_db(right_of(first)), -90.0);
    EXPECT_LT(level_db(left_of(second)), -60.0);
    EXPECT_GT(level_db(right_of(second)), -24.0);
    EXPECT_GT(level_db(left_of(both)), -24.0);
    EXPECT_GT(level_db(right_of(both)), -24.0);
    EXPECT_LT(largest_step(left_of(first)), 0.03) << "no click";
    for (const double sample : left_of(played(synthesiser, asked, 0.2)))
        ASSERT_EQ(sample, 0.0);
}

TEST_F(SynthesiserTest, RisesWithTheWheel) {
    double last_hz = 0.0;
    for (const double rev_min : {30.0, 60.0, 120.0, 240.0}) {
        const double hz = brightness_hz(heard({.rev_min = rev_min, .volume = 1.0}));
        EXPECT_GT(hz, last_hz + 5.0) << rev_min;
        last_hz = hz;
    }
    EXPECT_LT(last_hz, 400.0) << "a hum, no whine";
}

TEST_F(SynthesiserTest, CarriesTheForceInLoudnessAndBrightness) {
    double last_db = level_db(heard(kTurning));
    double last_hz = brightness_hz(heard(kTurning));
    for (const double force_n : {0.3, 1.0, 3.0}) {
        SoundScene scene = kPressing;
        scene.contact_n = force_n;
        const auto sound = heard(scene);
        EXPECT_GT(level_db(sound), last_db + 0.5) << force_n;
        EXPECT_GT(brightness_hz(sound), last_hz + 50.0) << force_n;
        last_db = level_db(sound);
        last_hz = brightness_hz(sound);
    }
}

TEST_F(SynthesiserTest, IsSilentForATouchOnAStandingWheel) {
    EXPECT_LT(level_db(heard({.contact_n = 3.0, .wetness = 1.0, .volume = 1.0})), -100.0);
}

TEST_F(SynthesiserTest, MakesWetClayDarkAndAnEdgeBright) {
    SoundScene dry = kPressing;
    dry.wetness = 0.0;
    SoundScene wet = kPressing;
    wet.wetness = 1.0;
    SoundScene scraped = dry;
    scraped.is_hard_tool = true;
    EXPECT_LT(brightness_hz(heard(wet)), 0.7 * brightness_hz(heard(dry)));
    EXPECT_GT(brightness_hz(heard(scraped)), 1.5 * brightness_hz(heard(dry)));
}

TEST_F(SynthesiserTest, SlapsOncePerLump) {
    SoundScene scene{.slaps = 7, .volume = 1.0};
    EXPECT_LT(level_db(left_of(played(synthesiser, scene, 0.5))), -100.0) << "the first count is no slap";
    scene.slaps = 8;
    const auto slap = left_of(played(synthesiser, scene, 0.7));
    EXPECT_GT(level_db(slap), -32.0);
    EXPECT_LT(*std::max_element(slap.begin(), slap.end()), 0.6);
    EXPECT_LT(level_db(left_of(played(synthesiser, scene, 0.5))), -100.0) << "it is over";
}

TEST_F(SynthesiserTest, PlucksATautStringOnceHoweverLongItIsHeld) {
    SoundScene scene{.volume = 1.0};
    EXPECT_LT(level_db(left_of(played(synthesiser, scene, 0.2))), -100.0);
    scene.is_plucked = true;
    const auto pluck = left_of(played(synthesiser, scene, 0.4));
    EXPECT_GT(level_db(pluck), -40.0);
    EXPECT_GT(brightness_hz(pluck), 300.0);
    EXPECT_LT(level_db(left_of(played(synthesiser, scene, 0.5))), -100.0) << "still held, and over";
    scene.is_plucked = false;
    EXPECT_LT(level_db(left_of(played(synthesiser, scene, 0.2))), -100.0);
    scene.is_plucked = true;
    EXPECT_GT(level_db(left_of(played(synthesiser, scene, 0.4))), -40.0) << "the next one";
}

// A click is a step between samples far beyond those of the sound around it.
TEST_F(SynthesiserTest, NeverClicksHoweverTheSceneJumps) {
    double usual = 0.0;
    for (const SoundScene& scene : {kPressing, kTurning})
        usual = std::max(usual, largest_step(heard(scene)));
    SoundScene hard = kPressing;
    hard.contact_n = 6.0;
    usual = std::max(usual, largest_step(heard(hard)));
    std::vector<double> all;
    SoundScene scene;
    for (int change = 0; change < 60; ++change) {
        scene = change % 3 == 0 ? SoundScene{.slaps = scene.slaps} : change % 3 == 1 ? kTurning : hard;
        scene.slaps = static_cast<std::uint32_t>(change);
        scene.is_plucked = change % 2 == 0;
        scene.volume = change % 5 == 0 ? 0.0 : 1.0;
        for (const double sample : left_of(played(synthesiser, scene, 0.02 + 0.003 * change)))
            all.push_back(sample);
    }
    EXPECT_LT(largest_step(all), 1.5 * usual);
}

TEST_F(SynthesiserTest, StaysWithinItsBoundsForAnyInput) {
    for (const double wild : {1e300, -1e300, std::numeric_limits<double>::infinity(), kNan, -5.0}) {
        const SoundScene scene{.rev_min = wild,
                               .motor_load = wild,
                               .contact_n = wild,
                               .slip_mm_s = wild,
                               .wetness = wild,
                               .is_hard_tool = true,
                               .place = wild,
                               .volume = 1.0};
        for (const Sample& sample : played(synthesiser, scene, 0.5)) {
            ASSERT_LT(std::abs(sample.left), 1.0F);
            ASSERT_LT(std::abs(sample.right), 1.0F);
        }
    }
}

TEST_F(SynthesiserTest, IsHeardWhereTheToolIs) {
    SoundScene scene = kPressing;
    scene.place = 1.0;
    played(synthesiser, scene, 0.6);
    double left = 0.0;
    double right = 0.0;
    for (const Sample& sample : played(synthesiser, scene, 0.5)) {
        left += static_cast<double>(sample.left) * static_cast<double>(sample.left);
        right += static_cast<double>(sample.right) * static_cast<double>(sample.right);
    }
    EXPECT_GT(right, 1.5 * left);
}

TEST_F(SynthesiserTest, GivesTheSameSamplesHoweverTheyAreCutIntoBlocks) {
    Synthesiser whole;
    Synthesiser cut;
    const auto expected = played(whole, kPressing, 0.5);
    std::vector<Sample> found(expected.size());
    for (std::size_t at = 0, size = 1; at < found.size(); at += size, size = size % 700 + 13)
        cut.render(kPressing, std::span(found).subspan(at, std::min(size, found.size() - at)));
    for (std::size_t at = 0; at < found.size(); ++at)
        ASSERT_EQ(found[at].left, expected[at].left) << at;
}

// The same everywhere: both compilers, with and without optimisation.
TEST_F(SynthesiserTest, GivesTheSameSamplesOnEveryMachine) {
    StateHash hash;
    SoundScene scene = kPressing;
    for (std::uint32_t second = 0; second < 4; ++second) {
        scene.slaps = second;
        scene.is_hard_tool = second == 3;
        for (const Sample& sample : played(synthesiser, scene, 0.5))
            hash.add_word(std::bit_cast<std::uint32_t>(sample.left));
    }
    EXPECT_EQ(hash.value(), 0x9ddd24aa9456018eULL) << std::hex << hash.value();
}

}  // namespace
}  // namespace onggi::sound
