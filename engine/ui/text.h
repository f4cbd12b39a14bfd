// A piece of text and how it should look. Any thread; plain data. Lengths are u (a design's unit).
#pragma once

#include <string>

#include "engine/ui/colour.h"

namespace onggi::ui {

enum class Align { kStart, kCentre, kEnd };  // start is the left of a left-to-right line

struct TextStyle {
    // Families in the order they are asked for, with commas between: the first that has a letter draws it.
    std::string family = "Noto Sans";
    bool bold = false;
    float size = 26.0F;         // em
    float line_height = 32.0F;  // from one line to the next
    Colour colour{};
    Align align = Align::kStart;
    bool right_to_left = false;  // the paragraph; letters find their own way
    std::string language{};      // BCP 47, for shaping and line breaks

    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

struct Text {
    std::string words;  // UTF-8, U+000A begins a new line
    TextStyle style;
    float width = 0.0F;  // wraps between words at this width; 0: one line, as long as it gets

    friend bool operator==(const Text&, const Text&) = default;
};

struct TextSize {
    float width = 0.0F;  // of the widest line
    float height = 0.0F;
    int lines = 0;
    int unknown_glyphs = 0;  // letters that no font had
    bool too_wide = false;   // a word is wider than the width it should wrap at
};

}  // namespace onggi::ui
