#include "engine/ui/painter.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/core/within_memory.h"
#include "engine/math/math.h"
#include "engine/ui/painting.h"
#include "engine/ui/path.h"
#include "engine/ui/sketch.h"
#include "engine/ui/text.h"

namespace onggi::ui {

// RAII handles for Pango's objects.
struct Unreference {
    void operator()(void* object) const { g_object_unref(object); }
};
using FontMap = std::unique_ptr<PangoFontMap, Unreference>;
using Context = std::unique_ptr<PangoContext, Unreference>;
using Layout = std::unique_ptr<PangoLayout, Unreference>;

namespace {

// Drawing with Cairo. Lengths are pixels unless stated otherwise.
struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyCairo {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
struct DestroyPattern {
    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;
using Cairo = std::unique_ptr<cairo_t, DestroyCairo>;
using Pattern = std::unique_ptr<cairo_pattern_t, DestroyPattern>;

void set_colour(cairo_t* cairo, const Colour& colour) {
    cairo_set_source_rgba(cairo, double{colour.r}, double{colour.g}, double{colour.b}, double{colour.a});
}

void rounded_rect(cairo_t* cairo, const Rect& rect, float radius) {
    const double r = std::min({radius, 0.5F * rect.width, 0.5F * rect.height});
    const double left = double{rect.x} + r;
    const double right = double{rect.right()} - r;
    const double top = double{rect.y} + r;
    const double bottom = double{rect.bottom()} - r;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, right, top, r, -0.5 * kPi, 0.0);
    cairo_arc(cairo, right, bottom, r, 0.0, 0.5 * kPi);
    cairo_arc(cairo, left, bottom, r, 0.5 * kPi, kPi);
    cairo_arc(cairo, left, top, r, kPi, 1.5 * kPi);
    cairo_close_path(cairo);
}

void add_stop(cairo_pattern_t* pattern, double at, const Colour& colour) {
    cairo_pattern_add_color_stop_rgba(pattern, at, double{colour.r}, double{colour.g}, double{colour.b},
                                      double{colour.a});
}

void set_fill(cairo_t* cairo, const Fill& fill, const Rect& rect) {
    if (fill.kind == Fill::Kind::kFlat) {
        set_colour(cairo, fill.from);
        return;
    }
    Pattern pattern;
    const double x = double{rect.x};
    const double y = double{rect.y};
    if (fill.kind == Fill::Kind::kRound) {
        // Maps the ellipse in the rect to the unit circle.
        pattern.reset(cairo_pattern_create_radial(0.0, 0.0, 0.0, 0.0, 0.0, 1.0));
        cairo_matrix_t to_unit;
        cairo_matrix_init_scale(&to_unit, 2.0 / double{rect.width}, 2.0 / double{rect.height});
        cairo_matrix_translate(&to_unit, -double{rect.centre().x}, -double{rect.centre().y});
        cairo_pattern_set_matrix(pattern.get(), &to_unit);
    } else if (fill.kind == Fill::Kind::kDown) {
        pattern.reset(cairo_pattern_create_linear(x, y, x, double{rect.bottom()}));
    } else {
        pattern.reset(cairo_pattern_create_linear(x, y, double{rect.right()}, y));
    }
    add_stop(pattern.get(), 0.0, fill.from);
    add_stop(pattern.get(), 1.0, fill.to);
    cairo_set_source(cairo, pattern.get());
}

// Three passes of a box filter approximate a Gaussian within 3 % (W. M. Wells, 1986).
void blur_alpha(std::uint8_t* pixels, int width, int height, int stride, int radius) {
    std::vector<std::uint8_t> line(static_cast<std::size_t>(std::max(width, height)));
    const auto blur_line = [&](std::uint8_t* first, int count, int step) {
        const int window = 2 * radius + 1;
        const auto at = [&](int index) -> int {
            return index < 0 || index >= count ? 0 : first[static_cast<std::ptrdiff_t>(index) * step];
        };
        int sum = 0;
        for (int i = -radius; i <= radius; ++i)
            sum += at(i);
        for (int i = 0; i < count; ++i) {
            line[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(sum / window);
            sum += at(i + radius + 1) - at(i - radius);
        }
        for (int i = 0; i < count; ++i)
            first[static_cast<std::ptrdiff_t>(i) * step] = line[static_cast<std::size_t>(i)];
    };
    for (int pass = 0; pass < 3; ++pass) {
        for (int y = 0; y < height; ++y)
            blur_line(pixels + static_cast<std::ptrdiff_t>(y) * stride, width, 1);
        for (int x = 0; x < width; ++x)
            blur_line(pixels + x, height, stride);
    }
}

void place(cairo_t* cairo, const Placing& placing) {
    cairo_translate(cairo, double{placing.at.x}, double{placing.at.y});
    cairo_rotate(cairo, double{placing.turn_rad});
    cairo_scale(cairo, double{placing.scale.x}, double{placing.scale.y});
}

void trace(cairo_t* cairo, const std::vector<PathStep>& steps) {
    for (const PathStep& step : steps) {
        const double x = double{step.to.x};
        const double y = double{step.to.y};
        switch (step.kind) {
            case PathStep::Kind::kMove:
                cairo_move_to(cairo, x, y);
                break;
            case PathStep::Kind::kLine:
                cairo_line_to(cairo, x, y);
                break;
            case PathStep::Kind::kCurve:
                cairo_curve_to(cairo, double{step.first_control.x}, double{step.first_control.y},
                               double{step.second_control.x}, double{step.second_control.y}, x, y);
                break;
            case PathStep::Kind::kClose:
                cairo_close_path(cairo);
                break;
        }
    }
}

// Cairo goes on without memory, and draws nothing more.
void expect_memory(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) refuse_memory();
}

Surface create_surface(int width, int height, cairo_format_t format = CAIRO_FORMAT_ARGB32) {
    Surface surface(cairo_image_surface_create(format, width, height));
    expect_memory(cairo_surface_status(surface.get()));
    return surface;
}

// Lengths of the items are u; the context is already scaled to them.
void draw(cairo_t* cairo, const Box& box) {
    rounded_rect(cairo, box.rect, box.radius);
    set_fill(cairo, box.fill, box.rect);
    cairo_fill(cairo);
}

void draw(cairo_t* cairo, const Frame& frame) {
    rounded_rect(cairo, frame.rect.grown(-0.5F * frame.width), frame.radius - 0.5F * frame.width);
    set_colour(cairo, frame.colour);
    cairo_set_line_width(cairo, double{frame.width});
    cairo_stroke(cairo);
}

void draw(cairo_t* cairo, const Shadow& shadow, float px_per_u) {
    const Rect reach = shadow.rect.grown(shadow.blur);
    const int width = static_cast<int>(std::ceil(reach.width * px_per_u));
    const int height = static_cast<int>(std::ceil(reach.height * px_per_u));
    if (width <= 0 || height <= 0) return;
    const Surface mask = create_surface(width, height, CAIRO_FORMAT_A8);
    {
        const Cairo into(cairo_create(mask.get()));
        cairo_scale(into.get(), double{px_per_u}, double{px_per_u});
        cairo_translate(into.get(), -double{reach.x}, -double{reach.y});
        rounded_rect(into.get(), shadow.rect, shadow.radius);
        cairo_set_source_rgba(into.get(), 0.0, 0.0, 0.0, 1.0);
        cairo_fill(into.get());
    }
    cairo_surface_flush(mask.get());
    blur_alpha(cairo_image_surface_get_data(mask.get()), width, height,
               cairo_image_surface_get_stride(mask.get()),
               std::max(1, static_cast<int>(shadow.blur * px_per_u / 3.0F)));
    cairo_surface_mark_dirty(mask.get());
    cairo_save(cairo);
    cairo_translate(cairo, double{reach.x}, double{reach.y});
    cairo_scale(cairo, 1.0 / double{px_per_u}, 1.0 / double{px_per_u});
    set_colour(cairo, shadow.colour);
    cairo_mask_surface(cairo, mask.get(), 0.0, 0.0);
    cairo_restore(cairo);
}

void draw(cairo_t* cairo, const Ellipse& ellipse) {
    cairo_save(cairo);
    const vec2 centre = ellipse.rect.centre();
    cairo_translate(cairo, double{centre.x}, double{centre.y});
    cairo_scale(cairo, 0.5 * double{ellipse.rect.width}, 0.5 * double{ellipse.rect.height});
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, 0.0, 0.0, 1.0, 0.0, kTurn);
    cairo_restore(cairo);
    set_fill(cairo, ellipse.fill, ellipse.rect);
    cairo_fill(cairo);
}

void draw(cairo_t* cairo, const Shape& shape) {
    const auto steps = read_path(shape.path);
    if (!steps) return;  // paths are built in, and a test reads all of them
    cairo_save(cairo);
    place(cairo, shape.placing);
    trace(cairo, *steps);
    if (shape.fill) {
        set_colour(cairo, *shape.fill);
        cairo_fill_preserve(cairo);
    }
    if (shape.stroke) {
        set_colour(cairo, *shape.stroke);
        cairo_set_line_width(cairo, double{shape.stroke_width});
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        if (shape.dash > 0.0F) {
            const double dots[]{0.01, double{shape.dash}};
            cairo_set_dash(cairo, dots, 2, 0.0);
        }
        cairo_stroke_preserve(cairo);
    }
    cairo_new_path(cairo);
    cairo_restore(cairo);
}

void draw(cairo_t* cairo, const Picture& picture) {
    if (!picture.painting || picture.painting->width == 0) return;
    const Painting& painting = *picture.painting;
    const Surface source = create_surface(painting.width, painting.height);
    std::uint8_t* const to = cairo_image_surface_get_data(source.get());
    const int stride = cairo_image_surface_get_stride(source.get());
    const auto dimmed = [&](std::uint8_t value) {
        return static_cast<std::uint8_t>(static_cast<float>(value) * picture.brightness + 0.5F);
    };
    for (int y = 0; y < painting.height; ++y) {
        const std::uint8_t* from = painting.rgba.data() + static_cast<std::ptrdiff_t>(y) * painting.width * 4;
        std::uint8_t* row = to + static_cast<std::ptrdiff_t>(y) * stride;
        for (int x = 0; x < painting.width; ++x, from += 4, row += 4) {
            row[0] = dimmed(from[2]);
            row[1] = dimmed(from[1]);
            row[2] = dimmed(from[0]);
            row[3] = from[3];
        }
    }
    cairo_surface_mark_dirty(source.get());
    cairo_save(cairo);
    cairo_translate(cairo, double{picture.rect.x}, double{picture.rect.y});
    cairo_scale(cairo, double{picture.rect.width} / painting.width,
                double{picture.rect.height} / painting.height);
    cairo_set_source_surface(cairo, source.get(), 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
    cairo_paint(cairo);
    cairo_restore(cairo);
}

// Fades out what has been drawn so far, from opaque at one point to transparent at the other.
void fade(cairo_t* cairo, const Sketch::Fade& fade) {
    const Pattern pattern(cairo_pattern_create_linear(double{fade.whole.x}, double{fade.whole.y},
                                                      double{fade.gone.x}, double{fade.gone.y}));
    add_stop(pattern.get(), 0.0, {0.0F, 0.0F, 0.0F, 1.0F});
    add_stop(pattern.get(), 1.0, {0.0F, 0.0F, 0.0F, 0.0F});
    cairo_save(cairo);
    cairo_set_operator(cairo, CAIRO_OPERATOR_DEST_IN);
    cairo_set_source(cairo, pattern.get());
    cairo_paint(cairo);
    cairo_restore(cairo);
}

Painting read(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    Painting painting;
    painting.width = cairo_image_surface_get_width(surface);
    painting.height = cairo_image_surface_get_height(surface);
    painting.rgba.resize(static_cast<std::size_t>(painting.width) *
                         static_cast<std::size_t>(painting.height) * 4);
    const std::uint8_t* const from = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    std::uint8_t* to = painting.rgba.data();
    for (int y = 0; y < painting.height; ++y) {
        const std::uint8_t* row = from + static_cast<std::ptrdiff_t>(y) * stride;
        for (int x = 0; x < painting.width; ++x, row += 4, to += 4) {
            // Cairo stores a pixel as one word, alpha highest.
            std::uint32_t word = 0;
            std::memcpy(&word, row, sizeof word);
            to[0] = static_cast<std::uint8_t>(word >> 16U);
            to[1] = static_cast<std::uint8_t>(word >> 8U);
            to[2] = static_cast<std::uint8_t>(word);
            to[3] = static_cast<std::uint8_t>(word >> 24U);
        }
    }
    return painting;
}

// Text layout with Pango.
int pango_units(float px) {
    return static_cast<int>(std::lround(px * PANGO_SCALE));
}

// Korean text must break between words; Unicode's rules would allow a break between any two syllables, and so
// does Pango (findings/pango-breaks-inside-korean-words-under-every-language.sh).
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
        word = g_utf8_find_next_char(at, nullptr);
    }
}

FontMap create_font_map() {
    // The first font map makes Pango read fontconfig's files in a thread of its own. Another thread that
    // calls fontconfig at that moment reads them too, and the two corrupt each other's memory (issue 784 of
    // Pango). FcInit() here, once, loads them before either does.
    static const FcBool has_fonts = FcInit();
    static_cast<void>(has_fonts);
    return FontMap(pango_cairo_font_map_new());
}

// Grey antialiasing and no hinting: the same glyphs at the same positions on every screen.
Context create_context(PangoFontMap* fonts) {
    // At 72 dpi one point is one pixel.
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts), 72.0);
    Context context(pango_font_map_create_context(fonts));
    // Glyph positions are not rounded to pixels. Otherwise a line that was measured at one size could be
    // wider at another, and its last word would wrap into a line that is not visible.
    pango_context_set_round_glyph_positions(context.get(), FALSE);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context.get(), options);
    cairo_font_options_destroy(options);
    return context;
}

