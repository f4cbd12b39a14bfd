// A recording of somebody speaking a line, and how it is mixed under the wheel's sound. Plain; any one
// thread.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/sound/synthesiser.h"

namespace onggi::sound {

// At kSampleRateHz, one channel, -1 to 1.
struct SpokenLine {
    std::vector<float> samples;
};

// Reads a RIFF wave file: PCM of 16, 24 or 32 bits or of floats, 1 or 2 channels (mixed to one), 8000 to
// 96000 Hz (brought to ours by straight lines between samples), at most two minutes. `file` is what messages
// call it. Bad input: anything else, in one line that says what was expected and what was found. Reads and
// allocates: an I/O thread.
Result<SpokenLine> read_wave(std::string_view bytes, const std::string& file);

// Speaks one line at a time over whatever else sounds, which is softer meanwhile.
class Speaker {
  public:
    // From its beginning; what was spoken before fades away within a few ms. Null: silence.
    void say(std::shared_ptr<const SpokenLine> line);
    // Lays the next samples over a block. volume: 0 to 1. Never beyond +-1.
    void mix(std::span<Sample> block, double volume) noexcept;
    [[nodiscard]] bool speaks() const { return line_ != nullptr; }

  private:
    std::shared_ptr<const SpokenLine> line_;
    std::shared_ptr<const SpokenLine> next_;
    bool changes_ = false;
    std::size_t at_ = 0;
    Glide loudness_{0.006};
    Glide duck_{0.08, 1.0};
};

}  // namespace onggi::sound
