#include "engine/render/pixels/overlay_pictures.h"

#include "engine/render/upload_ledger.h"

namespace onggi::render {
namespace {

std::uint64_t key_of(int x, int y) {
    return std::uint64_t{static_cast<std::uint32_t>(y)} << 32U | static_cast<std::uint32_t>(x);
}

}  // namespace

void OverlayPictures::take(std::span<const ui::Atlas::Upload> uploads, int side_px) {
    if (side_px != side_px_) pictures_.clear();
    side_px_ = side_px;
    for (const ui::Atlas::Upload& upload : uploads) {
        std::erase_if(pictures_, [&](const auto& older) { return overlap(older.second.placed, upload); });
        pictures_[key_of(upload.x, upload.y)] = {upload, ++last_number_};
    }
}

const OverlayPictures::Picture* OverlayPictures::at(vec2 corner_px) const {
    const glm::ivec2 corner(corner_px);
    const auto found = pictures_.find(key_of(corner.x, corner.y));
    return found == pictures_.end() ? nullptr : &found->second;
}

}  // namespace onggi::render
