// Turns sketches into pictures, with Cairo for shapes and Pango for text: shaping, right-to-left, line breaks
// and fallback between fonts. This room is the only user of both. One thread at a time, but any: kiosks paint
// beside the frame, because a first label costs tens of ms and later ones up to thirty.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/ui/painting.h"
#include "engine/ui/sketch.h"
#include "engine/ui/text.h"

namespace onggi::ui {

class Painter {
  public:
    Painter();
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // Remembered, so that asking again costs a look-up.
    [[nodiscard]] TextSize measure(const Text& text);
    [[nodiscard]] Painting paint(const Sketch& sketch);

    // How many texts and pictures the calling thread has laid out or painted so far, with whatever painter: a
    // frame may have none of them.
    [[nodiscard]] static std::uint64_t work_of_this_thread();

    // Those of `families` that this machine has not. A missing one is replaced by the nearest there is.
    [[nodiscard]] std::vector<std::string> missing_families(std::span<const std::string> families) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::ui
