// Still WebP pictures, by libwebp. Any thread.
#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>

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

Result<std::vector<std::byte>> webp_with_xmp(std::span<const std::byte> webp, std::string_view xmp) {
    constexpr int kKeepNoCopy = 0;
    const WebPData given{reinterpret_cast<const std::uint8_t*>(webp.data()), webp.size()};
    const std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)> file(WebPMuxCreate(&given, kKeepNoCopy),
                                                                  &WebPMuxDelete);
    if (!file)
        return bad_input(
            fmt::format("WebP: expected a whole file, found {} bytes of something else", webp.size()));
    const WebPData packet{reinterpret_cast<const std::uint8_t*>(xmp.data()), xmp.size()};
    WebPData out;
    WebPDataInit(&out);
    if (WebPMuxSetChunk(file.get(), "XMP ", &packet, kKeepNoCopy) != WEBP_MUX_OK ||
        WebPMuxAssemble(file.get(), &out) != WEBP_MUX_OK)
        return failed("WebP: no memory for what the file says about itself");
    const auto* const first = reinterpret_cast<const std::byte*>(out.bytes);
    std::vector<std::byte> bytes(first, first + out.size);
    WebPDataClear(&out);
    return bytes;
}

}  // namespace onggi::asset