// Lays out the text at `px_per_u`; width 0 means one line. Alignment is within `box_width_px`.
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
    // The direction is the paragraph's, not that of its first letter: "(1.7 l)" is also placed correctly in
    // Arabic.
    pango_layout_set_auto_dir(layout.get(), FALSE);
    pango_context_set_base_dir(context, style.right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);
    pango_layout_context_changed(layout.get());
    pango_layout_set_text(layout.get(), text.words.data(), static_cast<int>(text.words.size()));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD);
    int wide = -1;
    if (text.width > 0.0F) {
        wide = pango_units(text.width * px_per_u);
    } else if (box_width_px > 0.0F) {
        // A box as wide as the text was measured at another scale may be a hair too narrow: it must not break
        // the line.
        pango_layout_get_size(layout.get(), &wide, nullptr);
        wide = std::max(wide, pango_units(box_width_px));
    }
    pango_layout_set_width(layout.get(), wide);
    // Without auto_dir, Pango's left is the page's left, whatever the paragraph's direction.
    PangoAlignment alignment = PANGO_ALIGN_CENTER;
    if (style.align != Align::kCentre) {
        alignment =
            (style.align == Align::kStart) == style.right_to_left ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
    }
    pango_layout_set_alignment(layout.get(), alignment);
    return layout;
}

