// Still WebP pictures, by libwebp. Any thread.
#include <fmt/format.h>
#include <webp/encode.h>

#include "engine/asset/image.h"

namespace onggi::asset {

Result<std::vector<std::byte>> encode_webp(const Image& image, int quality) {
    if (!is_whole(image) || quality < 1 || quality > 100) {
        return bad_input(fmt::format(
            "WebP: expected sides of 1 to {} pixels and a quality of 1 to 100, found {} x {} and {}",
            kMaxImageSide, image.width, image.height, quality));
    }
    std::uint8_t* data = nullptr;
    const std::size_t size = WebPEncodeRGBA(image.rgba.data(), image.width, image.height,
                                            kBytesPerPixel * image.width, static_cast<float>(quality), &data);
    if (size == 0) return failed("WebP: libwebp could not encode the picture");
    const auto* const first = reinterpret_cast<const std::byte*>(data);
    std::vector<std::byte> bytes(first, first + size);
    WebPFree(data);
    return bytes;
}

}  // namespace onggi::asset
