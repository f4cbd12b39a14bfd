// Keeping a pot: puts it on the day's shelf and on the wall of the day, and shares it with a phone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Align;
using ui::Rect;

constexpr float kCodeSide = 248.0F;
// A camera at arm's length needs a code of this width (a tenth of the distance), with a quiet zone of four
// modules (ISO/IEC 18004).
constexpr float kLeastCodeMm = 60.0F;
constexpr float kQuietModules = 4.0F;

float least_code(const Page& page) {
    return kLeastCodeMm * static_cast<float>(page.view().px_per_mm) / page.px_per_u();
}

// The side of a code together with its quiet zone.
float with_quiet_zone(const PhoneCode& code, float side) {
    return side * (1.0F + 2.0F * kQuietModules / static_cast<float>(code.side));
}

// Whether a card has room for a code of kLeastCodeMm, its quiet zone, and lines of that height. On a small
// panel the code needs the room of the less important lines.
bool has_room(const Page& page, const Rect& card, const PhoneCode& code, float lines) {
    return with_quiet_zone(code, least_code(page)) <= card.height - lines;
}

// A module is a whole number of pixels, for sharp edges. The code is at least kLeastCodeMm wide if the square
// `room` holds it and its quiet zone. Returns the code with its quiet zone, whose top is that of the room.
Rect add_code(Page& page, const PhoneCode& code, vec2 top_middle, float room) {
    const auto modules = static_cast<float>(code.side);
    const float px_per_u = page.px_per_u();
    const float most = room / with_quiet_zone(code, 1.0F);
    const float wanted = std::min(std::max(kCodeSide, least_code(page)), most);
    const bool is_least = wanted > kCodeSide;  // then rounds up if the result fits
    const float exact = wanted * px_per_u / modules;
    float px = std::max(1.0F, is_least ? std::ceil(exact) : std::floor(exact));
    if (px * modules / px_per_u > most && px > 1.0F) px -= 1.0F;
    const float module = px / px_per_u;
    const float side = module * modules;
    std::string path;
    for (int row = 0; row < code.side; ++row) {
        for (int column = 0; column < code.side; ++column) {
            if (!code.dark[static_cast<std::size_t>(row * code.side + column)]) continue;
            path +=
                fmt::format("M{:.4f} {:.4f} h{:.4f} v{:.4f} h-{:.4f} Z ", module * static_cast<float>(column),
                            module * static_cast<float>(row), module, module, module);
        }
    }
    ui::Sketch sketch;
    sketch.add(ui::Shape{.path = path, .fill = design::kInk});
    const Rect place{top_middle.x - 0.5F * side, top_middle.y + kQuietModules * module, side, side};
    page.sprite(place, std::move(sketch));
    const float zone = with_quiet_zone(code, side);
    return {top_middle.x - 0.5F * zone, top_middle.y, zone, zone};
}

Rect line_below(const Rect& card, float y, float height) {
    return {card.x + 20.0F, y, card.width - 40.0F, height};
}

// Emphasised text.
Words strong(std::string text) {
    return {
        .text = std::move(text), .type = design::kHeading, .colour = design::kInk, .align = Align::kCentre};
}
Words quiet(std::string text) {
    return {.text = std::move(text), .type = design::kNote, .colour = design::kInk2, .align = Align::kCentre};
}

void add_ready(Page& page, const Rect& card, const PhoneWay& way) {
    constexpr float kLine = 40.0F;
    constexpr float kLines = 2.0F * kLine + 36.0F;
    const bool has_all = has_room(page, card, way.page, kLines);
    const float room = std::min(card.width, card.height - (has_all ? kLines : kLine));
    float y = add_code(page, way.page, {card.centre().x, card.y}, room).bottom();
    if (has_all) page.words(line_below(card, y, kLine), strong(page.t("home.point")));
    if (has_all) y += kLine;
    page.fixed_words(line_below(card, y, kLine), strong(way.code));
    if (has_all) page.words(line_below(card, y + kLine, 36.0F), quiet(page.t("home.gone")));
}

