// A jar of two bowls, made as moon jars are: throw a bowl and set it aside, throw the second bowl, put the
// first upside down on the second, close the seam. Undo works across the steps, and a collapse loses at most
// one bowl. A card announces the steps before the first.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "game/screens/page/ledge_parts.h"
#include "game/visit/jar/jar.h"

namespace onggi::visit {
namespace {

using ui::Rect;

constexpr std::array kJarStepIcons{Icon::kJarFirst, Icon::kJarAside, Icon::kJarSecond, Icon::kJarJoin,
                                   Icon::kJarWhole};
constexpr std::array kJarStepKeys{"moon.s1", "moon.s2", "moon.s3", "moon.s4", "moon.s5"};
static_assert(kJarStepIcons.size() == kJarSteps && kJarStepKeys.size() == kJarSteps);

int place_of_step(const Page& page) {
    return static_cast<int>(page.view().state.throwing.jar.step) - 1;
}

// The last token: at the ledge's end, or in the second row of a tall screen.
Rect last_token(const Page& page, float wide) {
    if (page.is_tall()) return {page.width() - 300.0F, second_row_y(page), 268.0F, 80.0F};
    const float edge = page.is_square() ? 20.0F : 32.0F;
    return {page.width() - edge - wide, row_y(page) - 4.0F, wide, 74.0F};
}

const Exhibit* jar_of(const View& view) {
    const std::optional<int> target = view.state.throwing.target;
    if (!target || *target < 0 || *target >= static_cast<int>(view.exhibits->size())) return nullptr;
    return &(*view.exhibits)[static_cast<std::size_t>(*target)];
}

std::string size_line(const Page& page, const Exhibit& jar) {
    if (jar.part.empty()) return {};
    return jar.part == "1/2" ? page.t("choose.half") : page.t("choose.part", page.digits(jar.part));
}

std::string told_of(const Page& page, JarStep step) {
    switch (step) {
        case JarStep::kFirstBowl: {
            const Exhibit* const jar = jar_of(page.view());
            const std::string part = jar != nullptr ? jar->part : std::string();
            return part == "1/2" ? page.t("moon.h1") : page.t("moon.h1.part", page.digits(part));
        }
        case JarStep::kAside:
            return page.t("moon.h2");
        case JarStep::kSecondBowl:
            return page.t("moon.h3");
        case JarStep::kJoin:
            return page.t("moon.h4");
        case JarStep::kSeam:
            return page.t("moon.h5");
        case JarStep::kNone:
            break;
    }
    return {};
}

// The box that shows both bowls.
Rect bowls_box(const Page& page) {
    const float top = ledge_top(page);
    return page.by_shape(Rect{400.0F, 56.0F, 480.0F, top - 70.0F}, Rect{290.0F, 114.0F, 400.0F, top - 124.0F},
                         Rect{150.0F, 440.0F, 420.0F, top - 460.0F});
}

void add_jar_pictograms(Page& page, vec2 at, float pitch, int current) {
    constexpr float kSide = 42.0F;
    constexpr float kCurrentSide = 52.0F;
    constexpr float kField = 56.0F;
    for (int i = 0; i < kJarSteps; ++i) {
        const bool is_current = i == current;
        const float side = is_current ? kCurrentSide : kSide;
        const float left = at.x + static_cast<float>(i) * pitch;
        const Icon icon = kJarStepIcons[static_cast<std::size_t>(i)];
        const float inset = 0.5F * (kField - side);
        ui::Sketch sketch;
        if (is_current || current < 0) {
            add_icon(sketch, icon, {inset, inset}, side, ui::hex(0xfff3d9));
        } else {
            const auto fill = i < current ? std::optional<ui::Colour>(ui::hex(0x8b6a48)) : std::nullopt;
            add_icon(sketch, icon, {inset, inset}, side, ui::hex(0xd6c6ac, 0.75F), fill);
        }
        if (is_current) sketch.add(ui::Box{{4.0F, 58.0F, 48.0F, 5.0F}, 3.0F, ui::Fill::flat(design::kAmber)});
        page.sprite(page.on_ledge({left, at.y, kField, kField + 8.0F}), std::move(sketch));
        if (i >= current) continue;
        ui::Sketch tick;
        add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 20.0F, design::kAmber);
        page.sprite(page.on_ledge({left + 38.0F, at.y - 10.0F, 20.0F, 20.0F}), std::move(tick));
    }
}

void add_join_ledge(Page& page) {
    add_jar_steps(page);
    const Rect join = last_token(page, 236.0F);
    const bool tall = page.is_tall();
    const float y = row_y(page);
    // Two buttons share one name below them.
    const float side_x = tall ? page.width() - 300.0F : join.x - 236.0F;
    const auto aside = [&](float x, Icon icon, Button button, const char* key) {
        page.token(page.on_ledge({x, y, 90.0F, 66.0F}), Look::kToken, button, page.named(key), 0, icon, false,
                   true);
    };
    // Left on the screen is left of the jar, even if the ledge is mirrored.
    const Rect first = page.on_ledge({side_x, y, 90.0F, 66.0F});
    const Rect second = page.on_ledge({side_x + 104.0F, y, 90.0F, 66.0F});
    const bool swaps = first.x > second.x;
    aside(swaps ? side_x + 104.0F : side_x, Icon::kLeft, Button::kHandLeft, "ctl.left");
    aside(swaps ? side_x : side_x + 104.0F, Icon::kRight, Button::kHandRight, "ctl.right");
    page.label(page.on_ledge({side_x - 14.0F, y + 74.0F, 222.0F, label_height(page)}), page.t("moon.side"));
    const float undo_x = tall ? 32.0F : side_x - 128.0F;
    add_round(page, {undo_x, tall ? second_row_y(page) : y, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo,
              "ctl.undo", 112.0F);
    page.token(page.on_ledge(join), Look::kPrimary, Button::kJoinBowls, page.named("moon.join"));
}

void draw_jar_start(Page& page) {
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float foot_y = height - 96.0F;
    const float shelf_y = tall ? 590.0F : foot_y - 60.0F;
    const Rect stage = page.mirrored({0.0F, 0.0F, page.by_shape(640.0F, 440.0F, width), shelf_y});
    page.museum({stage.centre().x, 0.42F * height}, {0.46F * width, 0.62F * height}, 0.30F);
    page.shelf(shelf_y, 34.0F);
    page.down({0.0F, shelf_y + 34.0F, width, height - shelf_y - 34.0F}, ui::hex(0x1a120c), ui::hex(0x241a13));
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, tall || square ? 120.0F : 66.0F}),
               {.text = page.t("moon.title"), .type = design::serif(46.0F, 58.0F)});
    const Rect languages =
        page.languages_token({width - 182.0F, tall ? height - 190.0F : foot_y - 130.0F, 150.0F, 60.0F});
    const Exhibit* const jar = jar_of(page.view());
    if (jar == nullptr) return;
    const float above = tall || square ? 160.0F : 110.0F;
    const float scale = std::min((stage.width - 90.0F) / (2.0F * jar->shape.radius_mm()),
                                 (shelf_y + 12.0F - above) / (jar->shape.height_mm() * 1.1F));
    page.keep_clear(page.turning_pot(jar->shape, finish::glaze_at(jar->glaze), scale,
                                     {stage.centre().x, shelf_y + 12.0F}));
    const float left = tall ? 40.0F : stage.width + 10.0F;
    const float wide = tall ? width - 80.0F : width - 32.0F - (square ? 440.0F : 640.0F) - 10.0F;
    const float x = tall ? left : (square ? 450.0F : 650.0F);
    const float top = page.by_shape(118.0F, 150.0F, shelf_y + 122.0F);
    const Rect most = page.mirrored({x, top, wide, page.by_shape(220.0F, 230.0F, 230.0F)});
    add_paper(page, most, {{.text = page.t("moon.lead"), .type = {28.0F, 37.0F}, .colour = design::kInk}});
    const float steps_y = most.bottom() + 10.0F;
    const float pitch = std::min(96.0F, (wide - 60.0F) / (kJarSteps - 1));
    const float steps_wide = pitch * (kJarSteps - 1) + 56.0F;
    add_jar_pictograms(page, {x + 0.5F * (wide - steps_wide), steps_y}, pitch, -1);
    const std::string size = size_line(page, *jar);
    const float words_y = steps_y + 70.0F;
    const float words_end = page.is_low() && !tall ? languages.y - 8.0F : tall ? languages.y - 8.0F : shelf_y;
    page.words(page.mirrored({x, words_y, wide, std::max(40.0F, words_end - words_y)}),
               {.text = page.t("moon.time") + (size.empty() ? "" : " \u00b7 " + size),
                .type = design::kReading,
                .colour = design::kSlip,
                .align = ui::Align::kCentre});
    const Rect name = tall ? Rect{32.0F, shelf_y + 38.0F, width - 64.0F, 76.0F}
                           : Rect{32.0F, foot_y - 22.0F, (square ? 440.0F : 640.0F) - 64.0F, 112.0F};
    page.words(page.mirrored(name),
               {.text = page.t(jar->name_key) + " \u00b7 " + page.whole_mm(jar->height_mm) + "\n" +
                        page.t(jar->museum_key) + " \u00b7 " + page.t(jar->date_key),
                .type = design::kNote,
                .align = ui::Align::kCentre});
    const float back_x = tall ? 40.0F : x;
    page.back_token(page.mirrored({back_x, foot_y, 190.0F, 76.0F}));
    page.token(page.mirrored({back_x + 208.0F, foot_y, wide - 208.0F, 76.0F}), Look::kPrimary, Button::kBegin,
               page.named("moon.begin"));
}

