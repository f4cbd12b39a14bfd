// From the wheel to the glaze: the pot is cut off, dried, decorated, fired and glazed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "game/visit/finish/finish.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

// The material of the clay, which pales as it dries and glows in the kiln.
const finish::GlazeMaterial& dry_clay() {
    static const finish::GlazeMaterial clay = [] {
        finish::GlazeMaterial made = finish::wet_clay();
        made.id = "dry";
        made.body = made.colour = vec3(0.58F, 0.47F, 0.36F);
        made.thin_colour = vec3(0.66F, 0.55F, 0.43F);
        made.clear_coat = 0.0F;
        made.roughness = 0.9F;
        return made;
    }();
    return clay;
}

const finish::GlazeMaterial& glowing_clay() {
    static const finish::GlazeMaterial clay = [] {
        finish::GlazeMaterial made = dry_clay();
        made.id = "glowing";
        made.body = made.colour = vec3(1.5F, 0.22F, 0.04F);
        made.thin_colour = vec3(1.8F, 0.36F, 0.08F);
        // The decoration glows too; dark colours glow less.
        finish::MarkPalette& marks = made.marks;
        for (vec3* colour :
             {&marks.white_slip, &marks.black_slip, &marks.iron, &marks.cobalt, &marks.coat, &marks.finger}) {
            const float light = glm::dot(*colour, vec3(0.21F, 0.72F, 0.07F));
            *colour = made.colour * (0.62F + 0.7F * light);
        }
        return made;
    }();
    return clay;
}

constexpr float kKilnHalf = 330.0F;
constexpr float kKilnTall = 510.0F;
constexpr ui::Colour kKilnDark = ui::hex(0x1b0f09);

Rect kiln_field(vec2 floor, float scale) {
    return {floor.x - kKilnHalf * scale, floor.y - kKilnTall * scale, 2.0F * kKilnHalf * scale,
            kKilnTall * scale + 4.0F};
}

void dark(Page& page) {
    page.box({0.0F, 0.0F, page.width(), page.height()}, {kKilnDark, kKilnDark, kKilnDark, kKilnDark});
}

// Draws the arch and the fire's light in it, in a field of 660 x 510. `floor` is the middle of its floor.
void kiln_mouth(Page& page, vec2 floor, float scale) {
    ui::Sketch sketch;
    const ui::Placing placing{.at = {0.0F, 0.0F}, .scale = vec2(scale)};
    const char* const kMouth = "M60 510 V280 C60 110 170 34 330 34 C490 34 600 110 600 280 V510 Z";
    sketch.add(ui::Shape{.path = kMouth, .placing = placing, .fill = ui::hex(0xb84f18)});
    sketch.add(ui::Ellipse{Rect{110.0F, 110.0F, 440.0F, 480.0F}.scaled(scale),
                           ui::Fill::round(ui::hex(0xffb35a), ui::hex(0xc8571b, 0.0F))});
    sketch.add(ui::Shape{.path = "M60 510 V280 C60 110 170 34 330 34 C490 34 600 110 600 280 V510",
                         .placing = placing,
                         .stroke = ui::hex(0x2a150b),
                         .stroke_width = 46.0F});
    std::string bricks;
    for (int i = 0; i <= 14; ++i) {
        const float angle = kPiF * (1.0F - static_cast<float>(i) / 14.0F);
        const auto point = [&](float rx, float ry) {
            const float x = 330.0F + rx * std::cos(angle);
            const float y = 280.0F - ry * std::sin(angle);
            return std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y));
        };
        bricks += "M" + point(247.0F, 222.0F) + " L" + point(293.0F, 269.0F) + " ";
    }
    bricks += "M37 350 H83 M577 350 H623 M37 420 H83 M577 420 H623 M37 490 H83 M577 490 H623";
    sketch.add(ui::Shape{
        .path = bricks, .placing = placing, .stroke = ui::hex(0x4d2612, 0.9F), .stroke_width = 3.0F});
    page.sprite(kiln_field(floor, scale), std::move(sketch));
}

