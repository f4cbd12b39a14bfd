#include "engine/sound/spoken_line.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "engine/core/quote.h"

namespace onggi::sound {
namespace {

constexpr double kLongestS = 120.0;
constexpr double kDucked = 0.35;  // gain of the wheel's sound during speech

constexpr int kLeastRateHz = 8000;
constexpr int kMostRateHz = 96000;

// A file in memory, for libsndfile's virtual I/O.
struct MemoryFile {
    std::string_view bytes;
    sf_count_t at = 0;

    static MemoryFile& of(void* self) { return *static_cast<MemoryFile*>(self); }
    [[nodiscard]] sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }

    static sf_count_t length(void* self) { return of(self).size(); }
    static sf_count_t tell(void* self) { return of(self).at; }
    static sf_count_t seek(sf_count_t offset, int whence, void* self) {
        MemoryFile& file = of(self);
        const sf_count_t from = whence == SEEK_CUR ? file.at : whence == SEEK_END ? file.size() : 0;
        return file.at = std::clamp<sf_count_t>(from + offset, 0, file.size());
    }
    static sf_count_t read(void* to, sf_count_t count, void* self) {
        MemoryFile& file = of(self);
        const sf_count_t got = std::clamp<sf_count_t>(count, 0, file.size() - file.at);
        std::memcpy(to, file.bytes.data() + file.at, static_cast<std::size_t>(got));
        file.at += got;
        return got;
    }
    static sf_count_t write(const void*, sf_count_t, void*) { return 0; }
};

struct Closer {
    void operator()(SNDFILE* file) const { sf_close(file); }
};
using WaveFile = std::unique_ptr<SNDFILE, Closer>;

bool is_plain(int format) {
    const int container = format & SF_FORMAT_TYPEMASK;
    const int coding = format & SF_FORMAT_SUBMASK;
    return (container == SF_FORMAT_WAV || container == SF_FORMAT_WAVEX) &&
           (coding == SF_FORMAT_PCM_16 || coding == SF_FORMAT_PCM_24 || coding == SF_FORMAT_PCM_32 ||
            coding == SF_FORMAT_FLOAT);
}

std::string name_of_coding(int format) {
    SF_FORMAT_INFO info{.format = format & SF_FORMAT_SUBMASK, .name = nullptr, .extension = nullptr};
    sf_command(nullptr, SFC_GET_FORMAT_INFO, &info, sizeof info);
    return info.name != nullptr ? info.name : "another coding";
}

// Reads the file's frames in order, mixed to one channel, a few thousand at a time to save memory.
class Frames {
  public:
    Frames(SNDFILE* file, int channels)
        : file_(file),
          channels_(static_cast<std::size_t>(channels)),
          block_(kBlockFrames * channels_) {}

    // The frame's value. Frames must be read in ascending order; going back by one is allowed. Beyond the end
    // returns the last value.
    float at(sf_count_t frame) {
        while (frame >= first_ + count_ && fill()) {
        }
        return frame < first_ || count_ == 0 ? before_ : mixed(std::min(frame - first_, count_ - 1));
    }

  private:
    static constexpr std::size_t kBlockFrames = 4096;

    bool fill() {
        if (count_ > 0) before_ = mixed(count_ - 1);
        first_ += count_;
        // As floats, for as shorts a float file is silence
        // (findings/libsndfile-reads-a-float-file-as-silent-shorts.sh).
        count_ = std::max<sf_count_t>(0, sf_readf_float(file_, block_.data(), kBlockFrames));
        return count_ > 0;
    }
    [[nodiscard]] float mixed(sf_count_t frame) const {
        const auto from = block_.begin() + frame * static_cast<sf_count_t>(channels_);
        const float sum = std::accumulate(from, from + static_cast<sf_count_t>(channels_), 0.0F);
        const float mean = sum / static_cast<float>(channels_);
        return std::isfinite(mean) ? std::clamp(mean, -1.0F, 1.0F)
                                   : 0.0F;  // a file of floats may contain NaN or infinity
    }

    SNDFILE* file_;
    std::size_t channels_;
    std::vector<float> block_;
    sf_count_t first_ = 0;  // in block_
    sf_count_t count_ = 0;
    float before_ = 0.0F;  // the frame before the block's first
};

}  // namespace

Result<SpokenLine> read_wave(std::string_view bytes, const std::string& file) {
    const auto refuse = [&](std::string_view expected, std::string_view found) {
        return bad_input(fmt::format("{}: expected {}, found {}", file, expected, found));
    };
    // libsndfile reads many more formats, which are not wanted.
    if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE")
        return refuse("a RIFF wave file", "something else");
    MemoryFile memory{.bytes = bytes};
    SF_VIRTUAL_IO access{MemoryFile::length, MemoryFile::seek, MemoryFile::read, MemoryFile::write,
                         MemoryFile::tell};
    SF_INFO info{};
    const WaveFile wave(sf_open_virtual(&access, SFM_READ, &info, &memory));
    if (wave == nullptr) return refuse("a wave file that can be read", in_quotes(sf_strerror(nullptr), 100));
    if (!is_plain(info.format))
        return refuse("PCM of 16, 24 or 32 bits or of floats", name_of_coding(info.format));
    if (info.channels < 1 || info.channels > 2)
        return refuse("1 or 2 channels", fmt::format("{}", info.channels));
    if (info.samplerate < kLeastRateHz || info.samplerate > kMostRateHz)
        return refuse(fmt::format("{} to {} Hz", kLeastRateHz, kMostRateHz),
                      fmt::format("{} Hz", info.samplerate));
    if (info.frames <= 0) return refuse("samples", "none");
    const double length_s = static_cast<double>(info.frames) / info.samplerate;
    if (length_s > kLongestS) return refuse("at most two minutes", fmt::format("{:.0f} s", length_s));

    Frames frames(wave.get(), info.channels);
    SpokenLine line;
    const double step = static_cast<double>(info.samplerate) / kSampleRateHz;
    const auto count = static_cast<std::size_t>(static_cast<double>(info.frames) / step);
    line.samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i) * step;
        const auto first = static_cast<sf_count_t>(place);
        const auto fraction = static_cast<float>(place - static_cast<double>(first));
        const float a = frames.at(first);
        line.samples.push_back(a + fraction * (frames.at(first + 1) - a));
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
