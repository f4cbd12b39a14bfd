// Recorded lines: read if present, silence if not.
#include "game/app/kiosk/presentation/kiosk_voice.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/comes_true.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

class VoiceTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  ("voice-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "ko");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    // A tenth of a second at 8 kHz.
    static std::string recording() {
        std::string bytes(
            "RIFF\0\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x40\x1f\0\0\x80\x3e\0\0\2\0\x10\0data\x40\6\0\0", 44);
        for (int i = 0; i < 800; ++i)
            bytes += std::string("\0\x20", 2);
        return bytes;
    }
    fs::path folder_;
};

TEST_F(VoiceTest, ReadsALineWhenItIsDue) {
    write("ko/choose.title.wav", recording());
    KioskVoice voice(folder_);
    ASSERT_TRUE(voice.start());
    EXPECT_TRUE(voice.ask("ko", "choose.title"));
    EXPECT_FALSE(voice.ask("ko", "choose.title")) << "the same again is nothing new";
    ASSERT_TRUE(test::comes_true([&] { return voice.line() != nullptr; }));
    EXPECT_NEAR(static_cast<double>(voice.line()->samples.size()), 4800.0, 8.0);
    EXPECT_EQ(voice.news(), "");
    voice.ask("ko", "");
    EXPECT_EQ(voice.line(), nullptr) << "at once, whatever is still being read";
}

TEST_F(VoiceTest, IsSilentWithoutARecording) {
    KioskVoice voice(folder_);
    ASSERT_TRUE(voice.start());
    voice.ask("en", "choose.title");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(voice.line(), nullptr);
    EXPECT_EQ(voice.news(), "");
    KioskVoice none{fs::path()};
    EXPECT_TRUE(none.start());
    none.ask("en", "choose.title");
    EXPECT_EQ(none.line(), nullptr);
}

TEST_F(VoiceTest, ReportsAnUnreadableRecordingOnce) {
    write("ko/glz.title.wav", "no sound at all");
    KioskVoice voice(folder_);
    ASSERT_TRUE(voice.start());
    voice.ask("ko", "glz.title");
    std::string news;
    ASSERT_TRUE(test::comes_true([&] { return !(news = voice.news()).empty(); }));
    EXPECT_NE(news.find("glz.title.wav: expected a RIFF wave file"), std::string::npos) << news;
    EXPECT_EQ(voice.news(), "");
    EXPECT_EQ(voice.line(), nullptr);
}

}  // namespace
}  // namespace onggi::app