// Draws the kiln alone, in the dark. `floor` as above.
void kiln(Page& page, vec2 floor, float scale) {
    page.covers();
    dark(page);
    const float half = kKilnHalf * scale;
    const float tall = kKilnTall * scale;
    const Rect shine{floor.x - 2.0F * half, floor.y - 1.75F * tall, 4.0F * half, 2.6F * tall};
    const vec2 reach(0.5F * shine.width, 0.5F * shine.height);
    page.moving({.flicker = 0.22F}, [&] {
        page.shade(ui::overlap(shine, {0.0F, 0.0F, page.width(), page.height()}), [&](vec2 at) {
            const float away = std::min(1.0F, glm::length((at - shine.centre()) / reach));
            return ui::mix(ui::hex(0xc2561c, 0.85F), kKilnDark.with_alpha(0.0F), away);
        });
    });
    kiln_mouth(page, floor, scale);
}

// In front of the pot's foot.
constexpr float kBeforeFloor = 12.0F;

// How far the door is raised, out of the picture.
float door_way(vec2 floor) {
    return floor.y + 2.0F * kBeforeFloor;
}

// The door of bricks, which is lowered before the mouth and raised again; the fire shines through its joints.
void kiln_door(Page& page, vec2 floor, float scale) {
    constexpr Rect kDoorField{62.0F, 36.0F, 536.0F, 478.0F};
    constexpr float kMiddle = 330.0F;
    constexpr float kSpring = 280.0F;  // from here up the door is an arch
    constexpr float kHalf = 256.0F;
    constexpr float kRise = 232.0F;
    constexpr float kCourse = 46.0F;
    constexpr float kBrick = 104.0F;
    const auto half_at = [&](float y) {
        const float above = std::max(0.0F, kSpring - y) / kRise;
        return kHalf * std::sqrt(std::max(0.0F, 1.0F - above * above));
    };
    std::string joints;
    const auto line = [&](float x, float y, float to_x, float to_y) {
        joints += fmt::format("M{:.0f} {:.0f} L{:.0f} {:.0f} ", x, y, to_x, to_y);
    };
    int course = 0;
    for (float y = kKilnTall - kCourse; y > kSpring - 0.95F * kRise; y -= kCourse, ++course) {
        const float half = half_at(y);
        line(kMiddle - half, y, kMiddle + half, y);
        const float under = half_at(y + kCourse);
        const float shift = course % 2 == 0 ? 0.0F : 0.5F * kBrick;
        for (float x = shift - 3.0F * kBrick; x <= 3.0F * kBrick; x += kBrick)
            if (std::abs(x) < std::min(half, under) - 8.0F) line(kMiddle + x, y, kMiddle + x, y + kCourse);
    }
    const Rect field = kDoorField.scaled(scale);
    const ui::Placing placing{.at = {-field.x, -field.y}, .scale = vec2(scale)};
    const char* const kDoor = "M68 510 V280 C68 118 178 42 330 42 C482 42 592 118 592 280 V510 Z";
    ui::Sketch sketch;
    sketch.add(ui::Shape{.path = kDoor,
                         .placing = placing,
                         .fill = ui::hex(0x4a2816),
                         .stroke = kKilnDark,
                         .stroke_width = 7.0F});
    sketch.add(ui::Shape{
        .path = joints, .placing = placing, .stroke = ui::hex(0xf08a34, 0.62F), .stroke_width = 3.0F});
    sketch.add(ui::Ellipse{Rect{296.0F, 190.0F, 68.0F, 68.0F}.scaled(scale).moved({-field.x, -field.y}),
                           ui::Fill::round(ui::hex(0xffdf9c), ui::hex(0xf0701c, 0.0F))});
    const vec2 corner = floor - scale * vec2(kMiddle, kKilnTall) + vec2(0.0F, kBeforeFloor);
    page.sprite(field.moved(corner), std::move(sketch));
}

// The layout of the glaze screen's words and tokens, before mirroring.
struct GlazePlaces {
    Rect line;
    Rect hides;
    Rect decorate;
    Rect take;
    Rect languages;  // used with low controls
};

