// A picture in memory; PNG, the form in which pictures leave and enter; and JPEG. Any
// thread; touches no file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::asset {

// Of a pixel: red, green, blue (sRGB-encoded), alpha (straight).
constexpr int kBytesPerPixel = 4;

// width x height pixels, rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    friend bool operator==(const Image&, const Image&) = default;
};

// The largest side that is written or read: a PNG's header may claim 2^31 in a few bytes, and nothing is
// allocated for such a claim.
constexpr int kMaxImageSide = 8192;

// 8-bit RGBA PNG (ISO/IEC 15948). The same picture gives the same bytes: no time or text is stored.
// kBadInput if a side is outside 1..kMaxImageSide or rgba does not hold width x height x 4 bytes.
Result<std::vector<std::byte>> encode_png(const Image& image);

// Any PNG, turned into 8-bit RGBA. `name` is what the message calls the file. kBadInput if the bytes are not
// a PNG, are cut short, fail a checksum, or claim a side above kMaxImageSide.
Result<Image> decode_png(std::span<const std::byte> bytes, std::string_view name);

// JPEG (ITU-T T.81) of what is seen of the picture, without its alpha: the values as they are, with colour as
// fine as light. quality 1 to 100. The same picture gives the same bytes. kBadInput as encode_png().
Result<std::vector<std::byte>> encode_jpeg(const Image& image, int quality);

// WebP (RFC 9649) with its alpha, quality 1 to 100: a tenth of the PNG's bytes. The same picture gives the
// same bytes. kBadInput as encode_png().
Result<std::vector<std::byte>> encode_webp(const Image& image, int quality);

// Any JPEG (ITU-T T.81) of grey or coloured light, turned into 8-bit RGBA with alpha 255; the values stay as
// the file has them. kBadInput if the bytes are not a JPEG, are cut short or damaged, want more passes than
// an honest file, or claim a side above kMaxImageSide.
Result<Image> decode_jpeg(std::span<const std::byte> bytes, std::string_view name);

// What every encoder asks of a picture: its sides are within 1..kMaxImageSide, and rgba holds them.
[[nodiscard]] inline bool is_whole(const Image& image) {
    return image.width >= 1 && image.width <= kMaxImageSide && image.height >= 1 &&
           image.height <= kMaxImageSide &&
           image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                    static_cast<std::size_t>(image.height);
}

}  // namespace onggi::asset
