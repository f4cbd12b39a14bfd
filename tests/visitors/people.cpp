#include "tests/visitors/people.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace onggi::visitors {
namespace {

class Person {
  public:
    Person(std::uint64_t seed, const Skill& skill, WheelRig& rig, double side)
        : random_(seed * 7919 + 17),
          skill_(skill),
          rig_(rig),
          side_(side) {}

    [[nodiscard]] double uniform(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    [[nodiscard]] double normal(double deviation) {
        return std::normal_distribution<double>(0.0, deviation)(random_);
    }
    [[nodiscard]] bool happens(double chance) { return uniform(0.0, 1.0) < chance; }

    [[nodiscard]] WheelRig& wheel() { return rig_; }
    [[nodiscard]] double seconds() const { return seconds_; }
    [[nodiscard]] double released_s() const { return released_s_; }

    // A random aiming error in each direction. Two separate statements, because the evaluation order of
    // arguments depends on the compiler, and a seed must be the same person with each.
    [[nodiscard]] dvec2 miss_mm(double deviation_mm) {
        const double up = normal(deviation_mm);
        const double out = normal(deviation_mm);
        return {out, up};
    }

    // Waits, as if looking, and moves the pointer a little.
    void wait(double seconds) {
        for (double t = 0.0; t < seconds; t += kFrameS)
            frame(at_ + miss_mm(0.3), false);
    }

    // Moves there without pressing.
    void reach(const dvec2& place, double seconds = 0.5) {
        const dvec2 from = at_;
        for (double t = 0.0; t < seconds; t += kFrameS)
            frame(from + (place - from) * (t / seconds), false);
    }

    // Presses along `way` in `seconds`, with aiming errors at the ends and deviations on the way. Radii are
    // negative beyond the axis.
    void stroke(std::vector<dvec2> way, double seconds) {
        for (dvec2& place : way)
            place.x *= side_;
        const dvec2 miss_first = miss_mm(skill_.aim_mm);
        const dvec2 miss_last = miss_mm(skill_.aim_mm);
        const double phase_x = uniform(0.0, 6.3);
        const double phase_y = uniform(0.0, 6.3);
        const double turns = uniform(1.0, 3.0);
        std::vector<double> along{0.0};
        for (std::size_t i = 1; i < way.size(); ++i)
            along.push_back(along.back() + glm::length(way[i] - way[i - 1]) + 1e-6);
        reach(way.front() + miss_first, uniform(0.3, 0.7));
        for (double t = 0.0; t < seconds; t += kFrameS) {
            // Hands start and stop softly.
            const double u = t / seconds;
            const double fraction = u * u * (3.0 - 2.0 * u);
            const double wanted = fraction * along.back();
            std::size_t i = 1;
            while (i + 1 < way.size() && along[i] < wanted)
                ++i;
            dvec2 place = way.front();
            if (way.size() > 1) {
                const double part = std::clamp((wanted - along[i - 1]) / (along[i] - along[i - 1]), 0.0, 1.0);
                place = way[i - 1] + (way[i] - way[i - 1]) * part;
            }
            const double swing = 2.0 * std::numbers::pi * turns * u;
            place += miss_first * (1.0 - fraction) + miss_last * fraction +
                     dvec2(std::sin(swing + phase_x), std::sin(swing + phase_y)) * skill_.wander_mm;
            frame(place, true);
        }
        released_s_ = seconds_;
        frame(at_, false);
        wait(uniform(0.3, 1.2));
    }

    void note_progress() {
        if (made_s < 0.0 && rig_.depth_mm() > 18.0 && (rig_.height_mm() > 75.0)) made_s = seconds_;
    }

    // Moves to the button at the lower right and waits before pressing.
    void go_to_done() {
        reach(dvec2(150.0, -60.0), 1.0);
        wait(1.5);
    }

    double made_s = -1.0;

  private:
    void frame(const dvec2& place, bool pressed) {
        at_ = place;
        rig_.frame(place, pressed);
        seconds_ += kFrameS;
    }

    std::mt19937_64 random_;
    Skill skill_;
    WheelRig& rig_;
    double side_;
    dvec2 at_{170.0, 120.0};
    double seconds_ = 0.0;
    double released_s_ = 0.0;
};

// The steps of the lesson as the ghost hand shows them.
void press_in(Person& person, double seconds) {
    WheelRig& wheel = person.wheel();
    const double y = std::max(0.3 * wheel.height_mm(), 8.0);
    const double r = wheel.outer_mm(y);
    person.stroke({{r + person.uniform(0.0, 8.0), y}, {r - person.uniform(8.0, 16.0), y}}, seconds);
}

void press_middle(Person& person, double seconds) {
    WheelRig& wheel = person.wheel();
    const double top = wheel.height_mm();
    const double down = person.uniform(0.5, 0.9) * std::max(top, 30.0);
    person.stroke({{0.0, top + person.uniform(-4.0, 4.0)}, {0.0, top - down}}, seconds);
}

void pull_wall(Person& person, double seconds) {
    WheelRig& wheel = person.wheel();
    const double y = person.uniform(0.15, 0.35) * wheel.height_mm();
    const double top = wheel.height_mm();
    const double rim = wheel.outer_mm(top - 2.0);
    const double over = person.uniform(15.0, 60.0);
    person.stroke({{wheel.outer_mm(y) + person.uniform(-2.0, 4.0), y}, {rim, top}, {rim, top + over}},
                  seconds);
}

void follow_lesson(Person& person, double longest_s) {
    WheelRig& wheel = person.wheel();
    const double start = wheel.height_mm();
    const double foot = wheel.outer_mm(8.0);
    const auto pace = [&](double least, double most) {
        return std::min(person.uniform(least, most), longest_s);
    };
    person.wait(person.uniform(0.5, 2.0));
    for (int i = 0; i < 12 && wheel.depth_mm() < 18.0; ++i) {
        if (foot - wheel.outer_mm(8.0) > 3.0 || wheel.height_mm() > start + 6.0) break;
        press_in(person, pace(1.0, 3.0));
    }
    for (int i = 0; i < 14 && wheel.depth_mm() < 18.0; ++i)
        press_middle(person, pace(1.0, 3.0));
    person.note_progress();
    const double opened = wheel.height_mm();
    const int wanted = 1 + static_cast<int>(person.uniform(0.0, 3.0));
    int pulls = 0;
    while (pulls < 24 && (pulls < wanted || wheel.height_mm() < std::max(1.4 * opened, 75.0))) {
        pull_wall(person, pace(1.5, 4.0));
        person.note_progress();
        ++pulls;
    }
}

void press_top_first(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const int presses = 1 + static_cast<int>(person.uniform(0.0, 2.0));
    for (int i = 0; i < presses; ++i) {
        const double top = wheel.height_mm();
        const double r = person.uniform(0.0, 0.5) * wheel.outer_mm(0.5 * top);
        const double seconds = person.uniform(1.0, 3.0);
        person.stroke({{r, top + 2.0}, {r, top - person.uniform(10.0, 30.0)}}, seconds);
    }
    for (int i = 0; i < 8 && wheel.depth_mm() < 18.0; ++i)
        press_middle(person, person.uniform(1.0, 3.0));
    for (int i = 0; i < 10 && wheel.height_mm() < 75.0; ++i) {
        pull_wall(person, person.uniform(1.5, 4.0));
        person.note_progress();
    }
    pull_wall(person, person.uniform(1.5, 4.0));
    person.note_progress();
}

void pull_outside(Person& person) {
    person.wait(1.0);
    const int pulls = 3 + static_cast<int>(person.uniform(0.0, 4.0));
    for (int i = 0; i < pulls; ++i) {
        pull_wall(person, person.uniform(1.5, 4.0));
        person.note_progress();
    }
}

// A closed curve through those radii at shares of the height, sampled.
std::vector<dvec2> outline_through(const std::vector<dvec2>& knots, double height) {
    std::vector<dvec2> outline;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
        const double fraction = static_cast<double>(i) / kSteps;
        std::size_t k = 1;
        while (k + 1 < knots.size() && knots[k].y < fraction)
            ++k;
        const double u = std::clamp((fraction - knots[k - 1].y) / (knots[k].y - knots[k - 1].y), 0.0, 1.0);
        const double smooth = u * u * (3.0 - 2.0 * u);
        outline.emplace_back(knots[k - 1].x + (knots[k].x - knots[k - 1].x) * smooth, fraction * height);
    }
    return outline;
}

// The intended size scales with the visible clay: 1 for the 62 mm of a kilogram.
double size_seen(const WheelRig& wheel) {
    return wheel.outer_mm(0.3 * wheel.height_mm()) / 62.0;
}

std::vector<dvec2> bowl_of(Person& person) {
    const double size = size_seen(person.wheel());
    const double foot = size * person.uniform(34.0, 46.0);
    const double rim = size * person.uniform(58.0, 84.0);
    const double height = size * person.uniform(64.0, 92.0);
    std::vector<dvec2> outline;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
        // A quarter of a superellipse, with a foot.
        const double u = static_cast<double>(i) / kSteps;
        const double bend = std::sqrt(1.0 - (1.0 - u) * (1.0 - u));
        outline.emplace_back(foot + (rim - foot) * (0.5 * u + 0.5 * bend), u * height);
    }
    return outline;
}

