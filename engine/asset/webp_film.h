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
    // 0 to 100, as libwebp's own programs count it; 100 loses nothing, at ten times the bytes.
    double quality = 75.0;
};

// Takes pictures in their order and keeps only what they were packed into, and the last of them, because each
// is stored as its difference to the one before. The same pictures give the same bytes.
class WebpFilm {
  public:
    // kBadInput: a side outside 1..kMaxImageSide, a quality outside 0..100. kFailed: no memory.
    [[nodiscard]] static Result<WebpFilm> create(const WebpFilmDesc& desc);
    WebpFilm(WebpFilm&&) noexcept;
    WebpFilm& operator=(WebpFilm&&) noexcept;
    WebpFilm(const WebpFilm&) = delete;
    WebpFilm& operator=(const WebpFilm&) = delete;
    ~WebpFilm();

    // Shown for that long, ms. kBadInput: a picture of another size, a time outside 1..60000.
    Result<void> add(const Image& image, int shown_ms);
    // The whole file, which a viewer plays once and then shows the last picture of; nothing can be added
    // after it. kBadInput: no picture was added.
    Result<std::vector<std::byte>> finish();

  private:
    struct Encoder;
    explicit WebpFilm(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace onggi::asset