void add_wifi(Page& page, const Rect& card, const PhoneWay& way) {
    constexpr float kTitle = 44.0F;
    constexpr float kName = 38.0F;
    constexpr float kStep = 34.0F;
    const bool has_all = has_room(page, card, *way.wifi, kTitle + kName + kStep);
    const float lines = kTitle + kName + (has_all ? kStep : 0.0F);
    page.words(line_below(card, card.y + 3.0F, kTitle), strong(page.t("home.w1")));
    const float y = add_code(page, *way.wifi, {card.centre().x, card.y + kTitle},
                             std::min(card.width, card.height - lines))
                        .bottom();
    page.fixed_words(line_below(card, y, kName), strong(way.wifi_name));
    if (has_all) {
        page.fixed_words(line_below(card, y + kName, kStep),
                         quiet(page.digits("1") + " / " + page.digits("2")));
    }
}

void add_packing(Page& page, const Rect& card) {
    page.words(line_below(card, card.y + 26.0F, 44.0F), strong(page.t("home.making")));
    constexpr float kCoil = 172.0F;
    constexpr float kDone = 0.55F;  // fixed: the work takes some seconds and reports no progress
    ui::Sketch sketch;
    const ui::Placing placing{.at = vec2(0.0F), .scale = vec2(kCoil / kSpiralSide)};
    for (const auto& [part, colour] : {std::pair(1.0F, design::kRule), std::pair(kDone, design::kBareClay)}) {
        sketch.add(ui::Shape{
            .path = spiral_path(part), .placing = placing, .stroke = colour, .stroke_width = 12.0F});
    }
    page.sprite({card.centre().x - 0.5F * kCoil, card.y + 116.0F, kCoil, kCoil}, std::move(sketch));
    page.words(line_below(card, card.y + 356.0F, 36.0F), quiet(page.t("home.gone")));
}

// Explains in a friendly way what went wrong and what to do.
void add_waiting(Page& page, const Rect& card, Icon icon, const char* title, const char* line,
                 const char* action) {
    ui::Sketch sketch;
    add_icon(sketch, icon, {0.0F, 0.0F}, 68.0F, design::kInk);
    page.sprite({card.centre().x - 34.0F, card.y + 28.0F, 68.0F, 68.0F}, std::move(sketch));
    page.words(line_below(card, card.y + 106.0F, 44.0F), strong(page.t(title)));
    page.words(line_below(card, card.y + 150.0F, 72.0F), quiet(page.t(line)));
    page.token({card.centre().x - 140.0F, card.y + 238.0F, 280.0F, 66.0F}, Look::kToken, Button::kShareAgain,
               page.named(action));
}

void add_phone_card(Page& page, const Rect& card) {
    const Phone phone = page.view().state.keeping.phone;
    const PhoneWay* const way = page.view().phone.get();
    const bool shows_code = phone == Phone::kReady || phone == Phone::kWifi;
    const bool waits = phone == Phone::kResting || phone == Phone::kOver;
    const Rect box{card.x, card.y, card.width, waits ? std::min(card.height, 330.0F) : card.height};
    page.card(box, design::kPorcelain, design::kPorcelain);
    if (phone == Phone::kResting) {
        add_waiting(page, box, Icon::kNoWifi, "home.nonet", "home.nonet2", "home.retry");
    } else if (phone == Phone::kOver) {
        add_waiting(page, box, Icon::kNoCode, "home.expired", "home.gone", "home.new");
    } else if (!shows_code || way == nullptr) {
        add_packing(page, box);
    } else if (phone == Phone::kWifi && way->wifi) {
        add_wifi(page, box, *way);
    } else {
        add_ready(page, box, *way);
    }
}

bool is_kept(const View& view) {
    return view.state.keeping.outcome == Keeping::Outcome::kKept;
}