std::vector<dvec2> vase_of(Person& person) {
    const double size = size_seen(person.wheel());
    const double foot = size * person.uniform(36.0, 46.0);
    const double belly = size * person.uniform(48.0, 62.0);
    const double neck = size * person.uniform(26.0, 36.0);
    const double lip = neck + person.uniform(2.0, 9.0);
    const double middle = person.uniform(0.38, 0.52);
    return outline_through({{foot, 0.0}, {belly, middle}, {neck, 0.86}, {lip, 1.0}},
                           size * person.uniform(110.0, 160.0));
}

// How far the seen outline is from the meant one, RMS over its height.
double seen_error_mm(const WheelRig& wheel, const std::vector<dvec2>& outline) {
    double sum = 0.0;
    int count = 0;
    for (const dvec2& point : outline) {
        if (point.y < 4.0) continue;
        const double radius = point.y <= wheel.height_mm() ? wheel.outer_mm(point.y) : 0.0;
        sum += (radius - point.x) * (radius - point.x);
        ++count;
    }
    return std::sqrt(sum / count);
}

std::vector<dvec2> draw(Person& person, const std::vector<dvec2>& outline) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    for (int i = 0; i < 10; ++i) {
        const double over = wheel.height_mm() - outline.back().y;
        if (over > 5.0 && person.happens(0.5)) {
            // Too tall: some press on the rim.
            const double rim = wheel.outer_mm(wheel.height_mm() - 1.0) - 3.0;
            person.stroke({{rim, wheel.height_mm() + 2.0}, {rim, outline.back().y}},
                          person.uniform(1.0, 2.5));
        }
        person.stroke(outline, person.uniform(2.5, 5.0));
        person.note_progress();
        // The tolerance grows with each stroke, so everyone is satisfied sooner or later.
        if (i >= 2 && seen_error_mm(wheel, outline) < 1.6 + 0.3 * i) break;
    }
    return outline;
}