GlazePlaces glaze_places(const Page& page, float shelf_y) {
    const float right = page.width() - 32.0F;
    const float down = page.lower_by();
    switch (page.shape()) {
        case Shape::kTall: {
            // With low controls the row also holds the languages' token.
            const float wide = right - 318.0F - (page.is_low() ? 166.0F : 0.0F);
            return {.line = {40.0F, down + shelf_y + 40.0F, right - 48.0F, 44.0F},
                    .hides = {40.0F, down + shelf_y + 86.0F, right - 48.0F, 44.0F},
                    .decorate = {32.0F, down + shelf_y + 140.0F, 270.0F, 80.0F},
                    .take = {318.0F, down + shelf_y + 140.0F, wide, 80.0F},
                    .languages = {right - 150.0F, down + shelf_y + 150.0F, 150.0F, 60.0F}};
        }
        case Shape::kSquare:
            return {.line = {right - 300.0F, down + 104.0F, 300.0F, 174.0F},
                    .hides = {right - 300.0F, down + 282.0F, 300.0F, 96.0F},
                    .decorate = {right - 236.0F, down + 384.0F, 236.0F, 60.0F},
                    .take = {right - 236.0F, down + 454.0F, 236.0F, 66.0F},
                    .languages = {32.0F, down + 397.0F, 150.0F, 60.0F}};
        case Shape::kWide:
            break;
    }
    return {.line = {right - 340.0F, down + 176.0F, 340.0F, 118.0F},
            .hides = {right - 340.0F, down + 296.0F, 340.0F, 76.0F},
            .decorate = {page.is_low() ? 198.0F : 32.0F, down + 376.0F, 236.0F, 74.0F},
            .take = {right - 220.0F, down + 376.0F, 220.0F, 74.0F},
            .languages = {32.0F, down + 383.0F, 150.0F, 60.0F}};
}

// Describes the glaze and, on a decorated pot, its effect on the decoration.
void glaze_words(Page& page, const GlazePlaces& places, const finish::GlazeMaterial& glaze) {
    const auto& pot = page.view().pot;
    const bool was_made_for_it = pot && pot->drawn_with.inlaid && glaze.glaze == finish::Glaze::kCeladon;
    Words words{.text = page.t(was_made_for_it ? "glz.line.inlay" : glaze.line_key), .type = {27.0F, 38.0F}};
    if (page.is_tall()) words.align = ui::Align::kCentre;
    const bool hides = pot && finish::hides(glaze, pot->drawn_with);
    Rect line = places.line;
    if (!hides) line.height = places.hides.bottom() - line.y;  // no text below
    page.words(page.mirrored(line), words);
    if (!hides) return;
    words.text = page.t("glz.hides");
    words.type = words.type.bold_if(true);
    page.words(page.mirrored(places.hides), words);
}

// The note on shrinking is true of the drying alone; in the kiln the sound may have a caption there.
void add_firing_note(Page& page, const Rect& rect) {
    const FiringStage stage = page.view().state.firing;
    const std::string_view note = stage == FiringStage::kDry    ? "fin.note"
                                  : stage == FiringStage::kFire ? std::string_view(page.view().heard)
                                                                : std::string_view();
    if (note.empty()) return;
    page.words(rect, {.text = page.t(note),
                      .type = design::kLabel,
                      .colour = ui::hex(0xdcc7ac),
                      .align = ui::Align::kCentre});
}

// Soft flames behind the pot; `floor` as for kiln().
void fire(Page& page, vec2 floor, float scale) {
    struct Flame {
        vec2 middle;  // from the floor's middle
        vec2 size;
    };
    constexpr std::array kFlames{
        Flame{{-195.0F, -70.0F}, {90.0F, 300.0F}},  Flame{{-120.0F, -120.0F}, {120.0F, 420.0F}},
        Flame{{-30.0F, -170.0F}, {140.0F, 520.0F}}, Flame{{65.0F, -150.0F}, {130.0F, 480.0F}},
        Flame{{140.0F, -110.0F}, {110.0F, 400.0F}}, Flame{{205.0F, -66.0F}, {80.0F, 280.0F}}};
    float phase_rad = 0.0F;
    for (const Flame& flame : kFlames) {
        const vec2 size = scale * flame.size;
        const vec2 corner = floor + scale * flame.middle - 0.5F * size;
        ui::Sketch sketch;
        sketch.add(ui::Ellipse{{0.0F, 0.0F, size.x, size.y},
                               ui::Fill::round(ui::hex(0xffd384, 0.75F), ui::hex(0xf0701c, 0.0F))});
        page.moving({.flicker = 0.8F, .phase_rad = phase_rad}, [&] {
            page.sprite({corner.x, corner.y, size.x, floor.y - corner.y}, std::move(sketch));
        });
        phase_rad += 1.9F;
    }
}

