// Any bytes are refused or are a gesture that keeps every promise of gesture.h.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "game/tool/gesture.h"
#include "game/tool/tool.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto gesture = tool::parse_gesture(text, "fuzz");
    if (!gesture) {
        fuzz::expect(gesture.error().kind == ErrorKind::kBadInput);
        fuzz::expect(gesture.error().message.find('\n') == std::string::npos);
        return 0;
    }
    fuzz::expect(static_cast<bool>(tool::check_gesture_start(text, "fuzz")));
    const auto rows = gesture->rows();
    fuzz::expect(!rows.empty() && rows[0].t_s == 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        fuzz::expect(i == 0 || rows[i].t_s > rows[i - 1].t_s);
        fuzz::expect(tool::within_limits(rows[i].tool, {}) == rows[i].tool);
        fuzz::expect(gesture->at(rows[i].t_s) == rows[i].tool);
    }
    fuzz::expect(gesture->duration_s() <= tool::kMaxGestureSeconds);
    const std::uint64_t ticks = gesture->tick_count(1000.0);
    fuzz::expect(ticks >= 1 && ticks <= 3600001);
    for (std::uint64_t i = 0; i <= 16; ++i) {
        const tool::ToolState tool = gesture->at_tick((ticks - 1) * i / 16, 1000.0);
        // Interpolated between two points of the workspace, within rounding.
        for (const double mm : {tool.position_mm.x, tool.position_mm.y, tool.position_mm.z}) {
            fuzz::expect(std::fabs(mm) <= haptics::kWorkspaceMm * (1.0 + 1e-12));
        }
    }
    return 0;
}
