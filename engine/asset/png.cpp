// See image.h. The only file that includes libpng. Any thread.
#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "engine/asset/image.h"

namespace onggi::asset {
namespace {

// Frees libpng's allocations on every return. Uses the simplified interface because the other one reports
// errors by longjmp, which skips destructors.
class PngImage {
  public:
    PngImage() { image_.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image_); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image* get() { return &image_; }
    png_image* operator->() { return &image_; }
    [[nodiscard]] std::string message() const { return static_cast<const char*>(image_.message); }

  private:
    png_image image_{};
};

std::size_t byte_count(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * std::size_t{kBytesPerPixel};
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image& image) {
    if (image.width < 1 || image.width > kMaxImageSide || image.height < 1 || image.height > kMaxImageSide) {
        return bad_input(fmt::format("PNG: expected sides of 1 to {} pixels, found {} x {}", kMaxImageSide,
                                     image.width, image.height));
    }
    if (image.rgba.size() != byte_count(image.width, image.height)) {
        return bad_input(fmt::format("PNG: expected {} bytes for {} x {} pixels, found {}",
                                     byte_count(image.width, image.height), image.width, image.height,
                                     image.rgba.size()));
    }
    PngImage png;
    png->width = static_cast<png_uint_32>(image.width);
    png->height = static_cast<png_uint_32>(image.height);
    png->format = PNG_FORMAT_RGBA;

    constexpr int kKeepEightBits = 0;
    constexpr png_int_32 kTightRows = 0;
    // The first call only computes the size, by compressing once; pictures are few and small.
    png_alloc_size_t size = 0;
    if (png_image_write_to_memory(png.get(), nullptr, &size, kKeepEightBits, image.rgba.data(), kTightRows,
                                  nullptr) == 0) {
        return failed(fmt::format("PNG: could not be compressed: {}", png.message()));
    }
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(png.get(), bytes.data(), &size, kKeepEightBits, image.rgba.data(),
                                  kTightRows, nullptr) == 0) {
        return failed(fmt::format("PNG: could not be written: {}", png.message()));
    }
    bytes.resize(size);
    return bytes;
}

Result<Image> decode_png(std::span<const std::byte> bytes, std::string_view name) {
    PngImage png;
    if (png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size()) == 0) {
        return bad_input(fmt::format("{}: expected a PNG, found {} bytes of something else: {}", name,
                                     bytes.size(), png.message()));
    }
    constexpr auto kMaxSide = static_cast<png_uint_32>(kMaxImageSide);
    if (png->width > kMaxSide || png->height > kMaxSide) {
        return bad_input(fmt::format("{}: expected a PNG with sides of at most {} pixels, found {} x {}",
                                     name, kMaxImageSide, png->width, png->height));
    }
    png->format = PNG_FORMAT_RGBA;
    Image image;
    image.width = static_cast<int>(png->width);
    image.height = static_cast<int>(png->height);
    image.rgba.resize(byte_count(image.width, image.height));
    constexpr png_int_32 kTightRows = 0;
    if (png_image_finish_read(png.get(), nullptr, image.rgba.data(), kTightRows, nullptr) == 0) {
        return bad_input(
            fmt::format("{}: expected a whole PNG, found a damaged one: {}", name, png.message()));
    }
    return image;
}

// The simplified interface writes no text, so this adds the chunk (ISO/IEC 15948, 11.3.4.5) behind the
// header.
Result<std::vector<std::byte>> png_with_xmp(std::span<const std::byte> png, std::string_view xmp) {
    constexpr std::size_t kHeaderEnd = 8 + 25;  // signature, IHDR
    if (png.size() < kHeaderEnd || png_sig_cmp(reinterpret_cast<png_const_bytep>(png.data()), 0, 8) != 0)
        return bad_input(
            fmt::format("PNG: expected a whole file, found {} bytes of something else", png.size()));
    // Keyword, no compression, no language, no translated keyword.
    constexpr std::string_view kType = "iTXt";
    constexpr std::string_view kKeyword("XML:com.adobe.xmp\0\0\0\0\0", 22);
    std::string chunk;
    const auto add_number = [&](std::uint32_t number) {
        for (int shift = 24; shift >= 0; shift -= 8)
            chunk += static_cast<char>(static_cast<unsigned char>(number >> static_cast<unsigned>(shift)));
    };
    add_number(static_cast<std::uint32_t>(kKeyword.size() + xmp.size()));
    chunk.append(kType).append(kKeyword).append(xmp);
    const auto* const counted = reinterpret_cast<const Bytef*>(chunk.data() + 4);
    add_number(static_cast<std::uint32_t>(crc32_z(0, counted, chunk.size() - 4)));
    std::vector<std::byte> file(png.size() + chunk.size());
    const auto rest = std::copy_n(png.begin(), kHeaderEnd, file.begin());
    std::memcpy(&*rest, chunk.data(), chunk.size());
    std::copy(png.begin() + kHeaderEnd, png.end(), rest + static_cast<std::ptrdiff_t>(chunk.size()));
    return file;
}

}  // namespace onggi::asset
