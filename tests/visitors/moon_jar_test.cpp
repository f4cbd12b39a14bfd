// Visitors who make a moon jar: two bowls each, following the shown outline and the bowl set aside, joined
// with a random offset. The jar is judged.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "game/clay/studio/joining.h"
#include "game/heritage/jar.h"
#include "tests/support/places.h"
#include "tests/visitors/kiosk_rig.h"
#include "tests/visitors/population.h"

namespace onggi::visitors {
namespace {

constexpr double kMostRmsMm = 8.0;
constexpr double kShareThatDo = 0.8;

struct Jar {
    double rims_mm = 0.0;
    double rms_mm = 0.0;
    double load = 0.0;
    double capacity_ml = 0.0;
    double belly = 0.0;  // height of the widest point, as a fraction
    double off_round_mm = 0.0;
    double ledger_error_mm3 = 0.0;
    bool stands = false;
    std::string why_not{};
    double seconds = 0.0;
};

std::vector<dvec2> outline_of(const clay::StudioClay& bowl, std::size_t points) {
    std::vector<dvec2> outline;
    for (std::size_t i = 0; i <= points; ++i) {
        const double y_mm = bowl.height_mm() * static_cast<double>(i) / static_cast<double>(points);
        const int ring = bowl.rings().ring_at(y_mm);
        outline.emplace_back(bowl.outer_mm()[static_cast<std::size_t>(ring)], y_mm);
    }
    return outline;
}

clay::StudioClay throw_bowl(std::uint64_t seed, const std::vector<dvec2>& shown, double& seconds) {
    KioskRig rig(clay::StudioLump{}.mass_g);
    rig.show_outline(shown);
    seconds += throw_a_pot(Kind::kFollowsOutline, seed, {}, rig, shown).seconds;
    return rig.clay();
}

// Turns the jar for ten seconds without a touch.
void stand(clay::StudioClay& jar) {
    constexpr int kTicks = 10'000;
    clay::StudioParameters parameters;
    parameters.rate_hz = 1000.0;
    parameters.forgiving = true;
    const tool::ToolState away{
        .position_mm = {0.0, 400.0, 0.0}, .wheel_button = true, .wheel_speed_rev_min = 76.4};
    for (int tick = 0; tick < kTicks; ++tick)
        jar.tick(away, parameters);
}

Jar make_jar(const heritage::Target& target, std::uint64_t seed) {
    constexpr std::size_t kPoints = 40;
    const heritage::JarOfTwo after = heritage::jar_of(target);
    Jar made;
    const std::vector<dvec2> shown(after.bowl_mm.begin(), after.bowl_mm.end());
    const clay::StudioClay first = throw_bowl(2 * seed, shown, made.seconds);
    const clay::StudioClay second = throw_bowl(2 * seed + 1, outline_of(first, kPoints), made.seconds);
    made.rims_mm = std::fabs(clay::rim_step_mm(second, first));
    std::mt19937_64 chance(seed);
    const double shift_mm = std::normal_distribution<double>(0.0, 2.0)(chance);
    auto jar = clay::join_pots(
        second, first,
        {.bore_mm = clay::bore_at_width_mm(first, after.mouth_mm), .shift_mm = {shift_mm, 0.0}});
    if (!jar) {
        made.why_not = jar.error().message;
        return made;
    }
    const double height_mm = jar->height_mm();
    stand(*jar);
    made.stands = jar->failure().cause == clay::studio::Cause::kNone && jar->height_mm() > 0.98 * height_mm;
    made.load = jar->load_index();
    made.ledger_error_mm3 = jar->ledger_error_mm3();
    made.off_round_mm = heritage::off_round_mm(*jar);
    const heritage::PotForm form = heritage::form_of(*jar);
    const heritage::PotForm museums = heritage::form_of(target);
    made.capacity_ml = form.capacity_ml.value_or(0.0);
    const auto widest = std::max_element(form.radii_mm.begin(), form.radii_mm.end());
    made.belly = static_cast<double>(widest - form.radii_mm.begin()) / heritage::kFormSamples;
    double squares = 0.0;
    for (std::size_t i = 0; i < heritage::kFormSamples; ++i) {
        const double off = form.radii_mm[i] - museums.radii_mm[i] * after.size.fraction;
        squares += off * off;
    }
    made.rms_mm = std::sqrt(squares / heritage::kFormSamples);
    return made;
}

TEST(MoonJar, IsMadeByFourOfFiveVisitors) {
    constexpr int kCount = 20;
    constexpr double kLeastMl = 500.0;
    const auto targets = heritage::load_targets(test::in_checkout("assets/heritage"));
    ASSERT_TRUE(targets) << targets.error().message;
    for (const heritage::Target& target : *targets) {
        if (!heritage::is_of_two_bowls(target) || target.id == "moon-jar-bm") continue;  // not on the shelf
        int made = 0;
        std::string words;
        std::vector<double> seconds;
        for (int seed = 1; seed <= kCount; ++seed) {
            const Jar jar = make_jar(target, static_cast<std::uint64_t>(seed));
            EXPECT_EQ(jar.ledger_error_mm3, 0.0) << target.id << " seed " << seed;
            const bool is_round_bellied = jar.belly > 0.3 && jar.belly < 0.7;
            const bool is_jar =
                jar.stands && is_round_bellied && jar.capacity_ml > kLeastMl && jar.rms_mm <= kMostRmsMm;
            made += is_jar ? 1 : 0;
            seconds.push_back(jar.seconds);
            words += fmt::format(
                "seed {}: rims {:.1f} mm apart, {:.1f} mm RMS, load {:.2f}, {:.0f} ml, widest at {:.2f}, "
                "{:.1f} mm off round, {:.0f} s {}\n",
                seed, jar.rims_mm, jar.rms_mm, jar.load, jar.capacity_ml, jar.belly, jar.off_round_mm,
                jar.seconds, is_jar ? "" : "NO: " + jar.why_not);
        }
        std::nth_element(seconds.begin(), seconds.begin() + kCount / 2, seconds.end());
        RecordProperty(target.id + "_made", made);
        RecordProperty(target.id + "_median_s", static_cast<int>(seconds[kCount / 2]));
        EXPECT_GE(made, static_cast<int>(kShareThatDo * kCount)) << target.id << "\n" << words;
        fmt::print("{}: {} of {}, half of them within {:.0f} s\n{}", target.id, made, kCount,
                   seconds[kCount / 2], words);
    }
}

}  // namespace
}  // namespace onggi::visitors
