// Cairo, in the few words that this room needs of it. The painter's thread. Lengths are pixels unless said.
#pragma once

#include <cairo.h>

#include <memory>

#include "engine/ui/painting.h"
#include "engine/ui/sketch.h"

namespace onggi::ui {

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

[[nodiscard]] Surface create_surface(int width, int height);

// Lengths of the items are u; the context is already scaled to them.
void draw(cairo_t* cairo, const Box& box);
void draw(cairo_t* cairo, const Frame& frame);
void draw(cairo_t* cairo, const Shadow& shadow, float px_per_u);
void draw(cairo_t* cairo, const Ellipse& ellipse);
void draw(cairo_t* cairo, const Shape& shape);
void draw(cairo_t* cairo, const Picture& picture);
// Leaves what is drawn so far whole at one point and nothing of it at the other.
void fade(cairo_t* cairo, const Sketch::Fade& fade);

[[nodiscard]] Painting read(cairo_surface_t* surface);

void set_colour(cairo_t* cairo, const Colour& colour);

}  // namespace onggi::ui