void draw_join(Page& page) {
    const View& view = page.view();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float top = ledge_top(page);
    page.keep_clear(bowls_box(page));
    page.scene_ends();
    page.ledge(top);
    add_jar_card(page);
    const Rect languages = page.languages_token(low_languages(page));
    const float wide = page.by_shape(320.0F, 270.0F, 320.0F);
    const std::string apart = std::to_string(view.state.throwing.jar.rims_mm);
    const float y = tall ? std::max(languages.bottom(), 92.0F) + 20.0F : 112.0F;
    add_paper(
        page,
        page.mirrored({page.width() - wide - (square ? 20.0F : 32.0F), tall ? 240.0F : y, wide, 190.0F}),
        {{.text = page.t("moon.rim", page.digits(apart)),
          .type = design::bold(28.0F, 36.0F),
          .colour = design::kInk},
         {.text = page.t("moon.rimok"), .type = design::kPaper, .colour = design::kInk2}});
    add_join_ledge(page);
}

// Enters the step and leaves the clay on the wheel.
void go_to(Turn& turn, JarStep step) {
    JarMaking& jar = turn.state.throwing.jar;
    jar = {.step = step, .is_bowl = jar.is_bowl};
    turn.state.throwing.tray = false;
    turn.state.pace = {.progress_s = turn.now_s};
    turn.show(step == JarStep::kJoin ? Screen::kJoin : Screen::kThrow);
}

