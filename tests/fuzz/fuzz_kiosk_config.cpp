// Any bytes are refused in one line with the location, or are a kiosk's settings within every bound of
// config.h.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "game/kiosk/config.h"
#include "game/kiosk/state.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto config = kiosk::read_config(text, "fuzz");
    if (!config) {
        fuzz::expect(config.error().kind == ErrorKind::kBadInput);
        fuzz::expect(config.error().message.starts_with("fuzz, line "));
        fuzz::expect(config.error().message.find('\n') == std::string::npos);
        return 0;
    }
    const auto within = [](double value, double least, double most) {
        fuzz::expect(value >= least && value <= most);
    };
    within(config->screen.diagonal_inch, 7.0, 120.0);
    within(config->screen.distance_mm, 200.0, 5000.0);
    within(config->visit.idle_s, 10.0, 600.0);
    within(config->visit.countdown_s, 20.0, 120.0);
    within(config->gallery.least_free_mb, 1.0, 1e6);
    within(config->sound.volume, 0, kiosk::kMostVolume);
    within(config->staff.closes_after_s, 10.0, 600.0);
    within(config->sharing.port, 1, 65535);
    within(config->sharing.hours, 0, 168);
    within(config->sharing.most_pots, 1, 10000);
    fuzz::expect(config->sharing.public_url.find_first_of("\"'<> \n") == std::string::npos);
    fuzz::expect(config->haptics.rate_hz == 0.0 || config->haptics.rate_hz >= 100.0);
    const auto& order = config->languages.order;
    fuzz::expect(!order.empty() && order.size() <= 8);
    fuzz::expect(std::find(order.begin(), order.end(), config->languages.first) != order.end());
    const kiosk::Rules rules = kiosk::rules_of(*config);
    fuzz::expect(rules.pin_digits == 0 || (rules.pin_digits >= 4 && rules.pin_digits <= 8));
    fuzz::expect(rules.pin >= 0 && rules.pin <= 99'999'999);
    for (int minute = 0; minute < 24 * 60; minute += 7)
        static_cast<void>(kiosk::is_open(*config, minute));
    return 0;
}
