// Any bytes are refused or are a JPEG with as many bytes as its size requires.
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/asset/image.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const auto image = asset::decode_jpeg(std::as_bytes(std::span(data, size)), "fuzz");
    if (!image) {
        fuzz::expect(image.error().kind == ErrorKind::kBadInput);
        fuzz::expect(image.error().message.find('\n') == std::string::npos);
        return 0;
    }
    fuzz::expect(image->width >= 1 && image->width <= asset::kMaxImageSide);
    fuzz::expect(image->height >= 1 && image->height <= asset::kMaxImageSide);
    fuzz::expect(image->rgba.size() ==
                 static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) * 4);
    return 0;
}