bool has_phone_card(const View& view) {
    return view.state.keeping.phone != Phone::kNone && is_kept(view);
}

// Draws the day's other pots, dimmer, on both sides of the new one.
void day_pots(Page& page, vec2 new_foot) {
    const View& view = page.view();
    if (!view.shelf) return;
    const float width = page.width();
    const float own_reach = 190.0F;
    float reach[2]{new_foot.x - own_reach, new_foot.x + own_reach};
    for (std::size_t i = 0; i < view.shelf->size(); ++i) {
        const ShelfPot& other = (*view.shelf)[i];
        const float scale =
            std::min({0.8F, 130.0F / other.shape.height_mm(), 70.0F / other.shape.radius_mm()});
        const float half = other.shape.radius_mm() * scale + 12.0F;
        const bool left = i % 2 == 0;
        const float x = left ? reach[0] - half : reach[1] + half;
        const float taken = page.is_tall()         ? 24.0F
                            : has_phone_card(view) ? 508.0F
                            : page.is_low()        ? 206.0F
                                                   : 24.0F;
        if (x - half < 24.0F || x + half > width - taken) continue;
        page.pot(other.shape, finish::glaze_at(other.glaze), scale, {page.mirrored(x), new_foot.y}, 0.76F);
        (left ? reach[0] : reach[1]) += left ? -2.0F * half : 2.0F * half;
    }
}

void new_pot(Page& page, vec2 foot) {
    const View& view = page.view();
    if (!view.pot) return;
    const float scale = std::min({2.2F, 330.0F / (2.0F * view.pot->shape.radius_mm()),
                                  (foot.y - 150.0F) / (view.pot->shape.height_mm() * 1.12F)});
    page.keep_clear(page.turning_pot(view.pot->shape, finish::glaze_at(view.state.glaze), scale,
                                     {page.mirrored(foot.x), foot.y}));
}

void keep_title(Page& page) {
    const View& view = page.view();
    const bool tall = page.is_tall();
    const bool full = view.state.keeping.outcome == Keeping::Outcome::kFull;
    const float title_width = tall ? page.width() - 250.0F : page.width() - 260.0F;
    page.words(page.mirrored({32.0F, 24.0F, title_width, tall || full ? 126.0F : 66.0F}),
               {.text = full            ? page.t("keep.fail")
                        : is_kept(view) ? page.t(has_phone_card(view) ? "home.title" : "keep.title")
                                        : page.t("keep.saving"),
                .type = full ? design::bold(34.0F, 44.0F) : design::kTitle});
}

// Shows the number of a kept pot and the promise to keep it.
void keep_promise(Page& page, float shelf_y) {
    const View& view = page.view();
    const bool tall = page.is_tall();
    const bool has_phone = has_phone_card(view);
    const float y =
        tall ? (has_phone ? 1028.0F : 930.0F) + page.lower_by() : shelf_y + (view.has_wall ? 36.0F : 54.0F);
    const Rect rect = page.mirrored({36.0F, y, page.by_shape(620.0F, 480.0F, page.width() - 72.0F),
                                     (has_phone && tall) || (view.has_wall && !tall) ? 44.0F : 84.0F});
    const std::string number = page.t("keep.no", page.digits(std::to_string(view.state.keeping.number)));
    const std::string promise = page.t(has_phone ? "home.priv" : "keep.priv");
    const bool one_line = tall ? has_phone : view.has_wall;
    page.words(rect, {.text = one_line ? promise : number + "\n" + promise,
                      .type = design::kLine,
                      .colour = design::kSlip3,
                      .align = tall ? ui::Align::kCentre : ui::Align::kStart});
}

