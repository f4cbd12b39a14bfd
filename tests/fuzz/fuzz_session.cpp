// Any bytes are refused or are a session that can be played, also with corrected checksums.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "game/haptic/start_state.h"
#include "game/record/session.h"
#include "tests/fuzz/fuzz_expect.h"
#include "tests/support/session_checksums.h"

namespace {

using namespace onggi;  // NOLINT: one small program

constexpr std::uint64_t kTicksRead = 4000;
constexpr std::uint64_t kTicksReplayed = 100;
constexpr int kElementsReplayed = 2000;

void replay(const record::Session& session) {
    auto start = haptic::start_from_bytes(session.start_state(), session.header().rate_hz);
    if (!start || start->state.element_count() > kElementsReplayed) return;
    record::SessionCursor cursor(session);
    const std::uint64_t ticks = std::min(session.tick_count(), kTicksReplayed);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        haptic::tick(start->state, cursor.at(tick), start->parameters);
    }
}

void read(std::string bytes, record::Damage damage) {
    const auto session = record::parse_session(std::move(bytes), "fuzz", damage);
    if (!session) {
        fuzz::expect(session.error().kind == ErrorKind::kBadInput);
        fuzz::expect(session.error().message.find('\n') == std::string::npos);
        return;
    }
    fuzz::expect(session->usable_bytes() <= session->file_bytes());
    record::SessionCursor cursor(*session);
    const std::uint64_t ticks = std::min(session->tick_count(), kTicksRead);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        const tool::ToolState tool = cursor.at(tick);
        fuzz::expect(tool::within_limits(tool, {}) == tool);
        static_cast<void>(session->has_force_at(tick, dvec3(0.0)));
    }
    // Backwards too, from the end.
    for (std::uint64_t back = 1; back <= std::min<std::uint64_t>(ticks, 64); ++back) {
        static_cast<void>(cursor.at(session->tick_count() - back));
    }
    replay(*session);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    read(bytes, record::Damage::kCutThere);
    read(bytes, record::Damage::kRefuse);
    test::mend_session(bytes);
    read(std::move(bytes), record::Damage::kRefuse);
    return 0;
}
