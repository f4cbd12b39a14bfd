#include "engine/sound/spoken_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace onggi::sound {
namespace {

constexpr double kLongestS = 120.0;
constexpr double kDucked = 0.35;  // of the wheel's sound, under speech

// Little-endian, at a place that has been looked at before.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

struct Format {
    std::uint32_t kind = 0;
    std::uint32_t channels = 0;
    std::uint32_t rate_hz = 0;
    std::uint32_t bits = 0;
};

}  // namespace

Result<SpokenLine> read_wave(std::string_view bytes, const std::string& file) {
    const auto refuse = [&](std::string_view expected, std::string_view found) {
        return bad_input(fmt::format("{}: expected {}, found {}", file, expected, found));
    };
    if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE")
        return refuse("a RIFF wave file", "something else");
    Format format;
    std::string_view data;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::string_view name = bytes.substr(at, 4);
        const std::size_t size = number_at(bytes, at + 4, 4);
        at += 8;
        // A recorder that was cut off leaves its last piece short: what is there is spoken.
        const std::string_view piece = bytes.substr(at, size);
        if (name == "fmt " && piece.size() >= 16) {
            format = {number_at(piece, 0, 2), number_at(piece, 2, 2), number_at(piece, 4, 4),
                      number_at(piece, 14, 2)};
        } else if (name == "data") {
            data = piece;
        }
        at += size + size % 2;
    }
    if (format.kind != 1 || format.bits != 16)
        return refuse("16-bit PCM", fmt::format("format {} of {} bits", format.kind, format.bits));
    if (format.channels < 1 || format.channels > 2)
        return refuse("1 or 2 channels", fmt::format("{}", format.channels));
    if (format.rate_hz < 8000 || format.rate_hz > 96000)
        return refuse("8000 to 96000 Hz", fmt::format("{} Hz", format.rate_hz));
    const std::size_t frame_bytes = std::size_t{2} * format.channels;
    const std::size_t frames = data.size() / frame_bytes;
    if (frames == 0) return refuse("samples", "none");
    const double length_s = static_cast<double>(frames) / format.rate_hz;
    if (length_s > kLongestS) return refuse("at most two minutes", fmt::format("{:.0f} s", length_s));

    const auto sample = [&](std::size_t frame) {
        float sum = 0.0F;
        for (std::uint32_t channel = 0; channel < format.channels; ++channel) {
            const auto raw = static_cast<std::uint16_t>(
                number_at(data, frame * frame_bytes + std::size_t{2} * channel, 2));
            sum += static_cast<float>(static_cast<std::int16_t>(raw)) / 32768.0F;
        }
        return sum / static_cast<float>(format.channels);
    };
    SpokenLine line;
    const double step = static_cast<double>(format.rate_hz) / kSampleRateHz;
    const auto count = static_cast<std::size_t>(static_cast<double>(frames) / step);
    line.samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i) * step;
        const auto first = std::min(static_cast<std::size_t>(place), frames - 1);
        const auto share = static_cast<float>(place - static_cast<double>(first));
        const float a = sample(first);
        line.samples.push_back(a + share * (sample(std::min(first + 1, frames - 1)) - a));
    }
    return line;
}

void Speaker::say(std::shared_ptr<const SpokenLine> line) {
    next_ = std::move(line);
    changes_ = true;
}

void Speaker::mix(std::span<Sample> block, double volume) noexcept {
    if (!line_ && !changes_ && duck_.value() > 0.999) return;
    for (Sample& sample : block) {
        if (changes_ && loudness_.value() < 0.01) {
            line_ = std::exchange(next_, nullptr);
            changes_ = false;
            at_ = 0;
        }
        const bool speaks = line_ != nullptr && !changes_;
        const double loudness = loudness_.towards(speaks ? volume : 0.0);
        const double duck = duck_.towards(speaks ? kDucked : 1.0);
        float spoken = 0.0F;
        if (line_ != nullptr) {
            spoken = static_cast<float>(loudness) * line_->samples[at_];
            if (++at_ >= line_->samples.size()) line_ = nullptr;
        }
        for (float* channel : {&sample.left, &sample.right})
            *channel = std::clamp(*channel * static_cast<float>(duck) + spoken, -1.0F, 1.0F);
    }
}

}  // namespace onggi::sound
