// Any bytes are refused or are a start state that is written back to the byte and can be ticked.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "game/haptic/start_state.h"
#include "game/tool/tool.h"
#include "tests/fuzz/fuzz_expect.h"

namespace {

using namespace onggi;  // NOLINT: one small program

void expect_refused_in_one_line(const Error& error) {
    fuzz::expect(error.kind == ErrorKind::kBadInput);
    fuzz::expect(error.message.find('\n') == std::string::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));

    const auto clay = clay::PaperClay::from_start_state(bytes);
    if (clay) {
        fuzz::expect(std::ranges::equal(clay->start_state(), bytes));
    } else {
        expect_refused_in_one_line(clay.error());
    }

    const auto studio = clay::StudioClay::from_start_state(bytes);
    if (studio) {
        fuzz::expect(std::ranges::equal(studio->start_state(), bytes));
    } else {
        expect_refused_in_one_line(studio.error());
    }

    auto start = haptic::start_from_bytes(bytes, 1000.0);
    if (!start) {
        expect_refused_in_one_line(start.error());
        return 0;
    }
    fuzz::expect(std::ranges::equal(haptic::start_state_bytes(start->state, start->parameters), bytes));
    for (int tick = 0; tick < 20; ++tick) {
        const double x_mm = 80.0 - tick;
        tool::ToolState tool{
            .position_mm = {x_mm, 5.0 * tick, 1.0}, .radius_mm = 10.0, .wheel_button = tick % 4 != 0};
        // Used by the studio's clay only.
        tool.tool = static_cast<tool::Tool>(tick % 4);
        tool.assist_gap_mm = tick % 3 == 0 ? 5.0 : 0.0;
        tool.water = 0.5;
        tool.guided = tick >= 8;
        tool.pressing = tick % 6 != 5;
        tool.wire = tick == 15 ? tool::Wire::kCutRim : tool::Wire::kNone;
        tool.wire_height_mm = 10.0;
        const auto result = haptic::tick(start->state, tool, start->parameters);
        const dvec3 force_n = result.forces.total_n();
        fuzz::expect(std::isfinite(force_n.x) && std::isfinite(force_n.y) && std::isfinite(force_n.z));
    }
    return 0;
}
