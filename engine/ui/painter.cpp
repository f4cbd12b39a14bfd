#include "engine/ui/painter.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include "engine/ui/canvas.h"
#include "engine/ui/text_layout.h"

namespace onggi::ui {
namespace {

// What measuring depends on, as one key.
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

// The size of letters at which all text is measured: for each new one Pango has fontconfig sort the machine's
// fonts, and who looks for the largest size that fits asks for many. Half a unit of Pango's more than whole
// ones: it cuts off the rest.
constexpr float kMeasuredPx = 64.0F + 0.5F / PANGO_SCALE;

thread_local std::uint64_t work_done = 0;

}  // namespace

struct Painter::Impl {
    FontMap fonts = create_font_map();
    Context context = create_context(fonts.get());
    std::unordered_map<std::string, TextSize> sizes;

    void write(cairo_t* cairo, const Writing& writing, float px_per_u) const;
};

Painter::Painter() : impl_(std::make_unique<Impl>()) {}
Painter::~Painter() = default;

TextSize Painter::measure(const Text& text) {
    std::string key = key_of(text);
    if (const auto found = impl_->sizes.find(key); found != impl_->sizes.end()) return found->second;
    ++work_done;
    const float px_per_u = kMeasuredPx / text.style.size;
    const TextSize size = size_of(lay_out(impl_->context.get(), text, px_per_u, 0.0F).get(), text);
    if (impl_->sizes.size() >= kMostRemembered) impl_->sizes.clear();
    impl_->sizes.emplace(std::move(key), size);
    return size;
}

// Line by line, each in the middle of its line height, as a browser does; Pango's own spacing depends on
// whichever fallback font a line happens to use.
void Painter::Impl::write(cairo_t* cairo, const Writing& writing, float px_per_u) const {
    const TextStyle& style = writing.text.style;
    const Layout layout = lay_out(context.get(), writing.text, px_per_u, writing.box_width * px_per_u);
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

Painting Painter::paint(const Sketch& sketch) {
    ++work_done;
    const auto pixels = [&](float u) {
        return std::max(1, static_cast<int>(std::ceil(u * sketch.px_per_u - 1e-3F)));
    };
    const Surface surface = create_surface(pixels(sketch.size.x), pixels(sketch.size.y));
    const Cairo cairo(cairo_create(surface.get()));
    cairo_scale(cairo.get(), double{sketch.px_per_u}, double{sketch.px_per_u});
    for (const SketchItem& item : sketch.items) {
        if (const auto* shadow = std::get_if<Shadow>(&item)) {
            draw(cairo.get(), *shadow, sketch.px_per_u);
        } else if (const auto* writing = std::get_if<Writing>(&item)) {
            impl_->write(cairo.get(), *writing, sketch.px_per_u);
        } else if (const auto* box = std::get_if<Box>(&item)) {
            draw(cairo.get(), *box);
        } else if (const auto* frame = std::get_if<Frame>(&item)) {
            draw(cairo.get(), *frame);
        } else if (const auto* ellipse = std::get_if<Ellipse>(&item)) {
            draw(cairo.get(), *ellipse);
        } else if (const auto* shape = std::get_if<Shape>(&item)) {
            draw(cairo.get(), *shape);
        } else if (const auto* picture = std::get_if<Picture>(&item)) {
            draw(cairo.get(), *picture);
        }
    }
    if (sketch.fade) fade(cairo.get(), *sketch.fade);
    return read(surface.get());
}

std::uint64_t Painter::work_of_this_thread() {
    return work_done;
}

std::vector<std::string> Painter::missing_families(std::span<const std::string> families) const {
    PangoFontFamily** known = nullptr;
    int count = 0;
    pango_font_map_list_families(impl_->fonts.get(), &known, &count);
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
