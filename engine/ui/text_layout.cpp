#include "engine/ui/text_layout.h"

#include <fontconfig/fontconfig.h>

#include <cmath>
#include <string>

namespace onggi::ui {
namespace {

int pango_units(float px) {
    return static_cast<int>(std::lround(px * PANGO_SCALE));
}

// Korean is read in words; Unicode's rules would break a line between any two syllables.
void keep_korean_words_whole(PangoAttrList* attributes, const std::string& words) {
    const char* const begin = words.c_str();
    const char* word = begin;
    bool has_hangul = false;
    for (const char* at = begin;; at = g_utf8_find_next_char(at, nullptr)) {
        const gunichar letter = *at == '\0' ? 0 : g_utf8_get_char(at);
        if (letter != 0 && g_unichar_isspace(letter) == FALSE) {
            has_hangul = has_hangul || g_unichar_get_script(letter) == G_UNICODE_SCRIPT_HANGUL;
            continue;
        }
        if (has_hangul) {
            PangoAttribute* whole = pango_attr_allow_breaks_new(FALSE);
            whole->start_index = static_cast<guint>(word - begin);
            whole->end_index = static_cast<guint>(at - begin);
            pango_attr_list_insert(attributes, whole);
        }
        if (letter == 0) return;
        has_hangul = false;
        word = at + 1;
    }
}

}  // namespace

FontMap create_font_map() {
    // The first font map has fontconfig read its files in a thread of Pango's. Another thread that asks
    // fontconfig for anything just then reads them too, and the two spoil each other's memory (issue 784 of
    // Pango). Read here, once, both find it done.
    static const FcBool has_fonts = FcInit();
    static_cast<void>(has_fonts);
    return FontMap(pango_cairo_font_map_new());
}

Context create_context(PangoFontMap* fonts) {
    // At 72 dots an inch one point is one pixel.
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts), 72.0);
    Context context(pango_font_map_create_context(fonts));
    // Letters stand where their widths put them, not on whole pixels: a line that was measured at one size
    // would be wider at another, and lose its last word to a line that nobody sees.
    pango_context_set_round_glyph_positions(context.get(), FALSE);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context.get(), options);
    cairo_font_options_destroy(options);
    return context;
}

Layout lay_out(PangoContext* context, const Text& text, float px_per_u, float box_width_px) {
    const TextStyle& style = text.style;
    Layout layout(pango_layout_new(context));
    PangoFontDescription* font = pango_font_description_new();
    pango_font_description_set_family(font, style.family.c_str());
    pango_font_description_set_weight(font, style.bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font, double{style.size} * double{px_per_u} * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), font);
    pango_font_description_free(font);
    PangoAttrList* attributes = pango_attr_list_new();
    if (!style.language.empty()) {
        pango_attr_list_insert(attributes,
                               pango_attr_language_new(pango_language_from_string(style.language.c_str())));
    }
    keep_korean_words_whole(attributes, text.words);
    pango_layout_set_attributes(layout.get(), attributes);
    pango_attr_list_unref(attributes);
    // The direction is the paragraph's, not that of its first letter: "(1.7 l)" stands right in Arabic too.
    pango_layout_set_auto_dir(layout.get(), FALSE);
    pango_context_set_base_dir(context, style.right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    pango_layout_context_changed(layout.get());
    pango_layout_set_text(layout.get(), text.words.data(), static_cast<int>(text.words.size()));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD);
    const float wrap_px = text.width > 0.0F ? text.width * px_per_u : box_width_px;
    pango_layout_set_width(layout.get(), wrap_px > 0.0F ? pango_units(wrap_px) : -1);
    // Without auto_dir Pango's left is the page's left, whatever the paragraph's direction.
    PangoAlignment alignment = PANGO_ALIGN_CENTER;
    if (style.align != Align::kCentre) {
        alignment =
            (style.align == Align::kStart) == style.right_to_left ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
    }
    pango_layout_set_alignment(layout.get(), alignment);
    return layout;
}

TextSize size_of(PangoLayout* layout, const Text& text) {
    PangoRectangle logical{};
    pango_layout_get_extents(layout, nullptr, &logical);
    const auto font_size =
        static_cast<float>(pango_font_description_get_size(pango_layout_get_font_description(layout)));
    TextSize size;
    size.width = static_cast<float>(logical.width) * (text.style.size / font_size);
    size.lines = pango_layout_get_line_count(layout);
    size.height = text.style.line_height * static_cast<float>(size.lines);
    size.unknown_glyphs = pango_layout_get_unknown_glyphs_count(layout);
    size.too_wide = text.width > 0.0F && size.width > text.width + 0.5F;
    return size;
}

}  // namespace onggi::ui