// Returns the size of the text from its layout at any scale.
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

// Key of everything that a measurement depends on.
std::string key_of(const Text& text) {
    std::string key = text.words;
    key += '\0';
    key += text.style.family;
    key += '\0';
    key += text.style.language;
    key += text.style.bold ? 'b' : 'r';
    key += text.style.right_to_left ? '<' : '>';
    for (const float value : {text.style.size, text.style.line_height, text.width}) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        key.append(bytes, sizeof bytes);
    }
    return key;
}

constexpr std::size_t kMostRemembered = 4096;

// All text is measured at this glyph size: for each new size Pango makes fontconfig sort the machine's fonts
// (findings/pango-sorts-all-fonts-again-for-each-new-size.sh), and a search for the largest size that fits
// tries many. The extra half of a Pango unit compensates for truncation.
constexpr float kMeasuredPx = 64.0F + 0.5F / PANGO_SCALE;

thread_local std::uint64_t work_done = 0;

}  // namespace

struct Painter::Impl {
    std::unordered_map<std::string, TextSize> sizes;

    // Made with the first text: a picture of a pot needs no fonts, and Pango ends the program where it finds
    // no memory.
    PangoFontMap* fonts() {
        if (!font_map) font_map = create_font_map();
        return font_map.get();
    }
    PangoContext* context() {
        if (!pango_context) pango_context = create_context(fonts());
        return pango_context.get();
    }
    void write(cairo_t* cairo, const Writing& writing, float px_per_u);
    void draw_items(cairo_t* cairo, const Sketch& sketch, float px_per_u);

