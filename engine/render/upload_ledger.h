// Tracks which pictures of an overlay are in its texture and which have still to be uploaded: a frame that
// was skipped uploaded none, and a re-created device has an empty texture. Pure; main thread.
#pragma once

#include <span>
#include <vector>

#include "engine/ui/atlas.h"

namespace onggi::render {

// Whether the two rectangles overlap.
[[nodiscard]] bool overlap(const ui::Atlas::Upload& a, const ui::Atlas::Upload& b);

class UploadLedger {
  public:
    using Upload = ui::Atlas::Upload;

    // Adds the uploads of a frame, which replace overlapping ones. If the texture's side has changed, all
    // older uploads are dropped.
    void bring(std::span<const Upload> uploads, int side_px);
    // Uploads for the next frame, in this order.
    [[nodiscard]] std::span<const Upload> wanted() const { return wanted_; }
    // The frame was drawn: its uploads are in the texture.
    void done();
    // The texture is lost: everything in it must be uploaded again.
    void lost();

  private:
    std::vector<Upload> wanted_;
    std::vector<Upload> there_;
    int side_px_ = 0;
};

}  // namespace onggi::render
