// Lines of speech: reading and refusing wave files, and their playback.
#include "engine/sound/spoken_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace onggi::sound {
namespace {

std::string little(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i, value >>= 8U)
        text += static_cast<char>(value & 0xffU);
    return text;
}

// A wave file of one loudness, given as one sample's bits.
std::string wave(std::uint32_t rate_hz, std::uint32_t channels, std::size_t frames, std::uint32_t value,
                 std::uint32_t bits = 16, std::uint32_t kind = 1) {
    std::string data;
    for (std::size_t i = 0; i < frames * channels; ++i)
        data += little(value, static_cast<int>(bits / 8));
    const std::uint32_t frame_bytes = channels * bits / 8;
    const std::string format = little(kind, 2) + little(channels, 2) + little(rate_hz, 4) +
                               little(rate_hz * frame_bytes, 4) + little(frame_bytes, 2) + little(bits, 2);
    // With an unknown chunk of odd size in between.
    return "RIFF" + little(0, 4) + "WAVEfmt " + little(16, 4) + format + "LIST" + little(3, 4) + "abc\0" +
           std::string(1, '\0') + "data" + little(static_cast<std::uint32_t>(data.size()), 4) + data;
}

TEST(SpokenLine, ReadsEveryRateAndOneOrTwoChannels) {
    for (const std::uint32_t rate_hz : {8000U, 22050U, 44100U, 48000U, 96000U}) {
        for (const std::uint32_t channels : {1U, 2U}) {
            const auto line = read_wave(wave(rate_hz, channels, rate_hz / 10, 16384), "line.wav");
            ASSERT_TRUE(line) << line.error().message;
            EXPECT_NEAR(static_cast<double>(line->samples.size()), 4800.0, 2.0);
            EXPECT_NEAR(line->samples[2000], 0.5F, 1e-4F);
        }
    }
}

TEST(SpokenLine, ReadsFilesOfCommonRecorders) {
    constexpr std::uint32_t kFloats = 3;
    const auto middle = [](const std::string& bytes) {
        const auto line = read_wave(bytes, "line.wav");
        return line ? line->samples[line->samples.size() / 2] : -2.0F;
    };
    EXPECT_NEAR(middle(wave(48000, 1, 5000, 0x400000, 24)), 0.5F, 1e-6F);
    EXPECT_NEAR(middle(wave(48000, 1, 5000, 0xc0000000, 32)), -0.5F, 1e-6F);
    EXPECT_NEAR(middle(wave(48000, 2, 5000, std::bit_cast<std::uint32_t>(0.25F), 32, kFloats)), 0.25F, 1e-6F);
    EXPECT_EQ(middle(wave(48000, 1, 5000, std::bit_cast<std::uint32_t>(7.0F), 32, kFloats)), 1.0F);
    EXPECT_EQ(middle(wave(48000, 1, 5000, std::bit_cast<std::uint32_t>(std::nanf("")), 32, kFloats)), 0.0F);
}

TEST(SpokenLine, GoesOnEvenlyFromBlockToBlock) {
    // A ramp of 20000 frames, at half the rate: straight lines between its samples are the ramp again.
    std::string bytes = wave(24000, 1, 20000, 0);
    for (std::size_t i = 0; i < 20000; ++i) {
        const std::string sample = little(static_cast<std::uint32_t>(i), 2);
        std::copy(sample.begin(), sample.end(), bytes.end() - 40000 + static_cast<std::ptrdiff_t>(2 * i));
    }
    const auto line = read_wave(bytes, "line.wav");
    ASSERT_TRUE(line) << line.error().message;
    ASSERT_EQ(line->samples.size(), 40000U);
    for (std::size_t i = 0; i + 1 < line->samples.size(); ++i)
        ASSERT_NEAR(line->samples[i], static_cast<float>(i) / 65536.0F, 1e-6F) << i;
}