// The wire under the pot: drawn through from behind the pot to the visitor.
void cutting_wire(Page& page, vec2 foot, float half_width) {
    constexpr float kHandle = 46.0F;
    const ui::Rect field{foot.x - half_width, foot.y - 4.0F, 2.0F * half_width, 16.0F};
    ui::Sketch sketch;
    sketch.add(ui::Box{
        {0.5F * kHandle, 7.0F, field.width - kHandle, 2.0F}, 1.0F, ui::Fill::flat(ui::hex(0xd8d2c6))});
    for (const float x : {0.0F, field.width - kHandle})
        sketch.add(ui::Box{{x, 1.0F, kHandle, 14.0F}, 7.0F, ui::Fill::flat(ui::hex(0xb98c4e))});
    page.moving({.lasts_s = 1.0F, .from_y_u = -26.0F}, [&] { page.sprite(field, std::move(sketch)); });
}

void draw_firing(Page& page) {
    const View& view = page.view();
    const FiringStage stage = view.state.firing;
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const float words_y = height - (tall ? 330.0F : 124.0F);
    const vec2 floor(0.5F * width, tall ? 820.0F : height - 160.0F);
    const float kiln_scale = tall ? 0.95F : 1.0F;
    if (stage == FiringStage::kFire) {
        kiln(page, floor, kiln_scale);
        fire(page, floor, kiln_scale);
    } else {
        page.museum({floor.x, 0.4F * height}, {0.4F * width, 0.6F * height}, 0.22F);
        page.shelf(floor.y - 12.0F, 36.0F);
    }
    if (view.pot) {
        const float scale = std::min(2.4F, fitting_scale(view.pot->shape, 420.0F, tall ? 560.0F : 440.0F));
        // The pot shrinks as it dries and in the kiln: the pot of the stage before fades into this one's.
        constexpr std::array kShrunk{1.0F, 0.95F, 0.9F};
        const std::array clays{&finish::wet_clay(), &dry_clay(), &glowing_clay()};
        const auto place = static_cast<std::size_t>(stage);
        const auto pot_of = [&](std::size_t at) {
            return page.pot(view.pot->shape, *clays[at], scale * kShrunk[at], floor);
        };
        if (stage == FiringStage::kCut)
            cutting_wire(page, floor, scale * view.pot->shape.radius_mm() + 90.0F);
        else
            page.moving({.begins_s = 0.7F, .lasts_s = 0.6F, .to_alpha = 0.0F}, [&] { pot_of(place - 1); });
        page.moving({.lasts_s = 1.1F, .from_alpha = stage == FiringStage::kCut ? 1.0F : 0.0F},
                    [&] { page.keep_clear(pot_of(place)); });
    }
    // Who wants less motion sees the pot in the fire instead.
    if (stage == FiringStage::kFire && !view.state.comfort.still)
        page.moving({.begins_s = 1.3F, .lasts_s = 0.7F, .from_y_u = -door_way(floor)},
                    [&] { kiln_door(page, floor, kiln_scale); });
    page.down({0.0F, words_y - 66.0F, width, 66.0F}, kKilnDark.with_alpha(0.0F), kKilnDark.with_alpha(0.93F));
    page.down({0.0F, words_y, width, height - words_y}, kKilnDark.with_alpha(0.93F), kKilnDark);
    constexpr std::array kKeys{"fin.cut", "fin.dry", "fin.fire"};
    const float column = tall ? 218.0F : std::min(230.0F, (width - 264.0F) / 3.0F);
    const float left =
        tall ? 33.0F : std::max(32.0F, 0.5F * width - 1.5F * column - (width < 1200.0F ? 100.0F : 0.0F));
    for (int i = 0; i < 3; ++i) {
        const bool now = i == static_cast<int>(stage);
        const bool past = i < static_cast<int>(stage);
        const Rect place =
            page.mirrored({left + static_cast<float>(i) * column, words_y + 4.0F, column - 10.0F, 48.0F});
        Words words{.text = page.t(kKeys[static_cast<std::size_t>(i)]),
                    .type = {now ? 34.0F : 28.0F, 44.0F, now ? design::Face::kBold : design::Face::kPlain},
                    .colour = now ? ui::hex(0xfff3d9) : ui::hex(0xdcc7ac),
                    .align = ui::Align::kCentre};
        if (past) {
            const float wide = std::min(place.width - 60.0F, page.words_width(words) * page.text_scale());
            ui::Sketch tick;
            add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 24.0F, ui::hex(0xdcc7ac));
            const float x = page.right_to_left() ? place.centre().x + 0.5F * wide + 14.0F
                                                 : place.centre().x - 0.5F * wide - 38.0F;
            page.sprite({x, place.y + 10.0F, 24.0F, 24.0F}, std::move(tick));
        }
        const Rect inner{place.x + (past ? 34.0F : 0.0F), place.y, place.width - (past ? 68.0F : 0.0F),
                         place.height};
        page.words(inner, words);
        if (now) {
            ui::Sketch bar;
            bar.add(ui::Box{{0.0F, 0.0F, 160.0F, 6.0F}, 3.0F, ui::Fill::flat(design::kAmber)});
            page.sprite({place.centre().x - 80.0F, place.y + 52.0F, 160.0F, 6.0F}, std::move(bar));
        }
    }
    add_firing_note(page, tall ? Rect{33.0F, words_y + 72.0F, width - 66.0F, 72.0F}
                               : page.mirrored({left, words_y + 64.0F, 3.0F * column - 10.0F, 36.0F}));
    const float button = 180.0F;
    page.token(tall ? Rect{0.5F * (width - 280.0F), height - 130.0F, 280.0F, 80.0F}
                    : page.mirrored({width - 32.0F - button, words_y - 4.0F, button, 66.0F}),
               Look::kOutline, Button::kSkip, page.named("fin.skip"));
}

