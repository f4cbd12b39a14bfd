// Pango, in the few words that this room needs of it. The painter's thread.
#pragma once

#include <pango/pangocairo.h>

#include <memory>

#include "engine/ui/text.h"

namespace onggi::ui {

struct Unreference {
    void operator()(void* object) const { g_object_unref(object); }
};
using FontMap = std::unique_ptr<PangoFontMap, Unreference>;
using Context = std::unique_ptr<PangoContext, Unreference>;
using Layout = std::unique_ptr<PangoLayout, Unreference>;

[[nodiscard]] FontMap create_font_map();
// Grey edges and no hinting: the same letters at the same places on every screen.
[[nodiscard]] Context create_context(PangoFontMap* fonts);

// The text laid out at `px_per_u`; width 0 is one line. Alignment is within `box_width_px`.
[[nodiscard]] Layout lay_out(PangoContext* context, const Text& text, float px_per_u, float box_width_px);

// Of a layout of it, at whatever size.
[[nodiscard]] TextSize size_of(PangoLayout* layout, const Text& text);

}  // namespace onggi::ui