// Keeps the water, speed and tool size that the visitor chose.
void put_on_bowl_clay(Turn& turn, JarStep step) {
    Throwing& throwing = turn.state.throwing;
    throwing = {.target = throwing.target,
                .tool = throwing.tool,
                .water = throwing.water,
                .speed = throwing.speed,
                .jar = {.step = step}};
    turn.state.pace = {.progress_s = turn.now_s};
    turn.add(effect::FreshClay{throwing.target});
}

void ask(Turn& turn, const Effect& effect) {
    JarMaking& jar = turn.state.throwing.jar;
    if (jar.waits) return;
    jar.waits = true;
    turn.add(effect);
}

void end_bowl(Turn& turn, const Effect& with) {
    JarMaking& jar = turn.state.throwing.jar;
    jar.is_low = !jar.is_bowl;
    if (jar.is_bowl) ask(turn, with);
}

// Undoes the start of the current step and restores the clay at the end of the previous one.
void step_back(Turn& turn) {
    turn.state.throwing.jar.is_bowl = false;  // until the bowl is restored
    switch (turn.state.throwing.jar.step) {
        case JarStep::kAside:
        case JarStep::kSecondBowl:
            turn.add(effect::TakeBack{.bowl = 1});
            turn.state.throwing.steps_done = kTeachingSteps;
            go_to(turn, JarStep::kFirstBowl);
            break;
        case JarStep::kSeam:
            turn.add(effect::TakeBack{.bowl = 2});
            turn.state.throwing.held = tool::Tool::kHand;
            go_to(turn, JarStep::kSecondBowl);
            break;
        case JarStep::kNone:
        case JarStep::kFirstBowl:
        case JarStep::kJoin:
            break;
    }
}

