// A recorded line of speech, and its mixing with the wheel's sound. One thread at a time.
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

// Samples at kSampleRateHz, one channel, -1 to 1.
struct SpokenLine {
    std::vector<float> samples;
};

// Reads a RIFF wave file: PCM of 16, 24 or 32 bits or of floats, 1 or 2 channels (mixed to one), 8000 to
// 96000 Hz (resampled by linear interpolation), at most two minutes. Error messages call it `file`. Error:
// bad input for anything else. Reads and allocates: an I/O thread.
Result<SpokenLine> read_wave(std::string_view bytes, const std::string& file);

// Mixes one line at a time over the other sounds, which are lowered meanwhile.
class Speaker {
  public:
    // Starts a line from its beginning; the previous one fades out within a few ms. Null: silence.
    void say(std::shared_ptr<const SpokenLine> line);
    // Mixes the next samples into a block. volume: 0 to 1. The result stays within +-1.
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