// Adds the tokens for the wall of the day, for another pot and for finishing.
void keep_tokens(Page& page, float finish_width) {
    const View& view = page.view();
    const float width = page.width();
    const bool joins = has_phone_card(view) && view.state.keeping.phone == Phone::kWifi;
    const Button next = joins ? Button::kOnWifi : Button::kAnother;
    const Name next_name = page.named(joins ? "home.wnext" : "keep.again");
    const bool offers_wall = is_kept(view) && view.has_wall;
    const auto wall_token = [&](const Rect& rect) {
        page.token(page.mirrored(rect), Look::kToken, Button::kOnWall, page.named("home.shelf"), 0,
                   view.state.keeping.on_wall ? std::optional(Icon::kCheck) : std::nullopt);
        if (view.state.keeping.on_wall) page.say_chosen();
    };
    if (page.is_tall()) {
        const float down = page.lower_by();
        const float wall_width = offers_wall ? 0.62F * (width - 120.0F) : 0.0F;
        if (offers_wall) wall_token({60.0F, 1090.0F + down, wall_width - 18.0F, 84.0F});
        page.token(page.mirrored({60.0F + wall_width, 1090.0F + down, width - 120.0F - wall_width, 84.0F}),
                   Look::kPrimary, next, next_name);
        page.token(page.mirrored({60.0F, 1190.0F + down, finish_width, 68.0F}), Look::kOutline,
                   Button::kFinish, page.named("keep.end"));
        return;
    }
    const bool square = page.is_square();
    const float y = page.height() - (square ? 118.0F : 130.0F);
    const float again = square ? 240.0F : 264.0F;
    page.token(page.mirrored({width - 32.0F - again, y, again, 78.0F}), Look::kPrimary, next, next_name);
    page.token(page.mirrored({width - 50.0F - again - finish_width, y, finish_width, 78.0F}), Look::kOutline,
               Button::kFinish, page.named("keep.end"));
    if (offers_wall) {
        const float room = width - 50.0F - again - finish_width - 18.0F - 32.0F;
        // In a square picture the promise ends just above.
        const float lower = square ? 30.0F : 0.0F;
        wall_token({32.0F, y + lower, std::min(room, 440.0F), 78.0F - 0.5F * lower});
    }
}

void draw_keep(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const bool has_phone = has_phone_card(view);
    const float shelf_y = page.by_shape(508.0F, 548.0F, 560.0F);
    const vec2 foot(!has_phone || tall ? 0.5F * width : page.is_square() ? 270.0F : 390.0F, shelf_y + 12.0F);
    page.museum({page.mirrored(foot.x), 0.44F * height}, {0.46F * width, 0.6F * height}, 0.32F);
    page.shelf(shelf_y, 32.0F);
    day_pots(page, foot);
    new_pot(page, foot);
    keep_title(page);
    // With low controls the languages' token is under the phone's card or beside the last token. The code may
    // stay high, because it is never pressed.
    const Phone phone = view.state.keeping.phone;
    const bool asks = phone == Phone::kResting || phone == Phone::kOver;
    const float down = page.lower_by();
    const float card_y = !page.is_low() ? 104.0F : asks ? 0.5F * height - 232.0F : 28.0F + down;
    const Rect phone_card = tall ? Rect{110.0F, 600.0F + down, 500.0F, 416.0F}
                                 : page.mirrored({width - 484.0F, card_y, 452.0F, asks ? 330.0F : 416.0F});
    const float finish_width = tall ? width - 120.0F - (page.is_low() ? 168.0F : 0.0F) : 190.0F;
    page.languages_token({tall ? 60.0F + finish_width + 18.0F : width - 182.0F,
                          tall        ? 1194.0F + down
                          : has_phone ? phone_card.bottom() + 18.0F
                                      : 432.0F + down,
                          150.0F, 60.0F});
    if (is_kept(view)) keep_promise(page, shelf_y);
    if (has_phone) add_phone_card(page, phone_card);
    if (view.state.keeping.outcome != Keeping::Outcome::kSaving) keep_tokens(page, finish_width);
}

void enter_keep(Turn& turn) {
    turn.state.keeping = {};
    turn.add(effect::Save{});
}

