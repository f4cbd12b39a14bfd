#include "engine/ui/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/ui/path.h"

namespace onggi::ui {
namespace {

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
        // Within the circle about the rect's middle that its height makes, stretched to its width.
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

// Three passes of a running mean are within 3 % of a Gaussian (W. M. Wells, 1986).
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

}  // namespace

Surface create_surface(int width, int height) {
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
}

void set_colour(cairo_t* cairo, const Colour& colour) {
    cairo_set_source_rgba(cairo, double{colour.r}, double{colour.g}, double{colour.b}, double{colour.a});
}

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
    const Surface mask(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));
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
    if (!steps) return;  // the paths are the program's own, and a test reads every one of them
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
            // Cairo keeps a pixel as one word, alpha highest.
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

}  // namespace onggi::ui
