// What was drawn on a pot as the wheel's picture shows it: the texture dressed in the colours of a glaze or
// of raw clay. Any one thread.
#pragma once

#include "engine/render/scene.h"
#include "game/decoration/canvas.h"
#include "game/finish/glaze.h"

namespace onggi::look {

class DressedMarks {
  public:
    // The whole of it.
    void dress(const decoration::Texture& texture, const decoration::Wall& wall,
               const finish::MarkPalette& palette);
    // What has changed of it since, in the same colours.
    void dress_changed(const decoration::Texture& texture, const decoration::Wall& wall,
                       const finish::MarkPalette& palette, const decoration::TextureRect& changed);

    [[nodiscard]] const render::LatheMarks& marks() const { return marks_; }

  private:
    render::LatheMarks marks_;
};

// A glazed lathe, as far as it can wear that glaze: one colour, and the glass over it. body: as its clay
// wears its own.
[[nodiscard]] render::LatheMaterial glazed_lathe(const render::LatheMaterial& body,
                                                 const finish::GlazeMaterial& glaze);

}  // namespace onggi::look