void scribble(Person& person) {
    WheelRig& wheel = person.wheel();
    while (person.seconds() < 30.0) {
        std::vector<dvec2> way;
        const int corners = 2 + static_cast<int>(person.uniform(0.0, 5.0));
        for (int i = 0; i < corners; ++i) {
            const double y = person.uniform(0.0, 1.5 * std::max(wheel.height_mm(), 60.0));
            way.emplace_back(person.uniform(-110.0, 110.0), y);
        }
        person.stroke(way, person.uniform(0.4, 3.0));
        person.note_progress();
    }
}

void hold_still(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const double y = std::max(0.3 * wheel.height_mm(), 8.0);
    person.stroke({{wheel.outer_mm(y), y}, {wheel.outer_mm(y) - 2.0, y}}, person.uniform(1.5, 3.0));
    for (int i = 0; i < 6 && wheel.depth_mm() < 18.0; ++i) {
        const double top = wheel.height_mm();
        person.stroke({{0.0, top}, {0.0, top - 3.0}}, person.uniform(2.0, 4.0));
    }
    const double opened = wheel.height_mm();
    for (int i = 0; i < 8 && wheel.height_mm() < std::max(1.4 * opened, 75.0); ++i) {
        // Up in one go, and waits there.
        const double top = wheel.height_mm();
        const double r = wheel.outer_mm(0.3 * top);
        person.stroke({{r, 0.3 * top}, {r, top + 30.0}, {r, top + 31.0}}, person.uniform(2.5, 4.0));
        person.note_progress();
    }
}

}  // namespace

Visit throw_a_pot(Kind kind, std::uint64_t seed, const Skill& skill, WheelRig& rig,
                  const std::vector<dvec2>& shown_mm) {
    Person person(seed * kKindCount + static_cast<std::uint64_t>(kind), skill, rig,
                  kind == Kind::kLeftHand ? -1.0 : 1.0);
    Visit visit;
    switch (kind) {
        case Kind::kLesson:
        case Kind::kLeftHand:
            follow_lesson(person, 10.0);
            break;
        case Kind::kTopFirst:
            press_top_first(person);
            break;
        case Kind::kOutsidePull:
            pull_outside(person);
            break;
        case Kind::kBowl:
            visit.drawn_mm = draw(person, bowl_of(person));
            break;
        case Kind::kVase:
            visit.drawn_mm = draw(person, vase_of(person));
            break;
        case Kind::kScribble:
            scribble(person);
            break;
        case Kind::kLiftsOften:
            follow_lesson(person, 0.5);
            break;
        case Kind::kHoldsStill:
            hold_still(person);
            break;
        case Kind::kFollowsOutline:
            visit.drawn_mm = draw(person, shown_mm);
            break;
    }
    visit.seconds = person.released_s();
    visit.made_s = person.made_s;
    person.go_to_done();
    return visit;
}

}  // namespace onggi::visitors
