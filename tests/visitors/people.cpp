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
        while (rig_.shows())
            frame(at_, false);
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
            if (skill_.tremor_mm > 0.0) {
                constexpr double kTremorHz = 5.0;
                const double shake = 2.0 * std::numbers::pi * kTremorHz * t;
                place +=
                    dvec2(std::sin(shake + phase_x), std::sin(1.13 * shake + phase_y)) * skill_.tremor_mm;
            }
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
    const auto pace = [&](double least, double most) {
        return std::min(person.uniform(least, most), longest_s);
    };
    person.wait(person.uniform(0.5, 2.0));
    for (int i = 0; i < 12 && wheel.steps_done() < 1; ++i)
        press_in(person, pace(1.0, 3.0));
    for (int i = 0; i < 14 && wheel.steps_done() < 2; ++i)
        press_middle(person, pace(1.0, 3.0));
    person.note_progress();
    const int wanted = 1 + static_cast<int>(person.uniform(0.0, 3.0));
    for (int pulls = 0; pulls < 24 && (pulls < wanted || wheel.steps_done() < 3); ++pulls) {
        pull_wall(person, pace(1.5, 4.0));
        person.note_progress();
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

// Draws up from the foot, as somebody does who sees that the clay is hollow.
void draw_up(Person& person, int times, double least_s, double most_s) {
    for (int i = 0; i < times; ++i) {
        pull_wall(person, person.uniform(least_s, most_s));
        person.note_progress();
    }
}

// Presses "done", and does what it advises as the lesson shows it. Returns how often.
int heed_done(Person& person) {
    constexpr int kPatience = 2;
    WheelRig& wheel = person.wheel();
    for (int taken = 0;; ++taken) {
        const WheelRig::Advice advice = wheel.press_done();
        if (advice == WheelRig::Advice::kNone || taken == kPatience) return taken;
        person.wait(person.uniform(1.0, 3.0));
        if (advice == WheelRig::Advice::kOpen) {
            for (int i = 0; i < 8 && wheel.depth_mm() < 18.0; ++i)
                press_middle(person, person.uniform(1.0, 3.0));
        } else {
            draw_up(person, 1 + static_cast<int>(person.uniform(0.0, 2.0)), 1.5, 4.0);
        }
        person.go_to_done();
    }
}

// The lesson, slowly, with rests of up to 15 s after some of the strokes.
void follow_slowly(Person& person, double chance_of_pause, double chance_of_lift) {
    WheelRig& wheel = person.wheel();
    const auto rest = [&] {
        if (person.happens(chance_of_pause)) person.wait(person.uniform(4.0, 15.0));
    };
    person.wait(person.uniform(2.0, 5.0));
    for (int i = 0; i < 4 && wheel.steps_done() < 1; ++i) {
        press_in(person, person.uniform(4.0, 8.0));
        rest();
    }
    for (int i = 0; i < 6 && wheel.steps_done() < 2; ++i) {
        press_middle(person, person.uniform(4.0, 9.0));
        rest();
    }
    const int wanted = 3 + static_cast<int>(person.uniform(0.0, 4.0));
    for (int i = 0; i < 10 && (i < wanted || wheel.steps_done() < 3); ++i) {
        const double top = wheel.height_mm();
        const double y = person.uniform(0.15, 0.35) * top;
        const double over = person.uniform(-6.0, 25.0);
        const double rim = wheel.outer_mm(top - 2.0);
        const dvec2 low(wheel.outer_mm(y) + person.uniform(-2.0, 4.0), y);
        const double seconds = person.uniform(5.0, 12.0);
        if (person.happens(chance_of_lift)) {
            // The finger comes off half-way up, and goes on there.
            const dvec2 middle(wheel.outer_mm(0.6 * top), 0.6 * top);
            person.stroke({low, middle}, 0.5 * seconds);
            person.stroke({middle, {rim, top}, {rim, top + over}}, 0.5 * seconds);
        } else {
            person.stroke({low, {rim, top}, {rim, top + over}}, seconds);
        }
        person.note_progress();
        rest();
    }
}

void work_at_base(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const double until = person.seconds() + person.uniform(25.0, 45.0);
    while (person.seconds() < until && wheel.depth_mm() < 18.0) {
        const double y = person.uniform(3.0, 14.0);
        const double r = wheel.outer_mm(y);
        const double in = person.uniform(4.0, 12.0);
        const double seconds = person.uniform(0.8, 3.0);
        person.stroke({{r + person.uniform(0.0, 6.0), y}, {r - in, y}, {r, y}}, seconds);
    }
    if (wheel.depth_mm() < 18.0) return;
    draw_up(person, 2 + static_cast<int>(person.uniform(0.0, 3.0)), 1.5, 4.0);
}

void pull_inside(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    for (int i = 0; i < 8 && wheel.depth_mm() < 18.0; ++i)
        press_middle(person, person.uniform(1.0, 3.0));
    const int pulls = 4 + static_cast<int>(person.uniform(0.0, 5.0));
    for (int i = 0; i < pulls; ++i) {
        const double top = wheel.height_mm();
        const double mouth = wheel.inner_mm(top - 2.0);
        const double low = wheel.floor_mm() + person.uniform(4.0, 15.0);
        const double over = person.uniform(8.0, 50.0);
        const double seconds = person.uniform(1.5, 4.0);
        person.stroke({{0.6 * mouth, low}, {0.9 * mouth, top}, {mouth, top + over}}, seconds);
        person.note_progress();
    }
}

// Begins on the bench, right or left of the pan, or below the wheel, and drags to the clay and on.
void start_aside(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const int drags = 10 + static_cast<int>(person.uniform(0.0, 7.0));
    for (int i = 0; i < drags; ++i) {
        const double where = person.uniform(0.0, 3.0);
        dvec2 from(person.uniform(150.0, 275.0), person.uniform(-30.0, 30.0));
        if (where > 2.0) from = {person.uniform(-150.0, 150.0), person.uniform(-90.0, -40.0)};
        const double side = from.x < 0.0 ? -1.0 : 1.0;
        const double top = wheel.height_mm();
        const double y = person.uniform(0.1, 0.5) * top;
        const double seconds = person.uniform(2.0, 4.0);
        if (wheel.depth_mm() < 18.0 && person.happens(0.5)) {
            const double down = person.uniform(15.0, 30.0);
            person.stroke({from, {side * 10.0, top + 10.0}, {0.0, top}, {0.0, top - down}}, seconds);
        } else {
            const double over = person.uniform(10.0, 50.0);
            person.stroke({from,
                           {side * wheel.outer_mm(y), y},
                           {side * wheel.outer_mm(top - 2.0), top},
                           {side * wheel.outer_mm(top - 2.0), top + over}},
                          seconds);
        }
        person.note_progress();
    }
}

std::vector<dvec2> make_plate(Person& person) {
    WheelRig& wheel = person.wheel();
    const double size = size_seen(wheel);
    const double foot = size * person.uniform(50.0, 60.0);
    const double rim = size * person.uniform(95.0, 120.0);
    const double height = size * person.uniform(25.0, 38.0);
    std::vector<dvec2> outline;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
        const double u = static_cast<double>(i) / kSteps;
        outline.emplace_back(foot + (rim - foot) * std::sqrt(u), u * height);
    }
    person.wait(1.0);
    for (int i = 0; i < 8 && wheel.depth_mm() < 14.0; ++i)
        press_middle(person, person.uniform(1.0, 3.0));
    for (int i = 0; i < 12; ++i) {
        const double top = wheel.height_mm();
        const double mouth = wheel.inner_mm(top - 2.0);
        const double chance = person.uniform(0.0, 3.0);
        const double seconds = person.uniform(1.5, 3.5);
        if (chance < 1.0) {
            person.stroke({{0.5 * mouth, std::max(top - 8.0, 14.0)}, {rim, height}}, seconds);
        } else if (chance < 2.0) {
            person.stroke(outline, seconds);
        } else if (top > height + 5.0) {
            const double r = wheel.outer_mm(top - 1.0) - 3.0;
            person.stroke({{r, top + 2.0}, {r, height}}, seconds);
        } else {
            person.stroke({{wheel.outer_mm(top - 4.0), top - 4.0}, {rim, height}}, seconds);
        }
        person.note_progress();
    }
    return outline;
}