TEST(SpokenLine, RejectsOtherFilesInOneLine) {
    const auto message = [](const std::string& bytes) {
        const auto line = read_wave(bytes, "en/choose.title.wav");
        return line ? std::string() : line.error().message;
    };
    EXPECT_EQ(message("MP3"), "en/choose.title.wav: expected a RIFF wave file, found something else");
    EXPECT_EQ(
        message(wave(48000, 1, 10, 1, 8)),
        "en/choose.title.wav: expected PCM of 16, 24 or 32 bits or of floats, found Unsigned 8 bit PCM");
    EXPECT_EQ(message(wave(48000, 1, 10, 1, 8, 7)),
              "en/choose.title.wav: expected PCM of 16, 24 or 32 bits or of floats, found U-Law");
    const std::string broken = message(wave(48000, 1, 10, 1, 16, 0x55));
    EXPECT_TRUE(broken.starts_with("en/choose.title.wav: expected a wave file that can be read, found '"))
        << broken;
    EXPECT_EQ(broken.find('\n'), std::string::npos);
    EXPECT_EQ(message(wave(48000, 6, 10, 1)), "en/choose.title.wav: expected 1 or 2 channels, found 6");
    EXPECT_EQ(message(wave(4000, 1, 10, 1)), "en/choose.title.wav: expected 8000 to 96000 Hz, found 4000 Hz");
    EXPECT_EQ(message(wave(48000, 1, 0, 1)), "en/choose.title.wav: expected samples, found none");
    EXPECT_EQ(message(wave(8000, 1, 8000 * 121, 1)),
              "en/choose.title.wav: expected at most two minutes, found 121 s");
}

TEST(SpokenLine, ReadsNoFurtherThanAFileThatWasCutOffGoes) {
    const std::string whole = wave(48000, 2, 4800, 16384);
    for (std::size_t size = 0; size < whole.size(); size += 97)
        (void)read_wave(std::string_view(whole).substr(0, size), "cut.wav");
    const auto half = read_wave(std::string_view(whole).substr(0, whole.size() / 2), "cut.wav");
    ASSERT_TRUE(half);
    EXPECT_LT(half->samples.size(), 2600U);
}

class SpeakerTest : public ::testing::Test {
  protected:
    // The loudest of the next block over a steady sound.
    float hear(double volume = 1.0) {
        block_.fill({0.2F, 0.2F});
        speaker_.mix(block_, volume);
        float loudest = 0.0F;
        for (const Sample& sample : block_)
            loudest = std::max(loudest, std::abs(sample.left));
        return loudest;
    }
    static std::shared_ptr<const SpokenLine> line(std::size_t samples, float value) {
        return std::make_shared<const SpokenLine>(SpokenLine{std::vector<float>(samples, value)});
    }
    std::array<Sample, 4800> block_{};
    Speaker speaker_;
};

TEST_F(SpeakerTest, SpeaksALineOnceOverASofterWheel) {
    EXPECT_FLOAT_EQ(hear(), 0.2F) << "nothing to say";
    speaker_.say(line(9600, 0.4F));
    EXPECT_NEAR(hear(), 0.6F, 0.1F);
    EXPECT_TRUE(speaker_.speaks());
    hear();
    EXPECT_FALSE(speaker_.speaks());
    for (int i = 0; i < 12; ++i)
        hear();
    EXPECT_NEAR(hear(), 0.2F, 0.001F) << "and the wheel is as loud as before";
}

TEST_F(SpeakerTest, LeavesOneLineForAnotherWithoutAClick) {
    speaker_.say(line(48000, 0.5F));
    hear();
    speaker_.say(line(48000, -0.5F));
    block_.fill({});
    speaker_.mix(block_, 1.0);
    float before = block_.front().left;
    for (const Sample& sample : block_) {
        EXPECT_LT(std::abs(sample.left - before), 0.02F);
        before = sample.left;
    }
    EXPECT_LT(before, -0.3F);
    speaker_.say(nullptr);
    hear();
    EXPECT_FALSE(speaker_.speaks());
}

TEST_F(SpeakerTest, IsNeverTooLoudAndSilentAtVolumeNought) {
    speaker_.say(line(48000, 1.0F));
    hear();
    EXPECT_LE(hear(), 1.0F);
    for (int i = 0; i < 4; ++i)
        hear(0.0);
    EXPECT_LT(hear(0.0), 0.09F) << "only the wheel, ducked";
}

}  // namespace
}  // namespace onggi::sound