  private:
    FontMap font_map;
    Context pango_context;
};

Painter::Painter() : impl_(std::make_unique<Impl>()) {}
Painter::~Painter() = default;

TextSize Painter::measure(const Text& text) {
    std::string key = key_of(text);
    if (const auto found = impl_->sizes.find(key); found != impl_->sizes.end()) return found->second;
    ++work_done;
    const float px_per_u = kMeasuredPx / text.style.size;
    const TextSize size = size_of(lay_out(impl_->context(), text, px_per_u, 0.0F).get(), text);
    if (impl_->sizes.size() >= kMostRemembered) impl_->sizes.clear();
    impl_->sizes.emplace(std::move(key), size);
    return size;
}

// Writes line by line, each centred in its line height, as a browser does; Pango's own line spacing depends
// on the fallback fonts that a line uses.
void Painter::Impl::write(cairo_t* cairo, const Writing& writing, float px_per_u) {
    const TextStyle& style = writing.text.style;
    const Layout layout = lay_out(context(), writing.text, px_per_u, writing.box_width * px_per_u);
    cairo_save(cairo);
    cairo_identity_matrix(cairo);
    set_colour(cairo, style.colour);
    PangoLayoutIter* iter = pango_layout_get_iter(layout.get());
    double line_top = double{writing.at.y} * double{px_per_u};
    const double line_height = double{style.line_height} * double{px_per_u};
    do {
        PangoRectangle logical{};
        pango_layout_iter_get_line_extents(iter, nullptr, &logical);
        const double above =
            static_cast<double>(pango_layout_iter_get_baseline(iter) - logical.y) / PANGO_SCALE;
        const double height = static_cast<double>(logical.height) / PANGO_SCALE;
        cairo_move_to(cairo,
                      double{writing.at.x} * double{px_per_u} + static_cast<double>(logical.x) / PANGO_SCALE,
                      line_top + 0.5 * (line_height - height) + above);
        pango_cairo_show_layout_line(cairo, pango_layout_iter_get_line_readonly(iter));
        line_top += line_height;
    } while (pango_layout_iter_next_line(iter));
    pango_layout_iter_free(iter);
    cairo_restore(cairo);
}

