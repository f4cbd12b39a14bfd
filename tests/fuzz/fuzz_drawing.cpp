// Any bytes are refused or are a decoration, which is written back to the byte, and fits a wall or is refused
// by it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "game/decoration/canvas.h"
#include "tests/fuzz/fuzz_expect.h"

namespace {

using namespace onggi;  // NOLINT: one small program

// A texture is large: more strokes would take long and add nothing.
constexpr std::size_t kStrokesLaid = 2;

bool is_refusal(const Error& error) {
    return error.kind == ErrorKind::kBadInput && error.message.find('\n') == std::string::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    auto drawn = decoration::recorded_from(bytes, "fuzz");
    if (!drawn) {
        fuzz::expect(is_refusal(drawn.error()));
        return 0;
    }
    const std::vector<std::byte> written = decoration::bytes_of(*drawn);
    fuzz::expect(std::equal(written.begin(), written.end(), bytes.begin(), bytes.end()));
    drawn->strokes.resize(std::min(drawn->strokes.size(), kStrokesLaid));
    static const decoration::Wall kWall =
        decoration::wall_of(std::vector<vec2>{{40, 0}, {60, 70}, {50, 140}});
    const auto canvas = decoration::Canvas::of(kWall, drawn->strokes);
    fuzz::expect(canvas ? canvas->strokes() == drawn->strokes : is_refusal(canvas.error()));
    return 0;
}
