#include "tests/unit/screens/sample_views.h"

#include <cmath>

namespace onggi::screens {
namespace {

PotShape jar() {
    return hollowed({{42, 0},
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
    view.hint_at_px = foot + u * vec2(115.0F, -40.0F);
    view.second_hint_at_px = foot + u * vec2(0.0F, -190.0F);
    view.warning_at_px = foot + u * vec2(130.0F, -200.0F);
}

}  // namespace

std::shared_ptr<const std::vector<Exhibit>> sample_exhibits() {
    static const auto all = std::make_shared<const std::vector<Exhibit>>(std::vector<Exhibit>{
        {"pot.ido", "mus.daitoku", "date.joseon16", 91.0, 154.0, false, finish::kIdoGlaze,
         hollowed({{26, 0}, {28, 12}, {30, 16}, {48, 30}, {63, 52}, {72, 74}, {77, 91}}, 5.0F, 20.0F)},
        {"pot.buncheong", "mus.brooklyn", "date.joseon15", 50.0, 196.0, false, 2,
         hollowed({{29, 0}, {30, 7}, {48, 14}, {72, 26}, {90, 40}, {98, 50}}, 5.0F, 12.0F)},
        {"pot.maebyeong", "mus.nmk", "date.goryeo12", 303.0, 0.0, false, 0,
         hollowed({{52, 0},
                   {50, 30},
                   {52, 80},
                   {64, 150},
                   {84, 215},
                   {90, 240},
                   {84, 264},
                   {60, 284},
                   {28, 292},
                   {20, 296},
                   {25, 303}},
                  5.0F, 8.0F)},
        {"pot.moon", "mus.nmk", "date.joseon18", 305.0, 302.0, true, 1,
         hollowed({{60, 0},
                   {62, 10},
                   {103, 44},
                   {136, 90},
                   {150, 135},
                   {151, 158},
                   {147, 188},
                   {130, 228},
                   {103, 262},
                   {81, 283},
                   {72, 290},
                   {69, 296},
                   {71, 305}},
                  6.0F, 10.0F)}});
    return all;
}

std::vector<SampleView> sample_views(const SampleWish& wish) {
    View base;
    base.width_px = wish.width_px;
    base.height_px = wish.height_px;
    const float u =
        static_cast<float>(wish.height_px > wish.width_px ? wish.width_px : wish.height_px) / 720.0F;
    base.px_per_mm = static_cast<double>(u) / 0.4151;
    base.languages = languages();
    base.exhibits = sample_exhibits();
    base.state.comfort.language = place_of(wish.language);
    base.state.comfort.text_size = wish.text_size;
    base.pot = std::make_shared<const FiredPot>(FiredPot{.shape = jar(),
                                                         .height_mm = 168.0,
                                                         .width_mm = 152.0,
                                                         .weight_g = 730.0,
                                                         .capacity_l = 1.7,
                                                         .nearest = 3});
    base.shelf = std::make_shared<const std::vector<ShelfPot>>(
        std::vector<ShelfPot>{{jar(), 3}, {sample_exhibits()->at(0).shape, 4}, {jar(), 2}, {jar(), 5}});
    add_scene(base);

    std::vector<SampleView> all;
    const auto add = [&](const std::string& name, kiosk::Screen screen, const auto& change) {
        View view = base;
        view.state.screen = screen;
        change(view);
        all.push_back({name, std::make_shared<const View>(std::move(view))});
    };
    const auto nothing = [](View&) {};
    using kiosk::Screen;
    add("attract", Screen::kAttract, nothing);
    add("attract-heritage", Screen::kAttract, [](View& view) { view.attract_exhibit = 3; });
    add("choose", Screen::kChoose, nothing);
    for (int step = 0; step < 4; ++step) {
        add("throw-" + std::to_string(step), Screen::kThrow, [&](View& view) {
            view.state.throwing.steps_done = step;
            view.state.throwing.target = 3;
        });
    }
    add("throw-reach", Screen::kThrow, [](View& view) {
        view.state.comfort.reach = true;
        view.focus = 3;
        view.heard = "cap.wheel";
    });
    add("throw-left", Screen::kThrow, [](View& view) { view.state.comfort.left_hand = true; });
    add("throw-unplugged", Screen::kThrow, [](View& view) {
        view.state.device_lost = true;
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
    add("failure", Screen::kFailure, nothing);
    for (int stage = 0; stage < 3; ++stage) {
        add("firing-" + std::to_string(stage), Screen::kFiring,
            [&](View& view) { view.state.firing = static_cast<kiosk::FiringStage>(stage); });
    }
    for (int glaze = 0; glaze < 6; ++glaze) {
        add("glaze-" + std::to_string(glaze), Screen::kGlaze, [&](View& view) { view.state.glaze = glaze; });
    }
    add("your-pot", Screen::kYourPot, nothing);
    add("your-pot-alone", Screen::kYourPot, [](View& view) {
        FiredPot pot = *view.pot;
        pot.nearest = -1;
        view.pot = std::make_shared<const FiredPot>(pot);
    });
    add("keep", Screen::kKeep, [](View& view) { view.state.keeping = {kiosk::Keeping::Outcome::kKept, 14}; });
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
    add("pin", Screen::kThrow, [](View& view) {
        view.state.panel = kiosk::Panel::kPin;
        view.state.staff.digits = 2;
    });
    add("staff", Screen::kThrow, [](View& view) {
        view.state.panel = kiosk::Panel::kStaff;
        view.staff_title = "onggi 0.1 \u00b7 wheel-2";
        view.staff_lines = {{"Force tick", "4000 Hz", "ok", -1},
                            {"Gallery disk", "2.1 GB free", "warn", -1},
                            {"Pot 14", "168 mm, celadon", "", 14}};
    });
    return all;
}

}  // namespace onggi::screens
