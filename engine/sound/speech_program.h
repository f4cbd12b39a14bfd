// Synthetic speech by espeak-ng, which runs as a program of its own for each line: its licence (GPL-3) and
// its faults stay outside this program. An I/O thread.
#pragma once

#include <functional>
#include <string>

#include "engine/core/result.h"
#include "engine/sound/spoken_line.h"

namespace onggi::sound {

constexpr const char* kSpeechProgram = "espeak-ng";

// Whether a folder of PATH has that program.
[[nodiscard]] bool has_speech_program(const std::string& program = kSpeechProgram);

struct SpeechStyle {
    std::string language;      // BCP 47, "ko"; the program's voice of that name or of its first part
    int words_per_min = 160;   // 80 to 450
    int volume_percent = 100;  // 0 to 200
};

// Speaks a text of one paragraph, UTF-8; newlines are read as spaces, and what follows 2000 bytes is
// dropped. `is_wanted` is called every few ms; false ends the work. Error: system lacks, if the program is
// missing; failed, if it ends with an error, takes more than 5 s, writes more than two minutes, or is no
// longer wanted; bad input, if it writes anything but a wave file.
Result<SpokenLine> synthesise(const std::string& text, const SpeechStyle& style,
                              const std::function<bool()>& is_wanted,
                              const std::string& program = kSpeechProgram);

}  // namespace onggi::sound