void Painter::Impl::draw_items(cairo_t* cairo, const Sketch& sketch, float px_per_u) {
    cairo_scale(cairo, double{px_per_u}, double{px_per_u});
    for (const SketchItem& item : sketch.items) {
        if (const auto* shadow = std::get_if<Shadow>(&item)) {
            draw(cairo, *shadow, px_per_u);
        } else if (const auto* writing = std::get_if<Writing>(&item)) {
            write(cairo, *writing, px_per_u);
        } else if (const auto* box = std::get_if<Box>(&item)) {
            draw(cairo, *box);
        } else if (const auto* frame = std::get_if<Frame>(&item)) {
            draw(cairo, *frame);
        } else if (const auto* ellipse = std::get_if<Ellipse>(&item)) {
            draw(cairo, *ellipse);
        } else if (const auto* shape = std::get_if<Shape>(&item)) {
            draw(cairo, *shape);
        } else if (const auto* picture = std::get_if<Picture>(&item)) {
            draw(cairo, *picture);
        }
    }
    if (sketch.fade) fade(cairo, *sketch.fade);
    expect_memory(cairo_status(cairo));
}

Painting Painter::paint(const Sketch& sketch) {
    ++work_done;
    const auto pixels = [&](float u) {
        return std::max(1, static_cast<int>(std::ceil(u * sketch.px_per_u - 1e-3F)));
    };
    const Surface surface = create_surface(pixels(sketch.size.x), pixels(sketch.size.y));
    const Cairo cairo(cairo_create(surface.get()));
    impl_->draw_items(cairo.get(), sketch, sketch.px_per_u);
    return read(surface.get());
}

