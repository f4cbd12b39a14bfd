// A piece of text and its style. Any thread; plain data. Lengths are u (a design's unit).
#pragma once

#include <string>

#include "engine/ui/colour.h"

namespace onggi::ui {

enum class Align { kStart, kCentre, kEnd };  // kStart is left in left-to-right text

struct TextStyle {
    // Font families in order of preference, separated by commas: the first that has a glyph draws it.
    std::string family = "Noto Sans";
    bool bold = false;
    float size = 26.0F;         // em
    float line_height = 32.0F;  // distance between lines
    Colour colour{};
    Align align = Align::kStart;
    bool right_to_left = false;  // direction of the paragraph; letters use their own
    std::string language{};      // BCP 47, for shaping and line breaks

    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

struct Text {
    std::string words;  // UTF-8, U+000A begins a new line
    TextStyle style;
    float width = 0.0F;  // wraps between words at this width; 0: one line of any width

    friend bool operator==(const Text&, const Text&) = default;
};

struct TextSize {
    float width = 0.0F;  // of the widest line
    float height = 0.0F;
    int lines = 0;
    int unknown_glyphs = 0;  // letters without a glyph in any font
    bool too_wide = false;   // a word is wider than the wrap width
};

}  // namespace onggi::ui