// Handles each event by the current step of the jar.
struct JarTaking {
    Turn& turn;
    JarMaking& jar = turn.state.throwing.jar;

    void operator()(const event::Bowl& bowl) { jar.is_bowl = bowl.is_bowl; }
    void operator()(const event::SetAside& /*aside*/) {
        if (jar.step == JarStep::kFirstBowl) put_on_bowl_clay(turn, JarStep::kAside);
    }
    void operator()(const event::Rims& rims) {
        if (jar.step != JarStep::kSecondBowl) return;
        go_to(turn, JarStep::kJoin);
        jar.rims_mm = rims.apart_mm;
    }
    void operator()(const event::RimsApart& /*apart*/) {
        if (jar.step != JarStep::kSecondBowl) return;
        jar.waits = false;
        jar.rims_apart = true;
    }
    void operator()(const event::Joined& /*joined*/) {
        if (jar.step != JarStep::kJoin) return;
        go_to(turn, JarStep::kSeam);
        turn.state.throwing.steps_done = kTeachingSteps;
        turn.state.throwing.held = tool::Tool::kRib;
    }
    void operator()(const event::JarStays& /*stays*/) { jar.waits = false; }
    void operator()(const event::UndoneAll& /*all*/) {
        if (jar.step != JarStep::kJoin) step_back(turn);
    }
    template <typename Other>
    void operator()(const Other& /*other*/) {}
};

void press_jar_start(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kBack) {
        turn.show(Screen::kChoose);
    } else if (event.button == Button::kBegin) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(turn.state.throwing.target);
        turn.state.throwing.jar.step = JarStep::kFirstBowl;
        turn.add(effect::BeginJar{*turn.state.throwing.target});
    }
}

void press_join(Turn& turn, const event::Pressed& event) {
    JarMaking& jar = turn.state.throwing.jar;
    if (jar.waits) return;
    switch (event.button) {
        case Button::kUndo:
        case Button::kBack:
            go_to(turn, JarStep::kSecondBowl);
            break;
        case Button::kHandLeft:
        case Button::kHandRight:
            jar.shift_mm = std::clamp(jar.shift_mm + (event.button == Button::kHandRight ? 1 : -1),
                                      -kMostShiftMm, kMostShiftMm);
            break;
        case Button::kHandDown:
        case Button::kJoinBowls:
            ask(turn, effect::JoinBowls{jar.shift_mm});
            break;
        default:
            break;
    }
}

std::string_view spoken_of_jar(const State& /*state*/) {
    return "moon.title";
}

std::string_view spoken_of_join(const State& /*state*/) {
    return "moon.s4";
}

}  // namespace

void resume_jar(Turn& turn) {
    const auto [step, target] =
        std::exchange(turn.state.interrupted_jar, std::nullopt).value_or(InterruptedJar{});
    const std::vector<int>& jars = turn.rules.jars;
    const bool is_step =
        step == JarStep::kFirstBowl || step == JarStep::kSecondBowl || step == JarStep::kSeam;
    if (!is_step || std::find(jars.begin(), jars.end(), target) == jars.end()) return;
    turn.state.throwing.target = target;
    turn.state.throwing.jar.step = step;
    if (step != JarStep::kSeam) return;
    turn.state.throwing.steps_done = kTeachingSteps;
    turn.state.throwing.held = tool::Tool::kRib;
}

