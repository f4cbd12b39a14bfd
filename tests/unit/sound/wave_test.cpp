// The wheel through the real OpenAL Soft, which writes what it would play into a wave file; then that file is
// listened to. The program runs with ALSOFT_DRIVERS=wave.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "engine/sound/openal_player.h"
#include "engine/sound/sound_output.h"
#include "tests/support/comes_true.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/sound/listening.h"

namespace onggi::sound {
namespace {

// The left channel of a plain 16-bit or float stereo file; empty: it is none.
std::vector<double> left_of_wave(const std::string& bytes) {
    const auto word = [&](std::size_t at, std::size_t size) {
        std::uint32_t value = 0;
        for (std::size_t byte = 0; byte < size; ++byte)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + byte])) << (8 * byte);
        return value;
    };
    const std::size_t data = bytes.find("data");
    const std::size_t format = bytes.find("fmt ");
    if (data == std::string::npos || format == std::string::npos || bytes.size() < data + 8) return {};
    const std::uint32_t channels = word(format + 10, 2);
    const std::uint32_t rate = word(format + 12, 4);
    const std::uint32_t bits = word(format + 22, 2);
    if (channels != 2 || rate != 48000 || (bits != 16 && bits != 32)) return {};
    std::vector<double> left;
    for (std::size_t at = data + 8; at + bits / 4 <= bytes.size(); at += bits / 4) {
        if (bits == 16) {
            left.push_back(static_cast<double>(static_cast<std::int16_t>(word(at, 2))) / 32768.0);
        } else {
            left.push_back(static_cast<double>(std::bit_cast<float>(word(at, 4))));
        }
    }
    return left;
}

TEST(SoundThroughOpenAl, IsHeardAsItWasMeantAndEndsWithoutAClick) {
    const test::TemporaryFolder folder;
    const std::string wave = (folder / "wheel.wav").string();
    const std::string settings = (folder / "alsoft.conf").string();
    std::ofstream(settings) << "[general]\nsample-type = int16\nchannels = stereo\n[wave]\nfile = " << wave
                            << "\n";
    ::setenv("ALSOFT_CONF", settings.c_str(), 1);

    SoundOutput sound(make_openal_place());
    ASSERT_TRUE(sound.open());
    sound.play({.rev_min = 120.0, .contact_n = 1.0, .slip_mm_s = 700.0, .wetness = 0.8, .volume = 1.0});
    test::comes_true([&] { return sound.status().blocks >= 150; });
    ASSERT_TRUE(sound.status().is_heard) << sound.status().message;
    ASSERT_GE(sound.status().blocks, 150U);
    sound.close();

    std::ifstream file(wave, std::ios::binary);
    const std::vector<double> heard =
        left_of_wave(std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
    ASSERT_GT(heard.size(), 48'000U) << "more than a second";
    const std::span<const double> middle = std::span(heard).subspan(24'000, 24'000);
    EXPECT_GT(testing::level_db(middle), -30.0);
    EXPECT_LT(testing::level_db(middle), -15.0);
    const double hz = testing::brightness_hz(middle);
    EXPECT_GT(hz, 300.0);
    EXPECT_LT(hz, 2500.0);
    EXPECT_LT(std::abs(heard.back()), 0.003) << "faded out";
}

}  // namespace
}  // namespace onggi::sound
