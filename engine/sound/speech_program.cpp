#include "engine/sound/speech_program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "engine/core/language_tag.h"
#include "engine/jobs/child_process.h"
#include "engine/jobs/clock.h"

namespace onggi::sound {
namespace {

constexpr double kMostS = 5.0;
constexpr int kWaitMs = 10;
constexpr std::int64_t kEndsWithinNs = 1'000'000;  // of the process, after its output
constexpr std::size_t kMostTextBytes = 2000;
constexpr std::size_t kMostWaveBytes = std::size_t{8} << 20U;  // more than two minutes at 22 kHz, 16 bits

// Cuts at a whole character.
std::string one_paragraph(std::string text) {
    if (text.size() > kMostTextBytes) {
        std::size_t end = kMostTextBytes;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
            --end;
        text.resize(end);
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

// espeak-ng 1.51 reads Chinese by its voice "cmn", and by "zh", as English spellings with numbers for the
// tones ("chew five, more five"); with this one it speaks Mandarin
// (findings/espeak-ng-reads-chinese-as-pinyin-spelt-in-english.sh).
std::string voice_of(const std::string& language) {
    const std::string_view primary = primary_language(language);
    return std::string(primary == "zh" ? "cmn-latn-pinyin" : primary);
}

}  // namespace

bool has_speech_program(const std::string& program) {
    if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
    const char* const path = std::getenv("PATH");
    for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::string file = fmt::format("{}/{}", rest.substr(0, end), program);
        if (::access(file.c_str(), X_OK) == 0) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

Result<SpokenLine> synthesise(const std::string& text, const SpeechStyle& style,
                              const std::function<bool()>& is_wanted, const std::string& program) {
    const auto fails = [&](const std::string& why) { return failed(fmt::format("{}: {}", program, why)); };
    auto process = jobs::ChildProcess::start(
        {program, "--stdin", "--stdout", "-b", "1", "-v", voice_of(style.language), "-s",
         std::to_string(style.words_per_min), "-a", std::to_string(style.volume_percent)},
        jobs::ChildProcess::Kind::kAnswers);
    if (!process) return process.error();
    process->tell(one_paragraph(text));
    std::string wave;
    const double until_s = jobs::MonotonicClock::now_s() + kMostS;
    for (bool goes_on = true; goes_on || process->is_at_work();) {
        if (!is_wanted()) return fails("no longer wanted");
        if (wave.size() > kMostWaveBytes) return fails("expected at most two minutes of speech, found more");
        if (jobs::MonotonicClock::now_s() > until_s)
            return fails(fmt::format("expected a line within {:.0f} s, found none", kMostS));
        if (goes_on) {
            goes_on = process->read(wave, kWaitMs);
        } else {
            jobs::MonotonicClock::sleep_until_ns(jobs::MonotonicClock::now_ns() + kEndsWithinNs);
        }
    }
    if (!process->has_succeeded())
        return fails(fmt::format("expected speech in the language '{}', found an error", style.language));
    return read_wave(wave, program);
}

}  // namespace onggi::sound
