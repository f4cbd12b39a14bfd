// A film as animated WebP (RFC 9649), picture by picture. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"

namespace onggi::asset {

struct WebpFilmDesc {
    int width = 480;  // pixels, of every picture
    int height = 360;
    // 0 to 100, as in libwebp's own programs; 100 is lossless, at ten times the size. Below, pictures that
    // differ by a few levels are one (findings/libwebp-drops-the-steps-of-a-slow-fade.sh), and it lasts as
    // long as they.
    double quality = 75.0;
};

// Encodes pictures in order. It stores only the encoded data and the last picture, because each is encoded as
// the difference from the previous one. The same pictures give the same bytes.
class WebpFilm {
  public:
    // kBadInput: a side outside 1..kMaxImageSide, a quality outside 0..100. kFailed: no memory.
    [[nodiscard]] static Result<WebpFilm> create(const WebpFilmDesc& desc);
    WebpFilm(WebpFilm&&) noexcept;
    WebpFilm& operator=(WebpFilm&&) noexcept;
    WebpFilm(const WebpFilm&) = delete;
    WebpFilm& operator=(const WebpFilm&) = delete;
    ~WebpFilm();

    // Adds a picture, shown for shown_ms. kBadInput: a picture of another size, a time outside 1..60000.
    Result<void> add(const Image& image, int shown_ms);
    // Returns the whole file; a viewer plays it once and stops at the last picture. Nothing can be added
    // afterwards. kBadInput: no picture was added.
    Result<std::vector<std::byte>> finish();

  private:
    struct Encoder;
    explicit WebpFilm(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace onggi::asset
