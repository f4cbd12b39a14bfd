#include "tests/unit/screens/sample_views.h"

#include <cmath>

#include "game/screens/page/design.h"
#include "game/screens/page/layout.h"
#include "game/visit/throw/throw.h"
#include "tests/unit/screens/sample_decorations.h"
#include "tests/unit/screens/sample_staff.h"

namespace onggi::screens {
namespace {

pot::Section jar() {
    return pot::hollowed({{42, 0},
                          {46, 6},
                          {62, 30},
                          {74, 58},
                          {76, 74},
                          {71, 96},
                          {60, 118},
                          {51, 134},
                          {48, 146},
                          {50, 158},
                          {53, 168}},
                         5.0F, 8.0F);
}

std::shared_ptr<const std::vector<kiosk::Language>> languages() {
    static const auto all = [] {
        const auto& built_in = kiosk::built_in_languages();
        // Korean, English, Arabic: the order of the designs.
        return std::make_shared<const std::vector<kiosk::Language>>(
            std::vector<kiosk::Language>{built_in[1], built_in[0], built_in[2]});
    }();
    return all;
}

int place_of(const std::string& code) {
    return code == "ko" ? 0 : code == "en" ? 1 : 2;
}

std::shared_ptr<const FiredPot> with_cranes(FiredPot pot) {
    const double tall = pot.shape.height_mm();
    const decoration::Strokes strokes{motif_round(decoration::Motif::kCrane, 0.5 * tall, 0.36 * tall, 5)};
    pot.shape = drawn_on(pot.shape, strokes);
    pot.drawn_with = finish::drawn_with(decoration::texture_of(*pot.shape.marks), strokes);
    return std::make_shared<const FiredPot>(std::move(pot));
}

// As the throwing camera would see it, roughly.
void add_scene(View& view) {
    const float u =
        static_cast<float>(view.height_px > view.width_px ? view.width_px : view.height_px) / 720.0F;
    const vec2 foot(0.5F * static_cast<float>(view.width_px),
                    view.height_px > view.width_px ? 730.0F * u : 450.0F * u);
    std::vector<vec2> left;
    std::vector<vec2> right;
    for (const vec2& point : jar().outside) {
        left.push_back(foot + u * vec2(-2.0F * point.x, -2.0F * point.y));
        right.push_back(foot + u * vec2(2.0F * point.x, -2.0F * point.y));
    }
    std::vector<vec2> rim;
    for (int i = 0; i <= 48; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / 48.0F;
        rim.push_back(foot + u * vec2(106.0F * std::cos(angle), -336.0F + 34.0F * std::sin(angle)));
    }
    view.outline_px = {left, right, rim};
    view.warning_at_px = foot + u * vec2(130.0F, -200.0F);
}

// A jar of two bowls, in all its steps.
void add_jar_views(const View& base, std::vector<SampleView>& all) {
    using kiosk::JarStep;
    using kiosk::Screen;
    const auto add = [&](const std::string& name, Screen screen, JarStep step, const auto& change) {
        View view = base;
        view.state.screen = screen;
        view.state.throwing.target = 3;
        view.state.throwing.jar.step = step;
        view.state.throwing.steps_done = kiosk::kTeachingSteps;
        change(view);
        all.push_back({name, std::make_shared<const View>(std::move(view))});
    };
    const auto aside = [](View& view) {
        view.aside = std::make_shared<const pot::Section>(
            pot::hollowed({{35, 0}, {60, 24}, {76, 50}, {84, 74}, {86, 90}}, 5.0F, 8.0F));
        const float u = px_per_u_of(view.width_px, view.height_px);
        view.aside_foot_px =
            vec2(0.05F * static_cast<float>(view.width_px), 0.55F * static_cast<float>(view.height_px));
        view.aside_px_per_mm = 1.4F * u;
    };
    add("jar-start", Screen::kJarStart, JarStep::kNone, [](View&) {});
    add("jar-first", Screen::kThrow, JarStep::kFirstBowl,
        [](View& view) { view.state.throwing.jar.is_bowl = true; });
    const auto scans = [](View& view) {
        view.scans = true;
        view.focus = 0;
    };
    add("jar-first-scan", Screen::kThrow, JarStep::kFirstBowl, scans);
    add("jar-join-scan", Screen::kJoin, JarStep::kJoin, scans);
    add("jar-seam-scan", Screen::kThrow, JarStep::kSeam, scans);
    add("jar-first-low", Screen::kThrow, JarStep::kFirstBowl,
        [](View& view) { view.state.throwing.jar.is_low = true; });
    add("jar-aside", Screen::kThrow, JarStep::kAside, aside);
    add("jar-second", Screen::kThrow, JarStep::kSecondBowl, [&](View& view) {
        aside(view);
        view.state.throwing.jar.is_bowl = true;
        view.state.throwing.jar.rims_apart = true;
    });
    add("jar-join", Screen::kJoin, JarStep::kJoin, [](View& view) { view.state.throwing.jar.rims_mm = 3; });
    add("jar-seam", Screen::kThrow, JarStep::kSeam, [](View& view) {
        view.state.throwing.held = tool::Tool::kRib;
        view.outline_px.clear();
    });
}

using kiosk::Screen;

void nothing(View&) {}

// Adds views that differ from `base` by a change.
struct Samples {
    const View& base;
    std::vector<SampleView>& all;