void share(Turn& turn) {
    turn.state.keeping.phone = Phone::kPacking;
    turn.add(effect::Share{});
}

void take_saved(Turn& turn, std::optional<int> number) {
    Keeping& keeping = turn.state.keeping;
    if (keeping.outcome != Keeping::Outcome::kSaving) return;
    if (!number) {
        keeping = {.outcome = Keeping::Outcome::kFull};
        return;
    }
    keeping = {.outcome = Keeping::Outcome::kKept, .number = *number};
    if (turn.rules.shares) share(turn);
}

void take_shared(Turn& turn, const event::Shared& shared) {
    Keeping& keeping = turn.state.keeping;
    // Ignore answers about an earlier visitor's pot.
    if (keeping.number != shared.number) return;
    const bool waits = keeping.phone == Phone::kPacking;
    const bool has_code = keeping.phone == Phone::kWifi || keeping.phone == Phone::kReady;
    if (shared.outcome == ShareOutcome::kReady && waits) {
        keeping.phone = turn.rules.has_wifi ? Phone::kWifi : Phone::kReady;
    } else if (shared.outcome == ShareOutcome::kFailed && waits) {
        keeping.phone = Phone::kResting;
    } else if (shared.outcome == ShareOutcome::kOver && has_code) {
        keeping.phone = Phone::kOver;
    }
}

void take_keep(Turn& turn, const Event& event) {
    if (const auto* const saved = std::get_if<event::Saved>(&event)) take_saved(turn, saved->number);
    if (std::holds_alternative<event::SaveFailed>(event)) take_saved(turn, std::nullopt);
    if (const auto* const shared = std::get_if<event::Shared>(&event)) take_shared(turn, *shared);
}

void press_keep(Turn& turn, const event::Pressed& event) {
    Keeping& keeping = turn.state.keeping;
    if (keeping.outcome == Keeping::Outcome::kSaving) return;  // wait until the pot is saved
    if (event.button == Button::kAnother) {
        turn.show(Screen::kChoose);
    } else if (event.button == Button::kFinish) {
        turn.end_visit();
    } else if (event.button == Button::kOnWifi && keeping.phone == Phone::kWifi) {
        keeping.phone = Phone::kReady;
    } else if (event.button == Button::kOnWall && turn.rules.has_wall &&
               keeping.outcome == Keeping::Outcome::kKept) {
        keeping.on_wall = !keeping.on_wall;
        turn.add(effect::Wall{.up = keeping.on_wall});
    } else if (event.button == Button::kShareAgain &&
               (keeping.phone == Phone::kResting || keeping.phone == Phone::kOver)) {
        share(turn);
    }
}

bool is_at_work(const State& state) {
    return state.keeping.outcome == Keeping::Outcome::kSaving || state.keeping.phone == Phone::kPacking;
}

std::string_view phone_key(Phone phone) {
    switch (phone) {
        case Phone::kNone:
            break;
        case Phone::kPacking:
            return "home.making";
        case Phone::kWifi:
            return "home.w1";
        case Phone::kReady:
            return "home.title";
        case Phone::kResting:
            return "home.nonet";
        case Phone::kOver:
            return "home.expired";
    }
    return "keep.title";
}

std::string_view spoken_while_keeping(const State& state) {
    const Keeping& keeping = state.keeping;
    switch (keeping.outcome) {
        case Keeping::Outcome::kKept:
            return phone_key(keeping.phone);
        case Keeping::Outcome::kFull:
            return "keep.fail";
        case Keeping::Outcome::kSaving:
            break;
    }
    return "keep.saving";
}

}  // namespace

extern constinit const Step kKeepStep{.screen = Screen::kKeep,
                                      .name = "keep",
                                      .enter = enter_keep,
                                      .press = press_keep,
                                      .take = take_keep,
                                      .works = is_at_work,
                                      .draw = draw_keep,
                                      .spoken = spoken_while_keeping};

}  // namespace onggi::visit
