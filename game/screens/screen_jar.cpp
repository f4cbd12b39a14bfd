// A jar of two bowls: what lies ahead; what is told at each step; the one bowl on the other.
#include <fmt/format.h>

#include <algorithm>

#include "game/screens/page/ledge_parts.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using kiosk::JarStep;
using ui::Rect;

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

// Where the two bowls are to be seen.
Rect bowls_box(const Page& page) {
    const float top = ledge_top(page);
    return page.by_shape(Rect{400.0F, 56.0F, 480.0F, top - 70.0F}, Rect{290.0F, 114.0F, 400.0F, top - 124.0F},
                         Rect{150.0F, 440.0F, 420.0F, top - 460.0F});
}

}  // namespace

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
    const float pitch = std::min(96.0F, (wide - 60.0F) / (kiosk::kJarSteps - 1));
    const float steps_wide = pitch * (kiosk::kJarSteps - 1) + 56.0F;
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
               page.t("moon.begin"));
}

void add_jar_card(Page& page) {
    const kiosk::JarMaking& jar = page.view().state.throwing.jar;
    if (jar.step == JarStep::kNone || jar.touched || jar.is_low || jar.rims_apart) return;
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float wide = page.by_shape(304.0F, 250.0F, 390.0F);
    add_paper(page,
              page.mirrored({square ? 20.0F : 32.0F, tall ? 32.0F : 112.0F, wide,
                             page.by_shape(240.0F, 300.0F, 196.0F)}),
              {{.text = told_of(page, jar.step), .type = design::kPaper, .colour = design::kInk2}});
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

}  // namespace onggi::screens