void stir(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const int rounds = 3 + static_cast<int>(person.uniform(0.0, 4.0));
    for (int i = 0; i < rounds; ++i) {
        const double top = wheel.height_mm();
        const double reach = person.uniform(15.0, 40.0);
        const double deep = person.uniform(5.0, 25.0);
        std::vector<dvec2> way;
        const int corners = 6 + static_cast<int>(person.uniform(0.0, 10.0));
        for (int k = 0; k < corners; ++k) {
            const double turn = 1.6 * static_cast<double>(k);
            way.emplace_back(reach * std::cos(turn), top - deep * (0.5 + 0.5 * std::sin(turn)));
        }
        person.stroke(way, person.uniform(3.0, 7.0));
        person.note_progress();
    }
    draw_up(person, 1 + static_cast<int>(person.uniform(0.0, 3.0)), 1.5, 4.0);
}

void tap(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const double until = person.seconds() + person.uniform(40.0, 70.0);
    while (person.seconds() < until) {
        const double top = wheel.height_mm();
        const double where = person.uniform(0.0, 4.0);
        const double up = person.uniform(0.1, 0.9);
        dvec2 at(wheel.outer_mm(up * top), up * top);
        if (where < 1.5) at = {0.0, top - 2.0};
        if (where > 3.5) at = {wheel.outer_mm(top - 1.0) - 4.0, top};
        const double slip = person.uniform(0.0, 6.0);
        person.stroke({at, at + dvec2(0.0, where < 1.5 ? -slip : slip)}, person.uniform(0.1, 0.35));
        person.note_progress();
    }
}