namespace {

// Cairo's SVG with presentation attributes in place of style attributes, which a server's content security
// policy may forbid (Content Security Policy Level 3, style-src-attr).
std::string without_styles(std::string_view svg) {
    constexpr std::string_view kStyle = " style=\"";
    std::string plain;
    plain.reserve(svg.size());
    for (;;) {
        const std::size_t at = svg.find(kStyle);
        plain += svg.substr(0, at);
        if (at == std::string_view::npos) return plain;
        svg.remove_prefix(at + kStyle.size());
        std::string_view style = svg.substr(0, svg.find('"'));
        svg.remove_prefix(style.size() + 1);
        while (!style.empty()) {
            std::string_view one = style.substr(0, style.find(';'));
            style.remove_prefix(std::min(style.size(), one.size() + 1));
            one.remove_prefix(std::min(one.size(), one.find_first_not_of(' ')));
            const std::size_t colon = one.find(':');
            if (colon == std::string_view::npos) continue;
            plain.append(" ").append(one.substr(0, colon));
            plain.append("=\"").append(one.substr(colon + 1)).append("\"");
        }
    }
}

}  // namespace

std::vector<std::byte> Painter::draw_vectors(const Sketch& sketch, VectorKind kind, const std::string& title,
                                             const std::string& subject) {
    constexpr float kPointsPerMm = 72.0F / 25.4F;
    ++work_done;
    std::vector<std::byte> file;
    const cairo_write_func_t append = [](void* to, const unsigned char* data, unsigned size) {
        auto& bytes = *static_cast<std::vector<std::byte>*>(to);
        const auto* const first = reinterpret_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), first, first + size);
        return CAIRO_STATUS_SUCCESS;
    };
    const bool is_pdf = kind == VectorKind::kPdf;
    const float scale = is_pdf ? kPointsPerMm : 1.0F;
    const double width = double{sketch.size.x * scale};
    const double height = double{sketch.size.y * scale};
    const Surface surface(is_pdf ? cairo_pdf_surface_create_for_stream(append, &file, width, height)
                                 : cairo_svg_surface_create_for_stream(append, &file, width, height));
    if (is_pdf) {
        // cairo 1.18 compresses the properties in files of PDF 1.5, where simple readers do not find them.
        cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
        if (!subject.empty())
            cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT, subject.c_str());
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    } else {
        cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
    }
    const Cairo cairo(cairo_create(surface.get()));
    impl_->draw_items(cairo.get(), sketch, scale);
    cairo_show_page(cairo.get());
    cairo_surface_finish(surface.get());
    expect_memory(cairo_surface_status(surface.get()));
    if (is_pdf) return file;
    const std::string svg = without_styles({reinterpret_cast<const char*>(file.data()), file.size()});
    const auto bytes = std::as_bytes(std::span(svg));
    return {bytes.begin(), bytes.end()};
}

std::uint64_t Painter::work_of_this_thread() {
    return work_done;
}

std::vector<std::string> Painter::missing_families(std::span<const std::string> families) const {
    PangoFontFamily** known = nullptr;
    int count = 0;
    pango_font_map_list_families(impl_->fonts(), &known, &count);
    std::vector<std::string> missing;
    for (const std::string& family : families) {
        const bool is_there = std::any_of(known, known + count, [&](PangoFontFamily* one) {
            return std::string_view(pango_font_family_get_name(one)) == family;
        });
        if (!is_there) missing.push_back(family);
    }
    g_free(static_cast<void*>(known));
    return missing;
}

}  // namespace onggi::ui