void put_on_new_clay(Turn& turn) {
    const Throwing& throwing = turn.state.throwing;
    switch (throwing.jar.step) {
        case JarStep::kNone:
        case JarStep::kJoin:
            return turn.put_on_clay(throwing.target);
        case JarStep::kFirstBowl:
            return put_on_bowl_clay(turn, JarStep::kFirstBowl);
        case JarStep::kAside:
        case JarStep::kSecondBowl:
        case JarStep::kSeam:
            return put_on_bowl_clay(turn, JarStep::kSecondBowl);
    }
}

bool press_jar(Turn& turn, const event::Pressed& event) {
    const JarMaking& jar = turn.state.throwing.jar;
    const bool is_over = event.button == Button::kDone;
    switch (jar.step) {
        case JarStep::kFirstBowl:
            if (is_over) end_bowl(turn, effect::SetAside{});
            return is_over;
        case JarStep::kAside:
            if (event.button == Button::kUndo) {
                step_back(turn);
                return true;
            }
            end_aside(turn);
            return is_over;
        case JarStep::kSecondBowl:
            if (is_over) end_bowl(turn, effect::HoldTogether{});
            return is_over;
        case JarStep::kNone:
        case JarStep::kJoin:
        case JarStep::kSeam:
            return false;
    }
    return false;
}

void take_jar(Turn& turn, const Event& event) {
    if (turn.state.throwing.jar.step != JarStep::kNone) std::visit(JarTaking{turn}, event);
}

void pass_aside(Turn& turn) {
    const State& state = turn.state;
    if (state.throwing.jar.step == JarStep::kAside &&
        turn.now_s - state.pace.progress_s >= turn.rules.aside_s)
        end_aside(turn);
}

void end_aside(Turn& turn) {
    if (turn.state.throwing.jar.step == JarStep::kAside) turn.state.throwing.jar.step = JarStep::kSecondBowl;
}

void add_jar_steps(Page& page) {
    constexpr float kPitch = 46.0F;
    const vec2 at(page.shape() == Shape::kWide ? 26.0F : 30.0F,
                  ledge_top(page) + page.by_shape(20.0F, 18.0F, 26.0F));
    add_jar_pictograms(page, at, kPitch, place_of_step(page));
    add_step_caption(page, page.t(kJarStepKeys[static_cast<std::size_t>(place_of_step(page))]), 232.0F,
                     290.0F);
}

void add_aside_ledge(Page& page) {
    add_jar_steps(page);
    const Rect next = last_token(page, 268.0F);
    page.token(page.on_ledge(next), Look::kPrimary, Button::kDone, page.named("moon.next"));
    const float x = page.is_tall() ? 32.0F : next.x - 120.0F;
    const float y = page.is_tall() ? second_row_y(page) : row_y(page);
    add_round(page, {x, y, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 112.0F);
}

void add_jar_card(Page& page) {
    const JarMaking& jar = page.view().state.throwing.jar;
    if (jar.step == JarStep::kNone || jar.touched || jar.is_low || jar.rims_apart) return;
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float wide = page.by_shape(304.0F, 250.0F, 390.0F);
    add_paper(page,
              page.mirrored({square ? 20.0F : 32.0F, tall ? 32.0F : 112.0F, wide,
                             page.by_shape(240.0F, 300.0F, 196.0F)}),
              {{.text = told_of(page, jar.step), .type = design::kPaper, .colour = design::kInk2}});
}

extern constinit const Step kJarStartStep{.screen = Screen::kJarStart,
                                          .name = "jar-start",
                                          .press = press_jar_start,
                                          .draw = draw_jar_start,
                                          .spoken = spoken_of_jar};

extern constinit const Step kJoinStep{.screen = Screen::kJoin,
                                      .name = "join",
                                      .press = press_join,
                                      .take = take_jar,
                                      .draw = draw_join,
                                      .spoken = spoken_of_join,
                                      .camera = Camera::kThrowing,
                                      .shows_scene = true,
                                      .finger = Finger::kBowl,
                                      .has_wet_clay = true};

}  // namespace onggi::visit
