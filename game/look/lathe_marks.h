// The marks on a pot for the wheel's picture: the texture in the colours of a glaze or of raw clay. Any one
// thread.
#pragma once

#include "engine/render/scene.h"
#include "game/decoration/canvas.h"
#include "game/finish/glaze.h"

namespace onggi::look {

class DressedMarks {
  public:
    // Converts the whole texture.
    void dress(const decoration::Texture& texture, const decoration::Wall& wall,
               const finish::MarkPalette& palette);
    // Converts the changed part, in the same colours.
    void dress_changed(const decoration::Texture& texture, const decoration::Wall& wall,
                       const finish::MarkPalette& palette, const decoration::TextureRect& changed);

    [[nodiscard]] const render::LatheMarks& marks() const { return marks_; }

  private:
    render::LatheMarks marks_;
};

// A lathe material close to that glaze: one colour, and the glass over it. body: the material of its clay.
[[nodiscard]] render::LatheMaterial glazed_lathe(const render::LatheMaterial& body,
                                                 const finish::GlazeMaterial& glaze);

}  // namespace onggi::look
