// Any bytes are refused in one line or are a spoken line that can be played.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/sound/spoken_line.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto line = sound::read_wave(bytes, "line.wav");
    if (!line) {
        fuzz::expect(line.error().kind == ErrorKind::kBadInput);
        fuzz::expect(line.error().message.find('\n') == std::string::npos);
        return 0;
    }
    constexpr double kMostS = 121.0;
    fuzz::expect(static_cast<double>(line->samples.size()) <= kMostS * sound::kSampleRateHz);
    for (const float sample : line->samples)
        fuzz::expect(sample >= -1.0F && sample <= 1.0F);
    return 0;
}
