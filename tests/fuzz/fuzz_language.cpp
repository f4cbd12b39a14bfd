// Any bytes are refused in one line with the location, or are a language's table with a text for every key.
// The first byte selects whether English is the reference.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "game/kiosk/strings.h"
#include "tests/fuzz/fuzz_expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace onggi;  // NOLINT: the one function here
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    const kiosk::Language& english = kiosk::built_in_languages().front();
    const kiosk::Language* pattern = data[0] % 2 == 0 ? nullptr : &english;
    const auto language = kiosk::Language::read(text, "xx", "fuzz", pattern);
    if (!language) {
        fuzz::expect(language.error().kind == ErrorKind::kBadInput);
        fuzz::expect(language.error().message.starts_with("fuzz:"));
        fuzz::expect(language.error().message.find('\n') == std::string::npos);
        return 0;
    }
    for (const auto& [key, words] : language->words()) {
        fuzz::expect(!key.empty() && !words.shown.empty() && !words.spoken.empty());
        fuzz::expect(language->shown(key) == words.shown && language->spoken(key) == words.spoken);
        fuzz::expect(language->shown(key, "7").find("{n}") == std::string::npos);
        fuzz::expect(pattern == nullptr || pattern->has(key));
    }
    fuzz::expect(pattern == nullptr ||
                 language->missing_keys().size() + language->words().size() == pattern->words().size());
    fuzz::expect(language->shown("no such key") == "no such key");
    return 0;
}
