// Any bytes as messages of a haptic service: the session continues or refuses, the tool's position stays
// finite and the answer stays one line. Each message is two bytes of length and its bytes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/haptics/haply/inverse_messages.h"
#include "engine/haptics/haply/inverse_session.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;                  // NOLINT: one program
    using namespace onggi::haptics::haply;  // NOLINT

    InverseLink link;
    InverseSession session(link, {});
    session.opened();
    std::string_view bytes(reinterpret_cast<const char*>(data), size);  // NOLINT: a view of bytes as letters
    std::int64_t now_ns = 0;
    std::uint64_t ticks = 0;
    while (bytes.size() >= 2) {
        const std::size_t wanted =
            static_cast<unsigned char>(bytes[0]) + 256U * static_cast<unsigned char>(bytes[1]);
        const std::string_view message = bytes.substr(2, wanted);
        bytes.remove_prefix(2 + message.size());
        now_ns += haptics::hid::kMs;
        if (!session.take(message, now_ns)) {
            session.closed("refused");
            session.opened();
        }
        const dvec3 place = link.input.latest().place_mm;
        fuzz::expect(std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z));
        link.order.put({.force_n = {0.1, 0.0, 0.0}, .ticks = ++ticks});
        const std::string said = session.next_message(now_ns);
        fuzz::expect(said.find('\n') == std::string::npos && said.size() < 400);
        fuzz::expect(said.empty() ||
                     static_cast<bool>(walk_json(said, [](std::string_view, const JsonValue&) {})));
    }
    return 0;
}
