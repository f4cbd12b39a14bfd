// The way home by phone: a card with the code, or with what keeps it waiting.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using kiosk::Phone;
using ui::Align;
using ui::Rect;

constexpr float kCodeSide = 248.0F;
// A camera at arm's length wants a code of this width (a tenth of the distance), and four modules of paper
// around it (ISO/IEC 18004).
constexpr float kLeastCodeMm = 60.0F;
constexpr float kQuietModules = 4.0F;

// Sharp at its edges: a module is a whole number of pixels. Never narrower than kLeastCodeMm where the card
// has room for that.
Rect add_code(Page& page, const PhoneCode& code, vec2 top_middle, float room) {
    const auto modules = static_cast<float>(code.side);
    const float px_per_u = page.px_per_u();
    const float least = kLeastCodeMm * static_cast<float>(page.view().px_per_mm) / px_per_u;
    const float most = room * modules / (modules + 2.0F * kQuietModules);
    const float wanted = std::min(std::max(kCodeSide, least), most);
    const bool is_least = wanted > kCodeSide;  // then it is rounded up, if that fits
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
    const Rect place{top_middle.x - 0.5F * side, top_middle.y, side, side};
    page.sprite(place, std::move(sketch));
    return place;
}

Rect line_below(const Rect& card, float y, float height) {
    return {card.x + 20.0F, y, card.width - 40.0F, height};
}

// What is to be read first, and what goes with it.
Words strong(std::string text) {
    return {
        .text = std::move(text), .type = design::kHeading, .colour = design::kInk, .align = Align::kCentre};
}
Words quiet(std::string text) {
    return {.text = std::move(text), .type = design::kNote, .colour = design::kInk2, .align = Align::kCentre};
}

void add_ready(Page& page, const Rect& card, const PhoneWay& way) {
    const Rect code = add_code(page, way.page, {card.centre().x, card.y + 28.0F}, card.width);
    page.words(line_below(card, code.bottom() + 12.0F, 40.0F), strong(page.t("home.point")));
    page.fixed_words(line_below(card, code.bottom() + 52.0F, 40.0F), strong(way.code));
    page.words(line_below(card, code.bottom() + 92.0F, 36.0F), quiet(page.t("home.gone")));
}

void add_wifi(Page& page, const Rect& card, const PhoneWay& way) {
    page.words(line_below(card, card.y + 18.0F, 44.0F), strong(page.t("home.w1")));
    const Rect code = add_code(page, *way.wifi, {card.centre().x, card.y + 74.0F}, card.width);
    page.fixed_words(line_below(card, code.bottom() + 14.0F, 38.0F), strong(way.wifi_name));
    page.fixed_words(line_below(card, code.bottom() + 52.0F, 34.0F),
                     quiet(page.digits("1") + " / " + page.digits("2")));
}

void add_packing(Page& page, const Rect& card) {
    page.words(line_below(card, card.y + 26.0F, 44.0F), strong(page.t("home.making")));
    constexpr float kCoil = 172.0F;
    constexpr float kDone = 0.55F;  // some seconds, of which nobody counts
    ui::Sketch sketch;
    const ui::Placing placing{.at = vec2(0.0F), .scale = vec2(kCoil / kSpiralSide)};
    for (const auto& [part, colour] : {std::pair(1.0F, design::kRule), std::pair(kDone, design::kBareClay)}) {
        sketch.add(ui::Shape{
            .path = spiral_path(part), .placing = placing, .stroke = colour, .stroke_width = 12.0F});
    }
    page.sprite({card.centre().x - 0.5F * kCoil, card.y + 116.0F, kCoil, kCoil}, std::move(sketch));
    page.words(line_below(card, card.y + 356.0F, 36.0F), quiet(page.t("home.gone")));
}

// What stands in the way, kindly, and what can be done about it.
void add_waiting(Page& page, const Rect& card, Icon icon, const char* title, const char* line,
                 const char* action) {
    ui::Sketch sketch;
    add_icon(sketch, icon, {0.0F, 0.0F}, 68.0F, design::kInk);
    page.sprite({card.centre().x - 34.0F, card.y + 28.0F, 68.0F, 68.0F}, std::move(sketch));
    page.words(line_below(card, card.y + 106.0F, 44.0F), strong(page.t(title)));
    page.words(line_below(card, card.y + 150.0F, 72.0F), quiet(page.t(line)));
    page.token({card.centre().x - 140.0F, card.y + 238.0F, 280.0F, 66.0F}, Look::kToken, Button::kShareAgain,
               page.t(action));
}

}  // namespace

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

}  // namespace onggi::screens