void swipe(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const int swipes = 25 + static_cast<int>(person.uniform(0.0, 20.0));
    for (int i = 0; i < swipes; ++i) {
        const double top = wheel.height_mm();
        const double where = person.uniform(0.0, 4.0);
        const double far = person.uniform(30.0, 90.0);
        const double low = person.uniform(0.1, 0.5) * top;
        const double r = wheel.outer_mm(low);
        std::vector<dvec2> way{{r, low}, {r, low + far}};                           // up
        if (where < 1.0) way = {{0.0, top + 5.0}, {0.0, top + 5.0 - far}};          // down
        if (where > 3.0) way = {{r + 0.3 * far, low}, {r - 0.4 * far, low}};        // inward
        if (where > 3.5) way = {{0.3 * r, top - 5.0}, {0.3 * r + far, top - 5.0}};  // outward
        person.stroke(way, person.uniform(0.15, 0.4));
        person.note_progress();
    }
}

std::vector<dvec2> profile_of(Person& person) {
    const double size = size_seen(person.wheel());
    const double foot = size * person.uniform(34.0, 46.0);
    const double kind = person.uniform(0.0, 3.0);
    const double height = size * person.uniform(100.0, 150.0);
    if (kind < 1.0) {
        const double rim = foot + size * person.uniform(-4.0, 10.0);
        return outline_through({{foot, 0.0}, {0.5 * (foot + rim), 0.5}, {rim, 1.0}}, height);
    }
    const double belly = size * person.uniform(52.0, 66.0);
    if (kind < 2.0) {
        const double neck = size * person.uniform(18.0, 26.0);
        return outline_through({{foot, 0.0}, {belly, 0.35}, {neck, 0.7}, {neck + 3.0, 1.0}}, height);
    }
    const double mouth = size * person.uniform(26.0, 38.0);
    return outline_through({{foot, 0.0}, {belly, 0.5}, {mouth, 1.0}}, 0.85 * height);
}

