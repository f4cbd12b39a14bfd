#include "engine/render/upload_ledger.h"

namespace onggi::render {

bool overlap(const ui::Atlas::Upload& a, const ui::Atlas::Upload& b) {
    return a.x < b.x + b.painting->width && b.x < a.x + a.painting->width && a.y < b.y + b.painting->height &&
           b.y < a.y + a.painting->height;
}

void UploadLedger::bring(std::span<const Upload> uploads, int side_px) {
    if (side_px != side_px_) {
        wanted_.clear();
        there_.clear();
        side_px_ = side_px;
    }
    for (const Upload& upload : uploads) {
        const auto is_covered = [&](const Upload& older) { return overlap(older, upload); };
        std::erase_if(there_, is_covered);
        std::erase_if(wanted_, is_covered);
        wanted_.push_back(upload);
    }
}

void UploadLedger::done() {
    there_.insert(there_.end(), std::make_move_iterator(wanted_.begin()),
                  std::make_move_iterator(wanted_.end()));
    wanted_.clear();
}

void UploadLedger::lost() {
    // Uploads in the texture never overlap pending ones, so their order does not matter.
    wanted_.insert(wanted_.end(), std::make_move_iterator(there_.begin()),
                   std::make_move_iterator(there_.end()));
    there_.clear();
}

}  // namespace onggi::render
