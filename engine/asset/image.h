// A picture in memory, and its PNG, JPEG and WebP encodings. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::asset {

// A pixel: red, green, blue (sRGB-encoded), alpha (straight).
constexpr int kBytesPerPixel = 4;

// width x height pixels, rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    friend bool operator==(const Image&, const Image&) = default;
};

// The largest side for reading and writing. A PNG's header may claim 2^31 in a few bytes; such a file is
// refused before any allocation.
constexpr int kMaxImageSide = 8192;

// 8-bit RGBA PNG (ISO/IEC 15948). The same picture gives the same bytes: no time or text is stored.
// kBadInput if a side is outside 1..kMaxImageSide or rgba does not hold width x height x 4 bytes.
Result<std::vector<std::byte>> encode_png(const Image& image);

// Decodes any PNG to 8-bit RGBA. Errors call the file `name`. kBadInput if the bytes are not a PNG, are
// truncated, fail a checksum, or claim a side above kMaxImageSide.
Result<Image> decode_png(std::span<const std::byte> bytes, std::string_view name);

// Progressive JPEG (ITU-T T.81) of the picture's colours, ignoring alpha, without chroma subsampling. An even
// picture takes half the bytes of a baseline JPEG. quality 1 to 100.
// The same picture gives the same bytes. kBadInput as encode_png().
Result<std::vector<std::byte>> encode_jpeg(const Image& image, int quality);

// WebP (RFC 9649) with alpha, quality 1 to 100: a tenth of the PNG's size. The same picture gives the same
// bytes. kBadInput as encode_png().
Result<std::vector<std::byte>> encode_webp(const Image& image, int quality);

// The file with an XMP packet (ISO 16684-3); its pixels are unchanged. Precondition: it has no packet yet.
// kBadInput: not a PNG, or not a WebP, which may be animated.
Result<std::vector<std::byte>> png_with_xmp(std::span<const std::byte> png, std::string_view xmp);
Result<std::vector<std::byte>> webp_with_xmp(std::span<const std::byte> webp, std::string_view xmp);

// Decodes any grey or colour JPEG (ITU-T T.81) to 8-bit RGBA with alpha 255, without colour conversion.
// kBadInput if the bytes are not a JPEG, are truncated or damaged, have too many scans, or claim a side above
// kMaxImageSide.
Result<Image> decode_jpeg(std::span<const std::byte> bytes, std::string_view name);

// The precondition of every encoder: sides within 1..kMaxImageSide, and rgba of that size.
[[nodiscard]] inline bool is_whole(const Image& image) {
    return image.width >= 1 && image.width <= kMaxImageSide && image.height >= 1 &&
           image.height <= kMaxImageSide &&
           image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                    static_cast<std::size_t>(image.height);
}

}  // namespace onggi::asset
