// See image.h. The only file that includes libpng. Any thread.
#include <fmt/format.h>
#include <png.h>

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

}  // namespace onggi::asset