void draw_glazes(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const int glaze = view.state.glaze;
    const int columns = tall ? 3 : Rules().glaze_count;
    const int rows = (finish::kGlazeCount + columns - 1) / columns;
    const float gap = square ? 10.0F : 14.0F;
    const float niche_width =
        std::min(tall ? 206.0F : 186.0F,
                 (width - 48.0F - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    const float niche_height = tall ? 190.0F : 158.0F;
    const float niches_y = height - 16.0F - static_cast<float>(rows) * (niche_height + gap) + gap;
    const float shelf_y = tall ? 640.0F : niches_y - 68.0F;
    const float pot_x = square ? 0.40F * width : 0.5F * width;
    const float centre_x = page.right_to_left() && square ? width - pot_x : pot_x;
    page.museum({centre_x, 0.38F * height}, {0.34F * width, 0.56F * height}, 0.30F);
    page.shelf(shelf_y, 34.0F);
    const finish::GlazeMaterial& chosen = finish::glaze_at(glaze);
    const float box_width = page.by_shape(360.0F, 420.0F, 560.0F);
    if (view.pot) {
        const float scale =
            std::min(3.2F, fitting_scale(view.pot->shape, box_width, shelf_y - (tall ? 110.0F : 80.0F)));
        const vec2 foot(centre_x, shelf_y + 12.0F);
        // The kiln's door opens, and the glaze comes out as the pot cools.
        const Motion cools{.begins_s = 0.8F, .lasts_s = 1.1F, .to_alpha = 0.0F};
        constexpr float kMouthWidth = 450.0F;
        const float kiln_scale =
            std::max(shelf_y / kKilnTall, 2.0F * scale * view.pot->shape.radius_mm() / kMouthWidth);
        page.moving(cools, [&] {
            dark(page);
            kiln_mouth(page, foot, kiln_scale);
        });
        page.keep_clear(page.pot(view.pot->shape, chosen, scale, foot));
        page.moving(cools, [&] { page.pot(view.pot->shape, glowing_clay(), scale, foot); });
        const float way = door_way(foot);
        page.moving({.begins_s = 0.2F, .lasts_s = 0.8F, .from_y_u = way},
                    [&] { kiln_door(page, foot - vec2(0.0F, way), kiln_scale); });
    }
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, 66.0F}),
               {.text = page.t("glz.title"), .type = design::kTitle});
    const GlazePlaces places = glaze_places(page, shelf_y);
    page.languages_token(places.languages);
    glaze_words(page, places, chosen);
    page.token(page.mirrored(places.take), Look::kPrimary, Button::kTakeGlaze, page.named("glz.take"));
    page.token(page.mirrored(places.decorate), Look::kToken, Button::kDecorateAgain, page.named("dec.title"),
               0, Icon::kIronBrush);
    const float left = 0.5F * (width - static_cast<float>(columns) * (niche_width + gap) + gap);
    for (int i = 0; i < finish::kGlazeCount; ++i) {
        const finish::GlazeMaterial& one = finish::glaze_at(i);
        const bool on = i == glaze;
        const Rect niche = page.mirrored({left + static_cast<float>(i % columns) * (niche_width + gap),
                                          niches_y + static_cast<float>(i / columns) * (niche_height + gap),
                                          niche_width, niche_height});
        page.card_niche(niche, on, Button::kGlaze, i, page.named(one.name_key));
        if (view.pot) {
            const float scale = fitting_scale(view.pot->shape, niche_width - 40.0F, niche_height - 54.0F);
            page.pot(view.pot->shape, one, scale, {niche.centre().x, niche.bottom() - 52.0F});
        }
        page.words({niche.x + 6.0F, niche.bottom() - 43.0F, niche.width - 12.0F, 38.0F},
                   {.text = page.t(one.name_key),
                    .type = {27.0F, 34.0F, on ? design::Face::kBold : design::Face::kPlain},
                    .colour = on ? design::kInk : design::kSlip,
                    .align = ui::Align::kCentre});
        if (!on) continue;
        ui::Sketch tick;
        add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 30.0F, design::kInk);
        const float x = page.right_to_left() ? niche.right() - 40.0F : niche.x + 10.0F;
        page.sprite({x, niche.y + 8.0F, 30.0F, 30.0F}, std::move(tick));
    }
}

