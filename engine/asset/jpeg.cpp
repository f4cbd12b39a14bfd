// See image.h. The only file that includes libjpeg-turbo. Any thread.
#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>

#include "engine/asset/image.h"

namespace onggi::asset {
namespace {

// Uses the TurboJPEG interface: libjpeg's reports errors by longjmp, which skips destructors.
struct DestroyDecoder {
    void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, DestroyDecoder>;
using Encoder = Decoder;

}  // namespace

Result<std::vector<std::byte>> encode_jpeg(const Image& image, int quality) {
    if (!is_whole(image) || quality < 1 || quality > 100) {
        return bad_input(fmt::format(
            "JPEG: expected sides of 1 to {} pixels and a quality of 1 to 100, found {} x {} and {}",
            kMaxImageSide, image.width, image.height, quality));
    }
    const Encoder encoder(tjInitCompress());
    if (!encoder) return failed("JPEG: libjpeg-turbo could not be started");
    unsigned char* data = nullptr;
    unsigned long size = 0;  // NOLINT: the library's type
    constexpr int kTightRows = 0;
    const int done =
        tjCompress2(encoder.get(), image.rgba.data(), image.width, kTightRows, image.height, TJPF_RGBX, &data,
                    &size, TJSAMP_444, quality, TJFLAG_ACCURATEDCT | TJFLAG_PROGRESSIVE);
    std::vector<std::byte> bytes;
    if (done == 0) {
        const auto* first = reinterpret_cast<const std::byte*>(data);
        bytes.assign(first, first + size);
    }
    tjFree(data);
    if (done != 0) return failed(fmt::format("JPEG: {}", tjGetErrorStr2(encoder.get())));
    return bytes;
}

Result<Image> decode_jpeg(std::span<const std::byte> bytes, std::string_view name) {
    const Decoder decoder(tjInitDecompress());
    if (!decoder) return failed(fmt::format("{}: libjpeg-turbo could not be started", name));
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const auto size = static_cast<unsigned long>(bytes.size());  // NOLINT: the library's type
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colours = 0;
    if (bytes.empty() ||
        tjDecompressHeader3(decoder.get(), data, size, &width, &height, &subsampling, &colours) != 0) {
        return bad_input(fmt::format("{}: expected a JPEG, found {} bytes of something else", name, size));
    }
    if (width > kMaxImageSide || height > kMaxImageSide) {
        return bad_input(fmt::format("{}: expected a JPEG with sides of at most {} pixels, found {} x {}",
                                     name, kMaxImageSide, width, height));
    }
    Image image{.width = width, .height = height, .rgba = {}};
    image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    // A progressive file may have any number of scans, each of which takes time; the library refuses more
    // than 500.
    constexpr int kFlags = TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING;
    constexpr int kTightRows = 0;
    if (tjDecompress2(decoder.get(), data, size, image.rgba.data(), width, kTightRows, height, TJPF_RGBA,
                      kFlags) != 0) {
        return bad_input(fmt::format("{}: expected a whole JPEG, found a damaged one: {}", name,
                                     tjGetErrorStr2(decoder.get())));
    }
    return image;
}

}  // namespace onggi::asset
