// The real program in a real window, played by a pointer and killed at random moments of throwing and saving,
// again and again on one gallery: every pot is whole, and a visit that was interrupted is offered by the next
// start. Runs under a display of its own (tests/window/with_display.sh). Two kills in ./check;
// ONGGI_KILLS=200 for the long run, a third of an hour.
#include <fmt/format.h>
#include <signal.h>  // NOLINT: SIGKILL

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "tests/cli/run_program.h"
#include "tests/stress/whole.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;
using test::RunningOnggi;

constexpr double kRateHz = 1000.0;
constexpr int kWidth = 320;
constexpr int kHeight = 180;
// So long has a hand been in the clay when the journal is sure to know of it: a block a second, and a keeper
// who may be late.
constexpr double kThrewOnS = 2.5;

int kills() {
    const char* wanted = std::getenv("ONGGI_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 2;
}

void pause_s(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// What a command says on standard output.
std::string said_by(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    std::string all;
    std::array<char, 512> bytes{};
    while (pipe != nullptr && std::fgets(bytes.data(), static_cast<int>(bytes.size()), pipe) != nullptr)
        all += bytes.data();
    if (pipe != nullptr) ::pclose(pipe);
    return all;
}

// One life of the program, with its visitor.
class Life {
  public:
    Life(const fs::path& folder, const std::vector<std::string>& environment = {})
        : onggi_({"kiosk", "--config", (folder / "kiosk.toml").string(), "--size",
                  fmt::format("{}x{}", kWidth, kHeight), "--device", "mouse", "--volume", "0", "--gallery",
                  (folder / "gallery").string()},
                 {.folder = folder, .environment = environment}) {}

    [[nodiscard]] RunningOnggi& program() { return onggi_; }
    // At most a minute: a software driver under a sanitizer takes ten seconds to its first frame.
    template <typename Condition>
    bool until(Condition&& condition) {
        for (int look = 0; look < 1200 && onggi_.at_work(); ++look) {
            if (condition()) return true;
            pause_s(0.05);
        }
        return condition();
    }
    [[nodiscard]] bool is_on(const std::string& screen) {
        return !said_by("xdotool search --name '^Onggi - " + screen + "( .[0-9]+.)?$'").empty();
    }
    bool comes_to(const std::string& screen) {
        return until([&] { return is_on(screen); });
    }
    bool says(const std::string& words) {
        return until([&] { return onggi_.printed().find(words) != std::string::npos; });
    }
    void click(int x, int y) {
        said_by(fmt::format("xdotool mousemove {} {} sleep 0.1 mousedown 1 sleep 0.1 mouseup 1", x, y));
    }
    // Where the layout has it.
    void press(const std::string& button) {
        static const std::map<std::string, std::pair<int, int>> places = [] {
            std::map<std::string, std::pair<int, int>> found;
            std::istringstream lines(
                said_by(fmt::format("{} en {} {}", ONGGI_SCREEN_TARGETS, kWidth, kHeight)));
            std::string screen;
            std::string name;
            int value = 0;
            int ring = 0;
            int x = 0;
            int y = 0;
            while (lines >> screen >> name >> value >> ring >> x >> y)
                found.try_emplace(screen + ' ' + name, x, y);
            return found;
        }();
        const auto place = places.find(button);
        ASSERT_NE(place, places.end()) << "no button '" << button << "'";
        click(place->second.first, place->second.second);
    }
    // Presses the clay in from the right, low down, and stays there.
    void press_in() {
        std::string way = fmt::format("xdotool mousemove {} {} sleep 0.1 mousedown 1", kWidth * 59 / 100,
                                      kHeight * 54 / 100);
        for (int x = kWidth * 59 / 100; x >= kWidth * 55 / 100; x -= 2)
            way += fmt::format(" mousemove {} {} sleep 0.05", x, kHeight * 54 / 100);
        said_by(way);
    }
    void kill() {
        onggi_.signal(SIGKILL);
        EXPECT_EQ(onggi_.exit_code(10'000), -1) << "it ended by itself:\n" << onggi_.printed();
        said_by("xdotool mouseup 1");
    }

  private:
    RunningOnggi onggi_;
};

enum class Moment { kThrowing, kThrewOn, kSaving, kAnything };

class RealKiosk : public testing::Test {
  protected:
    RealKiosk() {
        std::ofstream(folder / "kiosk.toml")
            << "[languages]\nfirst = \"en\"\n[haptics]\nrate_hz = 1000\n[gallery]\nleast_free_mb = 1\n";
    }
    double any(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(chance);
    }
    // From the first touch to the moment at which it dies.
    void visit(Life& life, Moment moment, bool is_offered) {
        ASSERT_TRUE(life.comes_to("attract")) << life.program().printed();
        if (is_offered) {
            ASSERT_TRUE(life.says("interrupted visit: ")) << life.program().printed();
        }
        life.click(kWidth / 2, kHeight / 2);
        if (is_offered) {
            ASSERT_TRUE(life.comes_to("resume")) << "the pot that was left is not offered";
            pause_s(0.6);
            life.press(chance() % 2 == 0 ? "resume resume-go" : "resume resume-fresh");
        } else {
            ASSERT_TRUE(life.comes_to("choose"));
            pause_s(0.6);
            life.press("choose free");
        }
        ASSERT_TRUE(life.comes_to("throw"));
        pause_s(0.4);
        life.press_in();
        if (moment == Moment::kThrowing) return pause_s(any(0.0, 1.5));
        if (moment == Moment::kThrewOn) return pause_s(any(kThrewOnS, kThrewOnS + 1.0));
        said_by("xdotool mouseup 1");
        if (moment == Moment::kAnything) return pause_s(any(0.0, 1.0));
        life.press("throw-0 done");
        ASSERT_TRUE(life.comes_to("firing"));
        pause_s(0.4);
        life.press("firing-0 skip");
        ASSERT_TRUE(life.comes_to("glaze"));
        pause_s(0.4);
        life.press("glaze-0 take-glaze");
        ASSERT_TRUE(life.comes_to("your-pot"));
        pause_s(0.4);
        life.press("your-pot keep");
        pause_s(any(0.0, 4.0));
    }

    test::TemporaryFolder folder;
    std::mt19937 chance{static_cast<unsigned>(20261122 + kills())};
};

TEST_F(RealKiosk, KilledAtAnyMomentLeavesPotsWholeAndOffersTheVisitAgain) {
    const fs::path gallery = folder / "gallery";
    const haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(kRateHz);
    parameters.studio.forgiving = true;  // as the kiosk's clay is
    std::set<std::string> pots;
    bool is_offered = false;
    int offered = 0;
    std::map<Moment, int> died;
    for (int kill = 0; kill < kills(); ++kill) {
        // Those of ./check: one while throwing, and one while saving who saw the first one's pot offered.
        const auto moment = kill == 0   ? Moment::kThrewOn
                            : kill == 1 ? Moment::kSaving
                                        : static_cast<Moment>(chance() % 4);
        Life life(folder.path());
        visit(life, moment, is_offered);
        offered += is_offered ? 1 : 0;
        ++died[moment];
        life.kill();
        stress::expect_whole_pots(gallery, pots);
        const auto found = stress::expect_whole_visit(gallery, folder / "copy", start, parameters);
        is_offered = found.is_any;
        if (moment == Moment::kThrewOn) {
            EXPECT_TRUE(found.is_any) << "what was thrown for so long is lost";
        }
        if (HasFailure())
            FAIL() << "at kill " << kill + 1 << ", moment " << static_cast<int>(moment) << ":\n"
                   << life.program().printed();
    }
    std::printf(
        "%d kills: %d while throwing, %d after throwing for long, %d while saving, %d elsewhere; %zu "
        "pots whole, %d visits offered again\n",
        kills(), died[Moment::kThrowing], died[Moment::kThrewOn], died[Moment::kSaving],
        died[Moment::kAnything], pots.size(), offered);
    EXPECT_GT(offered, 0) << "nothing was proved";
    if (kills() >= 40) {
        EXPECT_GT(pots.size(), 0U);
    }
}

TEST_F(RealKiosk, WithoutAnyFontSaysSoAndGoesOn) {
    fs::create_directories(folder / "no-fonts");
    std::ofstream(folder / "fonts.conf")
        << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>"
        << (folder / "no-fonts").string() << "</dir><cachedir>" << (folder / "cache").string()
        << "</cachedir></fontconfig>\n";
    Life life(folder.path(), {"FONTCONFIG_FILE=" + (folder / "fonts.conf").string()});
    ASSERT_TRUE(life.comes_to("attract")) << life.program().printed();
    EXPECT_TRUE(
        life.says("fonts: expected NanumSquareRound, NanumMyeongjo, Noto Sans Arabic, Noto Naskh "
                  "Arabic, found none, nor any other font with Latin, Korean, Arabic letters; boxes "
                  "stand in for those words until fonts-nanum and fonts-noto-core are installed\n"))
        << life.program().printed();
    life.click(kWidth / 2, kHeight / 2);
    ASSERT_TRUE(life.comes_to("choose")) << life.program().printed();
    pause_s(0.6);
    life.press("choose free");
    EXPECT_TRUE(life.comes_to("throw")) << "who cannot read can throw";
    life.program().signal(SIGTERM);
    EXPECT_EQ(life.program().exit_code(60'000), 0) << life.program().printed();
}

}  // namespace
}  // namespace onggi
