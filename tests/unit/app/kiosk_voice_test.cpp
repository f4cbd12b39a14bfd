// Lines that are spoken one after the other: recordings first, then synthetic speech.
#include "game/app/kiosk/presentation/kiosk_voice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

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

// A synthesiser of lines of a tenth of a second, which notes what it is told.
struct Notes {
    [[nodiscard]] KioskVoice::Synthesise synthesiser() {
        return [this](const std::string& language, const std::string& text,
                      const std::function<bool()>& is_wanted) -> Result<sound::SpokenLine> {
            ++calls;
            while (hangs && is_wanted()) {
            }
            if (hangs) {
                ++given_up;
                return failed("no longer wanted");
            }
            if (text == "bad") return failed("espeak-ng: expected speech, found an error");
            const std::lock_guard lock(mutex);
            said.push_back(language + " " + text);
            return sound::SpokenLine{std::vector<float>(4800)};
        };
    }
    std::atomic<int> calls = 0;
    std::atomic<int> given_up = 0;
    std::atomic<bool> hangs = false;
    std::mutex mutex;
    std::vector<std::string> said;
};

// Frames on a virtual clock until the voice is silent.
bool falls_silent(KioskVoice& voice, double& now_s) {
    return test::comes_true([&] {
        voice.pass_time(now_s += 0.05);
        return !voice.speaks();
    });
}

TEST_F(VoiceTest, PlaysARecordingWhereThereIsOneAndSpeaksTheRest) {
    write("ko/choose.title.wav", recording());
    Notes notes;
    KioskVoice voice(folder_, notes.synthesiser());
    ASSERT_TRUE(voice.start());
    double now_s = 0.0;
    voice.say({.language = "ko", .key = "choose.title", .text = "무엇을"});
    ASSERT_TRUE(test::comes_true([&] {
        voice.pass_time(now_s += 0.01);
        return voice.line() != nullptr;
    }));
    EXPECT_NEAR(static_cast<double>(voice.line()->samples.size()), 4800.0, 8.0);
    ASSERT_TRUE(falls_silent(voice, now_s));
    EXPECT_EQ(notes.calls, 0);
    voice.say({.language = "ko", .key = "glz.title", .text = "유약"});
    voice.say({.language = "ko", .key = {}, .text = "둘"});
    ASSERT_TRUE(falls_silent(voice, now_s));
    EXPECT_EQ(notes.said, (std::vector<std::string>{"ko 유약", "ko 둘"}));
    EXPECT_EQ(voice.news(), "");
}

TEST_F(VoiceTest, SaysAnUrgentLineAtOnceAndForgetsWhatWaited) {
    Notes notes;
    KioskVoice voice({}, notes.synthesiser());
    ASSERT_TRUE(voice.start());
    double now_s = 0.0;
    voice.say({.language = "en", .key = {}, .text = "first"});
    ASSERT_TRUE(test::comes_true([&] {
        voice.pass_time(now_s);
        return voice.line() != nullptr;
    }));
    voice.say({.language = "en", .key = {}, .text = "waits"});
    voice.say({.language = "en", .key = {}, .text = "now", .is_urgent = true});
    EXPECT_EQ(voice.line(), nullptr) << "the first one is cut off";
    ASSERT_TRUE(falls_silent(voice, now_s));
    EXPECT_EQ(notes.said, (std::vector<std::string>{"en first", "en now"}));
}

TEST_F(VoiceTest, KeepsAFewWaitingLinesOnly) {
    Notes notes;
    KioskVoice voice({}, notes.synthesiser());
    ASSERT_TRUE(voice.start());
    for (int i = 0; i < 100; ++i)
        voice.say({.language = "en", .key = {}, .text = std::to_string(i)});
    double now_s = 0.0;
    ASSERT_TRUE(falls_silent(voice, now_s));
    EXPECT_LE(notes.said.size(), 6U);
    EXPECT_EQ(notes.said.back(), "en 99");
}

TEST_F(VoiceTest, DropsALineThatHangsForAnUrgentOneAndAtItsEnd) {
    Notes notes;
    notes.hangs = true;
    {
        KioskVoice voice({}, notes.synthesiser());
        ASSERT_TRUE(voice.start());
        voice.say({.language = "en", .key = {}, .text = "hangs"});
        voice.pass_time(0.0);
        ASSERT_TRUE(test::comes_true([&] { return notes.calls == 1; }));
        voice.say({.language = "en", .key = {}, .text = "hangs too", .is_urgent = true});
        voice.pass_time(0.1);
        ASSERT_TRUE(test::comes_true([&] { return notes.calls == 2; })) << "the first was given up";
    }
    EXPECT_EQ(notes.given_up, 2) << "and the thread has ended";
}

TEST_F(VoiceTest, ReportsWhatFailsOnceAndRestsAfterSeveral) {
    Notes notes;
    KioskVoice voice({}, notes.synthesiser());
    ASSERT_TRUE(voice.start());
    double now_s = 0.0;
    std::string news;
    for (int i = 0; i < 10; ++i) {
        voice.say({.language = "en", .key = {}, .text = "bad"});
        ASSERT_TRUE(falls_silent(voice, now_s));
        news += voice.news();
    }
    EXPECT_EQ(news, "espeak-ng: expected speech, found an error");
    EXPECT_EQ(notes.calls, 3);
}

TEST_F(VoiceTest, IsSilentWithoutARecordingAndWithoutASynthesiser) {
    KioskVoice voice(folder_, nullptr);
    ASSERT_TRUE(voice.start());
    double now_s = 0.0;
    voice.say({.language = "en", .key = "choose.title", .text = {}});
    ASSERT_TRUE(falls_silent(voice, now_s));
    EXPECT_EQ(voice.line(), nullptr);
    EXPECT_EQ(voice.news(), "");
    KioskVoice none({}, nullptr);
    EXPECT_TRUE(none.start());
    none.say({.language = "en", .key = "choose.title", .text = {}});
    EXPECT_FALSE(none.speaks());
}

TEST_F(VoiceTest, ReportsAnUnreadableRecordingOnceAndSpeaksInItsPlace) {
    write("ko/glz.title.wav", "no sound at all");
    Notes notes;
    KioskVoice voice(folder_, notes.synthesiser());
    ASSERT_TRUE(voice.start());
    double now_s = 0.0;
    voice.say({.language = "ko", .key = "glz.title", .text = "유약"});
    ASSERT_TRUE(falls_silent(voice, now_s));
    const std::string news = voice.news();
    EXPECT_NE(news.find("glz.title.wav: expected a RIFF wave file"), std::string::npos) << news;
    EXPECT_EQ(voice.news(), "");
    EXPECT_EQ(notes.said, std::vector<std::string>{"ko 유약"});
}

}  // namespace
}  // namespace onggi::app
