// Which pictures of an overlay lie in its texture and which have still to go there: a frame that was not
// drawn took none of its pictures along, and a device that is made anew has none at all. Pure; main thread.
#pragma once

#include <span>
#include <vector>

#include "engine/ui/atlas.h"

namespace onggi::render {

// Whether one lies over part of the other.
[[nodiscard]] bool overlap(const ui::Atlas::Upload& a, const ui::Atlas::Upload& b);

class UploadLedger {
  public:
    using Upload = ui::Atlas::Upload;

    // A frame brings these, over whatever lay in their places in a texture of this size; of one of another
    // size nothing is left.
    void bring(std::span<const Upload> uploads, int side_px);
    // What the next frame has to copy, in this order.
    [[nodiscard]] std::span<const Upload> wanted() const { return wanted_; }
    // The frame was drawn.
    void done();
    // The texture is gone: all that lay in it is wanted again.
    void lost();

  private:
    std::vector<Upload> wanted_;
    std::vector<Upload> there_;
    int side_px_ = 0;
};

}  // namespace onggi::render
