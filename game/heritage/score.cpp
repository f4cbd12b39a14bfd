#include "game/heritage/score.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "game/clay/studio/studio_parameters.h"

namespace onggi::heritage {
namespace {

using clay::studio::Rings;

// Used only for a target's amount of clay.
constexpr double kUsualFloorMm = 8.0;

// The outer radius at a height, interpolated between ring centres.
double outer_at(const Rings& rings, double y_mm) {
    const int ring = rings.ring_at(y_mm);
    const int other = std::clamp(y_mm < rings.centre_mm(ring) ? ring - 1 : ring + 1, 0, rings.count - 1);
    const double a = rings.outer_mm[Rings::at(ring)];
    const double b = rings.outer_mm[Rings::at(other)];
    const double apart = std::fabs(rings.centre_mm(other) - rings.centre_mm(ring));
    if (!(apart > 0.0)) return a;
    return a + (b - a) * std::fabs(y_mm - rings.centre_mm(ring)) / apart;
}

std::optional<double> mean_wall_mm(const Rings& rings) {
    double sum = 0.0;
    double height = 0.0;
    for (int i = 0; i < rings.count; ++i) {
        if (!rings.is_hollow(i)) continue;
        sum += rings.wall_mm(i) * rings.height_mm[Rings::at(i)];
        height += rings.height_mm[Rings::at(i)];
    }
    return height > 0.0 ? std::optional(sum / height) : std::nullopt;
}

// Mass of the wet pot at that scale of the museum's.
double wet_clay_g(const PotForm& form, double scale, double wall_mm) {
    double volume = 0.0;
    const double step = form.height_mm * scale / static_cast<double>(form.radii_mm.size() - 1);
    for (std::size_t i = 0; i + 1 < form.radii_mm.size(); ++i) {
        const double r = 0.5 * (form.radii_mm[i] + form.radii_mm[i + 1]) * scale;
        const double inner = static_cast<double>(i) * step < kUsualFloorMm ? 0.0 : std::max(r - wall_mm, 0.0);
        volume += kPi * (r * r - inner * inner) * step;
    }
    return volume * clay::studio::kDensityGPerMm3;
}

template <typename Visit>
double sum_over(const PotForm& form, Visit visit) {
    double sum = 0.0;
    for (std::size_t i = 0; i < form.radii_mm.size(); ++i) {
        const double y_mm =
            form.height_mm * static_cast<double>(i) / static_cast<double>(form.radii_mm.size() - 1);
        sum += visit(i, y_mm);
    }
    return sum;
}

}  // namespace

double PotForm::widest_mm() const {
    return 2.0 * *std::max_element(radii_mm.begin(), radii_mm.end());
}

PotForm form_of(const clay::StudioClay& clay) {
    const Rings& rings = clay.rings();
    const clay::ClayBody body = clay.lump().body;
    const double scale = clay::shrunk_scale(body, clay::Firing::kGlaze);
    const auto fired = clay::measure_pot(rings, body, clay::Firing::kGlaze);
    PotForm form;
    form.height_mm = fired.height_mm;
    for (std::size_t i = 0; i < kFormSamples; ++i) {
        const double y = rings.top_mm() * static_cast<double>(i) / static_cast<double>(kFormSamples - 1);
        form.radii_mm.push_back(outer_at(rings, y) * scale);
    }
    if (const auto wall = mean_wall_mm(rings)) form.wall_mm = *wall * scale;
    form.capacity_ml = fired.capacity_ml;
    form.mass_g = fired.mass_g;
    return form;
}

PotForm form_of(const Target& target) {
    PotForm form;
    form.height_mm = target.height_mm;
    for (std::size_t i = 0; i < kFormSamples; ++i) {
        form.radii_mm.push_back(target.radius_at(target.height_mm * static_cast<double>(i) /
                                                 static_cast<double>(kFormSamples - 1)));
    }
    form.wall_mm = target.wall_mm;
    form.mass_g = target.mass_g;
    return form;
}

ThrownSize thrown_size(const Target& target, clay::ClayBody body, const ThrownClay& clay) {
    struct Fraction {
        double value;
        const char* text;
        const char* part;
    };
    constexpr std::array<Fraction, 7> kFractions{{{1.0, "full size", "1"},
                                                  {3.0 / 4.0, "three quarters of its size", "3/4"},
                                                  {2.0 / 3.0, "two thirds of its size", "2/3"},
                                                  {1.0 / 2.0, "half size", "1/2"},
                                                  {1.0 / 3.0, "a third of its size", "1/3"},
                                                  {1.0 / 4.0, "a quarter of its size", "1/4"},
                                                  {1.0 / 5.0, "a fifth of its size", "1/5"}}};
    const PotForm form = form_of(target);
    const double wet = clay::wet_scale_of_fired(body);
    for (const auto& [fraction, text, part] : kFractions) {
        const double scale = fraction * wet;
        const bool fits = 0.5 * form.widest_mm() * scale <= 0.97 * clay::studio::kWidestMm &&
                          form.height_mm * scale <= 0.97 * clay::studio::kTallestMm &&
                          wet_clay_g(form, scale, clay.wall_mm) <= clay.most_g;
        if (fits || fraction == kFractions.back().value) return {fraction, scale, text, part};
    }
    return {};
}

Score score(const PotForm& pot, const Target& target, clay::ClayBody body) {
    Score result;
    result.size = thrown_size(target, body);
    const double fraction = result.size.fraction;
    const auto scaled = [](const std::optional<double>& value, double scale) {
        return value ? std::optional(*value * scale) : std::nullopt;
    };
    result.measures = {{"height_mm", pot.height_mm, target.height_mm * fraction},
                       {"widest_mm", pot.widest_mm(), scaled(target.max_diameter_mm, fraction)},
                       {"mouth_mm", pot.mouth_mm(), scaled(target.mouth_mm, fraction)},
                       {"foot_mm", pot.foot_mm(), scaled(target.foot_mm, fraction)}};
    if (pot.wall_mm) result.measures.push_back({"wall_mm", *pot.wall_mm, scaled(target.wall_mm, fraction)});
    double off = 0.0;
    int lengths = 0;
    for (const Measure& measure : result.measures) {
        if (!measure.target) continue;
        off += std::fabs(measure.pot - *measure.target);
        ++lengths;
    }
    result.mean_off_mm = off / lengths;
    if (pot.capacity_ml) result.measures.push_back({"capacity_ml", *pot.capacity_ml, std::nullopt});
    if (pot.mass_g) {
        result.measures.push_back(
            {"mass_g", *pot.mass_g, scaled(target.mass_g, fraction * fraction * fraction)});
    }

    result.profile_rms_mm = profile_rms_mm(pot, target, fraction);
    for (const OutlinePoint& point : target.outline)
        ++(point.published ? result.published_points : result.drawn_points);
    return result;
}

double profile_rms_mm(const PotForm& pot, const Target& target, double fraction) {
    const PotForm drawn = form_of(target);
    const double squares = sum_over(pot, [&](std::size_t i, double /*y_mm*/) {
        const double difference = pot.radii_mm[i] - drawn.radii_mm[i] * fraction;
        return difference * difference;
    });
    return std::sqrt(squares / static_cast<double>(pot.radii_mm.size()));
}

double unlikeness(const PotForm& a, const PotForm& b) {
    const double per_step = 1.0 / static_cast<double>(a.radii_mm.size() - 1);
    const auto product = [&](const PotForm& p, const PotForm& q) {
        return sum_over(p, [&](std::size_t i, double y_mm) {
            return p.radii_mm[i] * q.radii_mm[i] + y_mm * q.height_mm * static_cast<double>(i) * per_step;
        });
    };
    const double cosine = product(a, b) / std::sqrt(product(a, a) * product(b, b));
    return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

Nearest nearest(const PotForm& pot, std::span<const Target> targets) {
    Nearest best{0, 2.0};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double unlike = unlikeness(pot, form_of(targets[i]));
        if (unlike < best.unlikeness) best = {i, unlike};
    }
    return best;
}

std::string report(const Score& score, const Target& target) {
    std::string text = fmt::format("{}\nthrown at {}, fired:\n", sentence(target), score.size.text);
    for (const Measure& measure : score.measures) {
        text += fmt::format("  {:<12} {:8.1f}", measure.name, measure.pot);
        text += measure.target ? fmt::format("   the museum's {:8.1f}   {:+8.1f}\n", *measure.target,
                                             measure.pot - *measure.target)
                               : "   not published\n";
    }
    text += fmt::format("  profile      {:8.1f} mm RMS from an outline of {} published and {} drawn points\n",
                        score.profile_rms_mm, score.published_points, score.drawn_points);
    text += fmt::format("  off by       {:8.1f} mm, mean over the published measures\n", score.mean_off_mm);
    return text;
}

}  // namespace onggi::heritage
