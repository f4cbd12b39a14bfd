// A picture in libwebp's memory (inside this room only).
#pragma once

#include <webp/encode.h>

#include "engine/asset/image.h"

namespace onggi::asset {

class WebpPicture {
  public:
    enum class Colours { kArgb, kYuv420 };  // kYuv420: of BT.601, luma 16 to 235, as H.264 takes it, too

    WebpPicture() { ready_ = WebPPictureInit(&picture_) != 0; }
    ~WebpPicture() { WebPPictureFree(&picture_); }
    WebpPicture(const WebpPicture&) = delete;
    WebpPicture& operator=(const WebpPicture&) = delete;

    // Ignores alpha. False: no memory.
    bool take(const Image& image, Colours colours) {
        if (!ready_) return false;
        picture_.use_argb = colours == Colours::kArgb ? 1 : 0;
        picture_.width = image.width;
        picture_.height = image.height;
        return WebPPictureImportRGBX(&picture_, image.rgba.data(), kBytesPerPixel * image.width) != 0;
    }
    WebPPicture* get() { return &picture_; }

  private:
    WebPPicture picture_{};
    bool ready_ = false;
};

}  // namespace onggi::asset