    template <typename Change>
    void operator()(const std::string& name, Screen screen, const Change& change) const {
        View view = base;
        view.state.screen = screen;
        change(view);
        all.push_back({name, std::make_shared<const View>(std::move(view))});
    }
};

void add_first_views(const Samples& add) {
    add("attract", Screen::kAttract, nothing);
    add("attract-heritage", Screen::kAttract, [](View& view) { view.attract_exhibit = 3; });
    add("choose", Screen::kChoose, nothing);
    add("card", Screen::kChoose, [](View& view) {
        view.state.panel = kiosk::Panel::kCard;
        view.state.card = 2;
    });
    add("choose-next", Screen::kChoose, [](View& view) { view.state.shelf_first = 2; });
}

void add_step_views(const Samples& add) {
    for (int step = 0; step < 4; ++step) {
        add("throw-" + std::to_string(step), Screen::kThrow, [&](View& view) {
            view.state.throwing.steps_done = step;
            view.state.throwing.target = 3;
        });
    }
    for (int step = 0; step < 3; ++step) {
        add("throw-shown-" + std::to_string(step), Screen::kThrow, [&](View& view) {
            view.state.throwing.steps_done = step;
            view.state.throwing.shown = static_cast<kiosk::ShownStep>(step);
        });
    }
    add("throw-solid", Screen::kThrow,
        [](View& view) { view.state.throwing.asks = kiosk::DoneQuestion::kSolid; });
    for (const bool scans : {false, true}) {
        add(scans ? "throw-thick-scan" : "throw-thick", Screen::kThrow, [&](View& view) {
            view.state.throwing.steps_done = 3;
            view.state.throwing.asks = kiosk::DoneQuestion::kThick;
            view.state.throwing.asked_mm = 22;
            if (!scans) return;
            view.scans = true;
            view.focus = 0;
        });
    }
    add("throw-reach", Screen::kThrow, [](View& view) {
        view.state.comfort.reach = true;
        view.focus = 3;
        view.heard = "cap.wheel";
    });
    for (int step = 0; step < 3; ++step) {
        add("throw-scan-" + std::to_string(step), Screen::kThrow, [&](View& view) {
            view.state.throwing.steps_done = step;
            view.scans = true;
            view.focus = 0;
            view.heard = "cap.wheel";
        });
    }
    add("warning-scan", Screen::kThrow, [](View& view) {
        view.state.throwing.warning = kiosk::Warning::kThin;
        view.thinnest_mm = 2.1;
        view.scans = true;
        view.focus = 4;
    });
}

void add_tool_views(const Samples& add) {
    for (std::size_t place = 0; place < visit::kTray.size(); ++place) {
        const auto holds = [&](View& view) {
            view.state.throwing.held = visit::kTray[place].tool;
            view.state.throwing.steps_done = kiosk::kTeachingSteps;
        };
        const auto wire = [](View& view) {
            if (view.state.throwing.held != tool::Tool::kWire) return;
            view.wire_off_mm = 6;
            view.wire_at_px =
                vec2(0.66F * static_cast<float>(view.width_px), 0.2F * static_cast<float>(view.height_px));
        };
        for (const bool scans : {false, true}) {
            const std::string ending = (scans ? "scan-" : "") + std::to_string(place);
            const auto scan = [&](View& view) {
                if (!scans) return;
                view.scans = true;
                view.focus = 0;
            };
            add("tools-" + ending, Screen::kThrow, [&](View& view) {
                holds(view);
                scan(view);
                view.state.throwing.tray = true;
            });
            if (place == 0) continue;
            add("held-" + ending, Screen::kThrow, [&](View& view) {
                holds(view);
                scan(view);
                wire(view);
            });
        }
    }
}

void add_throw_views(const Samples& add) {
    add("held-too-soon", Screen::kThrow, [](View& view) {
        view.state.throwing.held = tool::Tool::kRib;
        view.state.throwing.target = 3;
    });
    add("throw-left", Screen::kThrow, [](View& view) { view.state.comfort.left_hand = true; });
    add("throw-forces", Screen::kThrow, [](View& view) { view.state.comfort.forces = true; });
    add("throw-reach-left", Screen::kThrow, [](View& view) {
        view.state.comfort.reach = view.state.comfort.left_hand = true;
        view.state.throwing.target = 3;
    });
    add("throw-look-in", Screen::kThrow, [](View& view) {
        view.state.throwing.looks_in = true;
        view.state.throwing.steps_done = 1;
        view.outline_px.clear();
    });
    add("warning-reach", Screen::kThrow, [](View& view) {
        view.state.comfort.reach = true;
        view.state.throwing.warning = kiosk::Warning::kThin;
        view.thinnest_mm = 2.1;
    });
    add("warning-left", Screen::kThrow, [](View& view) {
        view.state.comfort.left_hand = true;
        view.state.throwing.warning = kiosk::Warning::kThin;
        view.thinnest_mm = 2.1;
    });
    add("throw-unplugged", Screen::kThrow, [](View& view) {
        view.state.device_lost = true;
        view.outline_px.clear();
    });
    add("throw-force-rests", Screen::kThrow, [](View& view) {
        view.state.force_rests = true;
        view.state.comfort.forces = true;
        view.outline_px.clear();
    });
    for (const auto& [name, warning] :
         {std::pair("warning-thin", kiosk::Warning::kThin), std::pair("warning-wet", kiosk::Warning::kWet),
          std::pair("warning-fast", kiosk::Warning::kFast)}) {
        add(name, Screen::kThrow, [warning = warning](View& view) {
            view.state.throwing.warning = warning;
            view.state.throwing.steps_done = 3;
            view.thinnest_mm = 2.1;
        });
    }
}

void add_firing_views(const Samples& add) {
    add("failure", Screen::kFailure, nothing);
    for (int stage = 0; stage < 3; ++stage) {
        add("firing-" + std::to_string(stage), Screen::kFiring,
            [&](View& view) { view.state.firing = static_cast<kiosk::FiringStage>(stage); });
    }
    add("firing-heard", Screen::kFiring, [](View& view) {
        view.state.firing = kiosk::FiringStage::kFire;
        view.heard = "cap.kiln";
    });
}

void add_done_views(const Samples& add) {
    add("trim", Screen::kTrim, nothing);
    add("trim-taken", Screen::kTrim, [](View& view) {
        view.state.trimming.touched = true;
        view.state.trimming.taken_g = 138;
    });
    add("trim-scan", Screen::kTrim, [](View& view) {
        view.scans = true;
        view.focus = 0;
    });
    for (int tool = 0; tool < kiosk::kDrawingTools; ++tool) {
        add("decorate-" + std::to_string(tool), Screen::kDecorate, [&](View& view) {
            view.state.decorating.tool = tool;
            view.state.decorating.strokes = tool % 2;
            view.state.decorating.turns = tool < 3;
        });
    }
    add("decorate-scan", Screen::kDecorate, [](View& view) {
        view.scans = true;
        view.focus = 0;
    });
    add("decorate-drawn", Screen::kDecorate, [](View& view) {
        view.state.decorating.touched = true;
        view.state.decorating.strokes = 7;
    });
    for (int glaze = 0; glaze < 6; ++glaze) {
        add("glaze-" + std::to_string(glaze), Screen::kGlaze, [&](View& view) { view.state.glaze = glaze; });
    }
    for (const int glaze : {0, 3}) {
        add("glaze-drawn-" + std::to_string(glaze), Screen::kGlaze, [&](View& view) {
            // Once: to draw it takes as long as to lay out twenty screens.
            static const auto drawn = with_cranes(*view.pot);
            view.pot = drawn;
            view.state.glaze = glaze;
        });
    }
}

void add_your_pot_views(const Samples& add) {
    add("your-pot", Screen::kYourPot, nothing);
    add("your-pot-after", Screen::kYourPot, [](View& view) {
        FiredPot pot = *view.pot;
        pot.is_after_relative = true;
        pot.off_outline_mm = 14.0;
        pot.good_key = "tip.good.wall";
        pot.next_key = "tip.next.height.more";
        view.pot = std::make_shared<const FiredPot>(std::move(pot));
    });
    add("your-pot-jar", Screen::kYourPot, [](View& view) {
        FiredPot pot = *view.pot;
        pot.is_after_relative = true;
        pot.off_round_mm = 3.2;
        view.pot = std::make_shared<const FiredPot>(std::move(pot));
    });
    add("your-pot-card", Screen::kYourPot, [](View& view) {
        view.state.panel = kiosk::Panel::kCard;
        view.state.card = kiosk::kRelativesCard;
    });
    add("your-pot-alone", Screen::kYourPot, [](View& view) {
        FiredPot pot = *view.pot;
        pot.relative.reset();
        view.pot = std::make_shared<const FiredPot>(pot);
    });
}

void add_keep_views(const Samples& add) {
    add("keep", Screen::kKeep, [](View& view) { view.state.keeping = {kiosk::Keeping::Outcome::kKept, 14}; });
    for (const auto& [name, phone] :
         {std::pair("home-packing", kiosk::Phone::kPacking), std::pair("home-wifi", kiosk::Phone::kWifi),
          std::pair("home-ready", kiosk::Phone::kReady), std::pair("home-resting", kiosk::Phone::kResting),
          std::pair("home-over", kiosk::Phone::kOver)}) {
        add(name, Screen::kKeep, [phone = phone](View& view) {
            view.state.keeping = {kiosk::Keeping::Outcome::kKept, 14, phone};
            PhoneCode code{.side = 29, .dark = {}};
            for (int i = 0; i < code.side * code.side; ++i)
                code.dark.push_back((i * 7 + i / code.side * 3) % 5 < 2);
            view.phone = std::make_shared<const PhoneWay>(
                PhoneWay{.page = code, .code = "K73F\u00b7Q9TX", .wifi = code, .wifi_name = "Museum-Guest"});
        });
    }
    add("keep-wall", Screen::kKeep, [](View& view) {
        view.state.keeping = {kiosk::Keeping::Outcome::kKept, 14, kiosk::Phone::kPacking, true};
        view.has_wall = true;
    });
}

void add_wall_views(const Samples& add) {
    for (const int count : {1, 18, 27}) {
        add("wall-" + std::to_string(count), Screen::kAttract, [&](View& view) {
            std::vector<ShelfPot> pots;
            for (int i = 0; i < count; ++i)
                pots.push_back(
                    {(*view.exhibits)[static_cast<std::size_t>(i) % view.exhibits->size()].shape, i % 6});
            view.wall = std::make_shared<const std::vector<ShelfPot>>(std::move(pots));
            view.wall_is_new = count != 27;
        });
    }
}

void add_last_views(const Samples& add) {
    add("keep-saving", Screen::kKeep, nothing);
    add("keep-full", Screen::kKeep, [](View& view) {
        view.state.keeping = {kiosk::Keeping::Outcome::kFull, 0};
    });
    add("resume", Screen::kResume, nothing);
    add("fault", Screen::kFault, nothing);
    add("idle", Screen::kThrow, [](View& view) {
        view.state.panel = kiosk::Panel::kIdle;
        view.seconds_left = 14;
    });
    add("language", Screen::kThrow, [](View& view) {
        view.state.panel = kiosk::Panel::kLanguage;
        view.state.comfort.still = true;
    });
}

void add_pin_views(const Samples& add) {
    add("pin", Screen::kThrow, [](View& view) {
        view.state.panel = kiosk::Panel::kPin;
        view.state.staff.digits = 2;
    });
    add("pin-waits", Screen::kAttract, [](View& view) {
        view.state.panel = kiosk::Panel::kPin;
        view.state.staff.was_wrong = true;
        view.seconds_left = 900;
    });
}

View base_view(const SampleRequest& request) {
    View base;
    base.width_px = request.width_px;
    base.height_px = request.height_px;
    base.px_per_mm = double{px_per_u_of(request.width_px, request.height_px) / design::kMmPerU};
    base.languages = languages();
    base.exhibits = sample_exhibits();
    base.state.comfort.language = place_of(request.language);
    base.state.comfort.text_size = request.text_size;
    base.state.comfort.reach = request.reach;
    base.state.comfort.left_hand = request.left_hand;
    base.state.comfort.still = request.still;
    base.scans = request.scans;
    base.focus = request.scans ? 0 : -1;
    base.pot = std::make_shared<const FiredPot>(FiredPot{.shape = jar(),
                                                         .height_mm = 168.0,
                                                         .width_mm = 152.0,
                                                         .weight_g = 730.0,
                                                         .capacity_l = 1.7,
                                                         .relative = {base.exhibits, &base.exhibits->at(3)},
                                                         .good_key = "tip.good.belly",
                                                         .next_key = "tip.next.mouth.more"});
    base.shelf = std::make_shared<const std::vector<ShelfPot>>(
        std::vector<ShelfPot>{{jar(), 3}, {sample_exhibits()->at(0).shape, 4}, {jar(), 2}, {jar(), 5}});
    base.can_look_in = true;
    add_scene(base);
    return base;
}

}  // namespace

std::vector<SampleView> sample_views(const SampleRequest& request) {
    const View base = base_view(request);
    std::vector<SampleView> all;
    const Samples add{base, all};
    add_first_views(add);
    add_step_views(add);
    add_tool_views(add);
    add_jar_views(base, all);
    add_throw_views(add);
    add_firing_views(add);
    add_done_views(add);
    add_your_pot_views(add);
    add_keep_views(add);
    add_wall_views(add);
    add_last_views(add);
    if (!request.staff) return all;
    add_pin_views(add);
    add_staff_views(base, all);
    return all;
}

}  // namespace onggi::screens