// From the foot up, or from the rim down, in the air as over the clay.
std::vector<dvec2> trace(Person& person) {
    const std::vector<dvec2> outline = profile_of(person);
    const std::vector<dvec2> downward(outline.rbegin(), outline.rend());
    person.wait(1.0);
    const int traces = 4 + static_cast<int>(person.uniform(0.0, 4.0));
    for (int i = 0; i < traces; ++i) {
        const bool is_upward = person.happens(0.75);
        person.stroke(is_upward ? outline : downward, person.uniform(2.5, 6.0));
        person.note_progress();
    }
    return outline;
}

void pull_both_sides(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    const int pulls = 4 + static_cast<int>(person.uniform(0.0, 5.0));
    double side = 1.0;
    for (int i = 0; i < pulls; ++i) {
        side = -side;
        const double top = wheel.height_mm();
        const double y = person.uniform(0.15, 0.35) * top;
        const double over = person.uniform(15.0, 50.0);
        const double rim = side * wheel.outer_mm(top - 2.0);
        const double seconds = person.uniform(1.5, 4.0);
        person.stroke({{side * wheel.outer_mm(y), y}, {rim, top}, {rim, top + over}}, seconds);
        person.note_progress();
    }
}

void stroke_downward(Person& person) {
    WheelRig& wheel = person.wheel();
    person.wait(1.0);
    for (int i = 0; i < 8 && wheel.depth_mm() < 18.0; ++i)
        press_middle(person, person.uniform(1.0, 3.0));
    const int strokes = 4 + static_cast<int>(person.uniform(0.0, 4.0));
    for (int i = 0; i < strokes; ++i) {
        const double top = wheel.height_mm();
        const double low = person.uniform(0.1, 0.3) * top;
        const double r = wheel.outer_mm(top - 4.0);
        const double over = person.uniform(10.0, 40.0);
        const double seconds = person.uniform(2.0, 5.0);
        person.stroke({{r, top - 4.0}, {wheel.outer_mm(low), low}, {r, top}, {r, top + over}}, seconds);
        person.note_progress();
    }
}

// The first kinds, and those who follow an outline, keep the seeds of earlier populations.
std::uint64_t seed_of(Kind kind, std::uint64_t seed) {
    const auto place = static_cast<std::uint64_t>(kind);
    if (kind == Kind::kFollowsOutline) return seed * kEarlierKinds + kEarlierKinds;
    return place < kEarlierKinds ? seed * kEarlierKinds + place : seed * 1000 + place;
}

}  // namespace

Visit throw_a_pot(Kind kind, std::uint64_t seed, const Skill& skill, WheelRig& rig,
                  const std::vector<dvec2>& shown_mm) {
    Skill hand = skill;
    if (kind == Kind::kTrembles) hand.tremor_mm = 2.5;
    Person person(seed_of(kind, seed), hand, rig, kind == Kind::kLeftHand ? -1.0 : 1.0);
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
        case Kind::kTrembles:
            follow_slowly(person, 0.6, 0.5);
            break;
        case Kind::kWorksAtBase:
            work_at_base(person);
            break;
        case Kind::kPullsInside:
            pull_inside(person);
            break;
        case Kind::kStartsAside:
            start_aside(person);
            break;
        case Kind::kPlate:
            visit.drawn_mm = make_plate(person);
            break;
        case Kind::kStirs:
            stir(person);
            break;
        case Kind::kTaps:
            tap(person);
            break;
        case Kind::kSwipes:
            swipe(person);
            break;
        case Kind::kTraces:
            visit.drawn_mm = trace(person);
            break;
        case Kind::kSlow:
            follow_slowly(person, 0.2, 0.0);
            break;
        case Kind::kBothSides:
            pull_both_sides(person);
            break;
        case Kind::kDownward:
            stroke_downward(person);
            break;
        case Kind::kFollowsOutline:
            visit.drawn_mm = draw(person, shown_mm);
            break;
    }
    person.go_to_done();
    if (hand.heeds_done) visit.advised = heed_done(person);
    visit.seconds = person.released_s();
    visit.made_s = person.made_s;
    return visit;
}

}  // namespace onggi::visitors
