// Any text is refused with the offending letter, or is a path that begins with a move and has finite points.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/ui/path.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const auto steps = ui::read_path({reinterpret_cast<const char*>(data), size});
    if (!steps) {
        fuzz::expect(steps.error().kind == ErrorKind::kBadInput);
        fuzz::expect(steps.error().message.starts_with("path, letter "));
        fuzz::expect(steps.error().message.find('\n') == std::string::npos);
        return 0;
    }
    fuzz::expect(steps->empty() || steps->front().kind == ui::PathStep::Kind::kMove);
    for (const ui::PathStep& step : *steps) {
        for (const vec2& place : {step.to, step.first_control, step.second_control})
            fuzz::expect(std::isfinite(place.x) && std::isfinite(place.y));
    }
    return 0;
}
