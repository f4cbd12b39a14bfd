// Synthetic speech: the real espeak-ng, and programs that fail in every way one can.
#include "engine/sound/speech_program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace onggi::sound {
namespace {

bool always() {
    return true;
}

class FakeProgram : public testing::Test {
  protected:
    // A shell script in place of espeak-ng.
    [[nodiscard]] std::string program(const std::string& script) const {
        const std::string file = (folder_ / "speaks").string();
        std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
        EXPECT_EQ(::chmod(file.c_str(), 0700), 0);
        return file;
    }
    [[nodiscard]] Result<SpokenLine> speaks(const std::string& script,
                                            const std::function<bool()>& is_wanted = always) const {
        return synthesise("Open", {.language = "en"}, is_wanted, program(script));
    }

  private:
    const test::TemporaryFolder folder_;
};

// The header of a wave file of 8 kHz without a length, and a tenth of a second.
constexpr const char* kWave =
    "printf 'RIFF$\\360\\377\\177WAVEfmt "
    "\\020\\000\\000\\000\\001\\000\\001\\000\\100\\037\\000\\000\\200\\076"
    "\\000\\000\\002\\000\\020\\000data\\000\\360\\377\\177'; head -c 1600 /dev/zero";

TEST_F(FakeProgram, GivesItsWaveFileOfUnknownLength) {
    const auto line = speaks(std::string("cat >/dev/null; ") + kWave);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_NEAR(static_cast<double>(line->samples.size()), 4800.0, 8.0);
}

TEST_F(FakeProgram, HearsTheTextAsOneParagraphAndTheLanguagesFirstPart) {
    const test::TemporaryFolder folder;
    const std::string heard = (folder / "heard").string();
    const auto line = synthesise("at\nonce", {.language = "zh-Hans", .words_per_min = 90}, always,
                                 program("echo \"$*\" >" + heard + "; cat >>" + heard + "; " + kWave));
    ASSERT_TRUE(line) << line.error().message;
    std::ifstream file(heard);
    std::string words;
    std::string text;
    std::getline(file, words);
    std::getline(file, text);
    EXPECT_NE(words.find("-v cmn-latn-pinyin -s 90 -a 100"), std::string::npos) << words;
    EXPECT_EQ(text, "at once");
}

TEST_F(FakeProgram, IsRefusedInOneLineHoweverItFails) {
    const struct {
        const char* script;
        const char* message;
    } kCases[] = {
        {"exit 1", "expected speech in the language 'en', found an error"},
        {"kill -SEGV $$", "expected speech in the language 'en', found an error"},
        {"cat >/dev/null; echo words", "expected a RIFF wave file, found something else"},
        {"cat >/dev/null", "expected a RIFF wave file, found something else"},
        {"cat /dev/zero", "expected at most two minutes of speech, found more"},
    };
    for (const auto& one : kCases) {
        const auto line = speaks(one.script);
        ASSERT_FALSE(line) << one.script;
        EXPECT_NE(line.error().message.find(one.message), std::string::npos) << line.error().message;
    }
    const auto none = synthesise("Open", {.language = "en"}, always, "/nowhere/espeak-ng");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kSystemLacks);
}

TEST_F(FakeProgram, IsKilledIfItHangsAndAtOnceIfItsLineIsNoLongerWanted) {
    const auto before = std::chrono::steady_clock::now();
    const auto since_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    };
    int asked = 0;
    const auto dropped = speaks("exec sleep 10h", [&] { return ++asked < 3; });
    ASSERT_FALSE(dropped);
    EXPECT_NE(dropped.error().message.find("no longer wanted"), std::string::npos);
    EXPECT_LT(asked, 10);
    const auto hung = speaks("exec sleep 10h");
    ASSERT_FALSE(hung);
    EXPECT_NE(hung.error().message.find("expected a line within 5 s, found none"), std::string::npos)
        << hung.error().message;
    EXPECT_LT(since_s(), 3600.0);
}

TEST(SpeechProgram, IsFoundByItsNameOrItsPath) {
    EXPECT_TRUE(has_speech_program("sh"));
    EXPECT_TRUE(has_speech_program("/bin/sh"));
    EXPECT_FALSE(has_speech_program("/nowhere/espeak-ng"));
    EXPECT_FALSE(has_speech_program("no-such-program"));
}

struct Spoken {
    const char* language;
    const char* text;
};

class EspeakNg : public testing::TestWithParam<Spoken> {};

TEST_P(EspeakNg, SpeaksAudiblyForAsLongAsAPersonWould) {
    if (!has_speech_program()) GTEST_SKIP() << "espeak-ng is not installed";
    const auto begun = std::chrono::steady_clock::now();
    const auto line = synthesise(GetParam().text, {.language = GetParam().language}, always);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    ASSERT_TRUE(line) << line.error().message;
    const double seconds = static_cast<double>(line->samples.size()) / kSampleRateHz;
    fmt::print("{}: {:.1f} s of speech in {:.0f} ms\n", GetParam().language, seconds, took.count());
    EXPECT_GT(seconds, 1.0);
    EXPECT_LT(seconds, 12.0);
    float loudest = 0.0F;
    for (const float sample : line->samples)
        loudest = std::max(loudest, std::fabs(sample));
    EXPECT_GT(loudest, 0.1F);
}

std::string name_of(const testing::TestParamInfo<Spoken>& info) {
    return std::string(info.param.language).substr(0, 2);
}

INSTANTIATE_TEST_SUITE_P(
    Languages, EspeakNg,
    testing::Values(Spoken{"en", "Step one of three. Press in gently, low down on the clay."},
                    Spoken{"ko", "셋 중 첫째. 흙 아래쪽을 부드럽게 눌러 보세요."},
                    Spoken{"ar", "الخطوة الأولى من ثلاث. اضغط برفق على أسفل الطين."},
                    Spoken{"ja", "みっつのうち、ひとつめ。つちのしたのほうを、そっとおしてください。"},
                    Spoken{"zh-Hans", "三步中的第一步。轻轻地往里按，靠近下面。"},
                    Spoken{"de", "Schritt eins von drei. Drücken Sie sanft nach innen, unten am Ton."},
                    Spoken{"fr", "Étape une sur trois. Appuyez doucement, en bas de l'argile."},
                    Spoken{"es", "Paso uno de tres. Presione suavemente, abajo en el barro."}),
    name_of);

TEST(EspeakNgAlone, IsRefusedForALanguageItDoesNotKnow) {
    if (!has_speech_program()) GTEST_SKIP() << "espeak-ng is not installed";
    const auto line = synthesise("Open", {.language = "xx"}, always);
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("in the language 'xx'"), std::string::npos) << line.error().message;
}

}  // namespace
}  // namespace onggi::sound