void end_drying(Turn& turn) {
    turn.show(turn.state.trimming.is_offered ? Screen::kTrim : Screen::kDecorate);
}

void pass_firing(Turn& turn) {
    const double passed_s = turn.now_s - turn.state.screen_s;
    const Rules& rules = turn.rules;
    if (turn.state.firing == FiringStage::kFire) {
        if (passed_s >= rules.fire_s) turn.show(Screen::kGlaze);
    } else if (passed_s >= rules.cut_s + rules.dry_s) {
        end_drying(turn);
    } else if (passed_s >= rules.cut_s) {
        turn.state.firing = FiringStage::kDry;
    }
}

void press_firing(Turn& turn, const event::Pressed& event) {
    if (event.button != Button::kSkip) return;
    if (turn.state.firing == FiringStage::kFire) {
        turn.show(Screen::kGlaze);
    } else {
        end_drying(turn);
    }
}

void take_firing(Turn& turn, const Event& event) {
    State& state = turn.state;
    if (std::holds_alternative<event::ThickFoot>(event))
        state.trimming.is_offered = state.firing != FiringStage::kFire;
}

void enter_glaze(Turn& turn) {
    turn.state.glaze = std::clamp(turn.state.glaze, 0, turn.rules.glaze_count - 1);
}

void press_glaze(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kGlaze && event.value >= 0 && event.value < turn.rules.glaze_count) {
        turn.state.glaze = event.value;
    } else if (event.button == Button::kTakeGlaze) {
        turn.show(Screen::kYourPot);
    } else if (event.button == Button::kDecorateAgain) {
        turn.show(Screen::kDecorate);
    }
}

std::string_view spoken_while_firing(const State& state) {
    switch (state.firing) {
        case FiringStage::kCut:
            return "fin.cut";
        case FiringStage::kDry:
            return "fin.dry";
        case FiringStage::kFire:
            break;
    }
    return "fin.fire";
}

std::string_view spoken_of_glazes(const State& /*state*/) {
    return "glz.title";
}

}  // namespace

bool kiln_burns(const State& state) {
    return state.screen == Screen::kFiring && state.firing == FiringStage::kFire &&
           state.panel == Panel::kNone;
}

float fitting_scale(const pot::Section& shape, float box_width, float box_height) {
    const float across = 2.0F * std::max(1.0F, shape.radius_mm());
    const float up = std::max(1.0F, shape.height_mm()) + 0.24F * shape.radius_mm();
    return std::min((box_width - 16.0F) / across, (box_height - 16.0F) / up);
}

extern constinit const Step kFiringStep{.screen = Screen::kFiring,
                                        .name = "firing",
                                        .press = press_firing,
                                        .take = take_firing,
                                        .tick = pass_firing,
                                        .draw = draw_firing,
                                        .spoken = spoken_while_firing};

extern constinit const Step kGlazeStep{.screen = Screen::kGlaze,
                                       .name = "glaze",
                                       .enter = enter_glaze,
                                       .press = press_glaze,
                                       .draw = draw_glazes,
                                       .spoken = spoken_of_glazes};

}  // namespace onggi::visit
