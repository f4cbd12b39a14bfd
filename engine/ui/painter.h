// Turns sketches into pictures, with Cairo for shapes and Pango for text: shaping, right-to-left, line breaks
// and font fallback. This room is the only user of both. Any thread, but one at a time: kiosks paint outside
// the frame, because a first label costs tens of ms and later ones up to thirty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/ui/painting.h"
#include "engine/ui/sketch.h"
#include "engine/ui/text.h"

namespace onggi::ui {

// A drawing of vectors: lines and letters keep their sizes on paper.
enum class VectorKind { kSvg, kPdf };

class Painter {
  public:
    Painter();
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // Results are cached.
    [[nodiscard]] TextSize measure(const Text& text);
    [[nodiscard]] Painting paint(const Sketch& sketch);

    // The sketch as a file whose page has its size, u being millimetres; px_per_u has no effect. SVG holds
    // letters as outlines and no style attributes, PDF text, and title and subject in its properties. The
    // same sketch gives the same bytes: no time is stored. Fades and shadows become pictures of 72 dpi.
    [[nodiscard]] std::vector<std::byte> draw_vectors(const Sketch& sketch, VectorKind kind,
                                                      const std::string& title,
                                                      const std::string& subject = {});

    // Number of texts and pictures that the calling thread has laid out or painted so far, with any painter.
    // Frames must not do any.
    [[nodiscard]] static std::uint64_t work_of_this_thread();

    // Returns those of `families` that are not installed. Pango replaces a missing family by the nearest one.
    [[nodiscard]] std::vector<std::string> missing_families(std::span<const std::string> families) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::ui
