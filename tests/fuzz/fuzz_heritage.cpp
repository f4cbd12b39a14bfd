// Any two texts, separated by a zero byte, are refused or are a table of targets with outlines that keeps
// every promise of target.h.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "game/heritage/score.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::size_t end = std::min(text.find('\0'), size);
    const std::string_view outlines = end < size ? text.substr(end + 1) : std::string_view();
    const auto targets = heritage::parse_targets(text.substr(0, end), outlines, "fuzz", "outlines");
    if (!targets) {
        fuzz::expect(targets.error().kind == ErrorKind::kBadInput);
        fuzz::expect(targets.error().message.find('\n') == std::string::npos);
        return 0;
    }
    fuzz::expect(!targets->empty());
    for (const heritage::Target& target : *targets) {
        fuzz::expect(std::fabs(target.radius_at(target.height_mm) - target.outline.back().radius_mm) < 1e-6);
        const double widest = 0.5 * target.drawn_diameter_mm();
        for (int i = 0; i <= 64; ++i) {
            const double radius = target.radius_at(target.height_mm * i / 64.0);
            fuzz::expect(radius > 0.0 && radius <= widest * (1.0 + 1e-9));
        }
        const heritage::PotForm form = heritage::form_of(target);
        const heritage::Score score = heritage::score(form, target, clay::ClayBody::kStoneware);
        fuzz::expect(std::isfinite(score.profile_rms_mm) && std::isfinite(score.mean_off_mm));
        fuzz::expect(heritage::unlikeness(form, form) < 1e-6);
        fuzz::expect(heritage::sentence(target).find('\n') == std::string::npos);
    }
    return 0;
}
