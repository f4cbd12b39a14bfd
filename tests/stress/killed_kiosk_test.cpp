// The real program in a real window, used by a pointer and killed at random moments of starting, throwing and
// saving, repeatedly on one gallery: every pot is complete, and the next start offers an interrupted visit.
// Runs under a display of its own (tests/window/with_display.sh). Two kills in ./check; ONGGI_KILLS=200 for
// the long run, half an hour or more.
#include <fmt/format.h>
#include <signal.h>  // NOLINT: SIGKILL

#include <algorithm>
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
#include "tests/stress/keeping_stage.h"
#include "tests/stress/whole.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"
#include "tests/visitors/judge.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;
using test::RunningOnggi;

constexpr double kRateHz = 1000.0;
constexpr int kWidth = 320;
constexpr int kHeight = 180;
// After this time in the clay the journal must contain the hand's work: one block per second, and a keeper
// that may be late.
constexpr double kThrewOnS = 2.5;
constexpr double kSettleS = 0.6;    // from a screen to the first press that it accepts
constexpr double kStepS = 0.05;     // between two of a finger's 30 places
constexpr double kStartS = 3.0;     // from the launch to the attract screen, and on
constexpr double kPortraitS = 1.0;  // from the request to keep a pot to its folder
constexpr double kFileS = 0.004;    // from one of its files to the next, for those that are computed quickly
constexpr double kWriteS = 0.0008;  // the writing time of the smallest of them
constexpr double kLookS = 0.0001;

int kills() {
    const char* wanted = std::getenv("ONGGI_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 2;
}

void pause_s(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// An earlier press is not accepted.
void settle() {
    pause_s(kSettleS * test::slowness());
}

// A command's standard output.
std::string said_by(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    std::string all;
    std::array<char, 512> bytes{};
    while (pipe != nullptr && std::fgets(bytes.data(), static_cast<int>(bytes.size()), pipe) != nullptr)
        all += bytes.data();
    if (pipe != nullptr) ::pclose(pipe);
    return all;
}

// One run of the program, with its visitor.
class Life {
  public:
    Life(const fs::path& folder, const std::vector<std::string>& environment = {})
        : onggi_({"kiosk", "--config", (folder / "kiosk.toml").string(), "--size",
                  fmt::format("{}x{}", kWidth, kHeight), "--device", "mouse", "--volume", "0", "--gallery",
                  (folder / "gallery").string()},
                 {.folder = folder, .environment = environment}) {}

    [[nodiscard]] RunningOnggi& program() { return onggi_; }
    [[nodiscard]] bool is_safe_mode() {
        return onggi_.printed().find("onggi: safe mode: ") != std::string::npos;
    }
    // Five minutes, longer on a slow machine: a software driver under a sanitizer takes ten seconds to its
    // first frame, and the machine may be busy.
    template <typename Condition>
    bool until(Condition&& condition, double look_s = 0.05) {
        const auto end = std::chrono::steady_clock::now() + test::scaled(std::chrono::minutes(5));
        while (onggi_.at_work() && std::chrono::steady_clock::now() < end) {
            if (condition()) return true;
            pause_s(look_s);
        }
        return condition();
    }
    [[nodiscard]] bool is_on(const std::string& screen) {
        return !said_by("xdotool search --name '^Onggi - " + screen +
                        "( - [0-3] of 3, .*| - [0-9]+ strokes| - [0-9]+ g)?$'")
                    .empty();
    }
    bool comes_to(const std::string& screen) {
        return until([&] { return is_on(screen); });
    }
    bool says(const std::string& words) {
        return until([&] { return onggi_.printed().find(words) != std::string::npos; });
    }
    // Presses that button of the current screen, and again from time to time while that screen stays: a press
    // before the screen is drawn is not accepted, and a busy machine draws it late.
    template <typename Condition>
    bool press_until(const std::string& button, Condition&& condition, double look_s = 0.05) {
        const std::string screen = button.substr(0, std::min(button.find("-0 "), button.find(' ')));
        const auto again = test::scaled(std::chrono::seconds(10));
        settle();
        press(button);
        auto next = std::chrono::steady_clock::now() + again;
        return until(
            [&] {
                if (condition()) return true;
                if (std::chrono::steady_clock::now() >= next && is_on(screen)) {
                    press(button);
                    next = std::chrono::steady_clock::now() + again;
                }
                return false;
            },
            look_s);
    }
    bool press_to(const std::string& button, const std::string& screen) {
        return press_until(button, [&] { return is_on(screen); });
    }
    void click(int x, int y) {
        said_by(fmt::format("xdotool mousemove {} {} sleep 0.1 mousedown 1 sleep 0.1 mouseup 1", x, y));
    }
    // Presses at the button's position in the layout.
    void press(const std::string& button) {
        static const std::map<std::string, std::pair<int, int>> places = [] {
            std::map<std::string, std::pair<int, int>> found;
            std::istringstream lines(
                said_by(fmt::format("{} en {} {}", test::in_build("tests/screen_targets"), kWidth, kHeight)));
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
        if (button == "attract anywhere") return click(kWidth / 2, kHeight / 2);
        const auto place = places.find(button);
        ASSERT_NE(place, places.end()) << "no button '" << button << "'";
        click(place->second.first, place->second.second);
    }
    // Presses the clay in from the right, near the foot, and holds.
    void press_in() { lay_finger({{66.0, 15.0}, {54.0, 15.0}}); }
    // Opens the clay and pulls its wall up, repeating each step until it succeeds; returns false if it does
    // not.
    bool throw_a_pot() {
        constexpr int kTries = 10;
        for (int tries = 0; tries < kTries && !has_done(2); ++tries)
            stroke({{0.0, 52.0}, {0.0, 12.0}, {22.0, 12.0}});
        stroke({{0.0, 52.0}, {0.0, 12.0}, {22.0, 12.0}});  // wider, or no wall gets thin
        for (int tries = 0; tries < kTries && !has_done(3); ++tries)
            stroke({{62.0, 15.0}, {58.0, 160.0}});
        return has_done(3);
    }
    void kill() {
        onggi_.signal(SIGKILL);
        EXPECT_EQ(onggi_.exit_code(), -1) << "it ended by itself:\n" << onggi_.printed();
        said_by("xdotool mouseup 1");
    }

  private:
    // Whether that many lesson steps are done, by the title, a moment after the hand has left.
    bool has_done(int steps) {
        pause_s(0.3 * test::slowness());
        return !said_by(fmt::format("xdotool search --name '^Onggi - throw - [{}-3] of 3'", steps)).empty();
    }
    // Moves from the first position to the last and stays there; radius and height in mm, through the camera,
    // which is another in safe mode.
    void lay_finger(const std::vector<dvec2>& way_mm) {
        std::string asked;
        for (const dvec2& place_mm : way_mm)
            asked += fmt::format("{} {}\\n", place_mm.x, place_mm.y);
        std::istringstream lines(
            said_by(fmt::format("printf '{}' | {} {} {}{}", asked, test::in_build("tests/clay_places"),
                                kWidth, kHeight, is_safe_mode() ? " plain" : "")));
        std::vector<dvec2> way_px;
        dvec2 px(0.0);
        while (lines >> px.x >> px.y)
            way_px.push_back(px);
        ASSERT_EQ(way_px.size(), way_mm.size());
        std::string moves = fmt::format("xdotool mousemove {:.0f} {:.0f} sleep 0.1 mousedown 1",
                                        way_px.front().x, way_px.front().y);
        constexpr int kSteps = 30;
        for (int step = 1; step <= kSteps; ++step) {
            const dvec2 at = glm::mix(way_px.front(), way_px.back(), static_cast<double>(step) / kSteps);
            moves +=
                fmt::format(" mousemove {:.0f} {:.0f} sleep {:.2f}", at.x, at.y, kStepS * test::slowness());
        }
        said_by(moves);
    }
    void stroke(const std::vector<dvec2>& way_mm) {
        lay_finger(way_mm);
        pause_s(0.4 * test::slowness());
        said_by("xdotool mouseup 1");
    }

    RunningOnggi onggi_;
};

enum class Moment { kStarting, kThrowing, kThrewOn, kAnything, kSaving };
// Half of all kills fall into saving, which is very short.
constexpr std::array kMoments{Moment::kStarting, Moment::kThrowing, Moment::kThrewOn, Moment::kAnything,
                              Moment::kSaving,   Moment::kSaving,   Moment::kSaving,  Moment::kSaving};

// The stages in which kills during saving fell.
struct SavingKills {
    std::map<stress::Stage, int> at;
    int with_a_nameless_file = 0;

    [[nodiscard]] int between_files() const {
        int count = 0;
        for (const auto& [stage, kills] : at)
            if (stage != stress::Stage::kNothing && stage != stress::Stage::kKept) count += kills;
        return count;
    }
    [[nodiscard]] std::string words() const {
        std::string all;
        for (const auto& [stage, kills] : at)
            all += fmt::format("; {} {}", kills, stress::name_of(stage));
        return all +
               fmt::format("; {} with a file of the pot open that had no name yet", with_a_nameless_file);
    }
};

class RealKiosk : public testing::Test {
  protected:
    RealKiosk() {
        std::ofstream(folder / "kiosk.toml")
            << "[languages]\nfirst = \"en\"\n[haptics]\nrate_hz = 1000\n[gallery]\nleast_free_mb = 1\n";
        parameters.set_rate_hz(kRateHz);
        parameters.studio.forgiving = true;  // as in the kiosk
    }
    double any(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(chance);
    }
    // From the start to the kill; `offered` is what the previous run left.
    void visit(Life& life, Moment moment, const stress::Found& offered) {
        if (moment == Moment::kStarting) return pause_s(any(0.0, kStartS));
        ASSERT_TRUE(life.comes_to("attract")) << life.program().printed();
        if (offered.is_any) {
            ASSERT_TRUE(life.says("interrupted visit: ")) << life.program().printed();
        }
        if (offered.is_any) {
            ASSERT_TRUE(life.press_to("attract anywhere", "resume"))
                << "the pot that was left is not offered";
            went_on = chance() % 2 == 0;
            ASSERT_TRUE(life.press_to(went_on ? "resume resume-go" : "resume resume-fresh", "throw"));
        } else {
            ASSERT_TRUE(life.press_to("attract anywhere", "choose"));
            ASSERT_TRUE(life.press_to("choose free", "throw"));
        }
        settle();
        if (moment == Moment::kSaving) {
            ASSERT_TRUE(life.throw_a_pot())
                << said_by("xdotool search --name '^Onggi' getwindowname") << life.program().printed();
            return go_on_to_save(life);
        }
        life.press_in();
        if (moment == Moment::kThrowing) return pause_s(any(0.0, 1.5));
        if (moment == Moment::kThrewOn) {
            pause_s(kThrewOnS);
            // On a slow machine the keeper is later: the first block may have begun before the hand came.
            for (int block = 0; block < 2; ++block)
                ASSERT_TRUE(life.until([&, before = journal_bytes()] { return journal_bytes() > before; }))
                    << life.program().printed();
            return pause_s(any(0.0, 1.0));
        }
        said_by("xdotool mouseup 1");
        pause_s(any(0.0, 1.0));
    }
    void go_on_to_save(Life& life) {
        // Drying and firing advance by themselves: on a slow machine a press would reach the next screen. A
        // thick foot may be trimmed.
        ASSERT_TRUE(
            life.press_until("throw-0 done", [&] { return life.is_on("trim") || life.is_on("decorate"); }));
        if (life.is_on("trim")) {
            ASSERT_TRUE(life.press_to("trim skip", "decorate"));
        }
        ASSERT_TRUE(life.press_to("decorate-0 done", "glaze"));
        ASSERT_TRUE(life.press_to("glaze-0 take-glaze", "your-pot"));
        settle();
        keep(life);
    }
    // Keeps the pot until shortly after a randomly chosen file exists or is being written. The portrait is
    // painted before any file is written, which takes a thousand times longer.
    void keep(Life& life) {
        const auto wanted = static_cast<stress::Stage>(chance() % stress::kStages);
        const bool while_written = chance() % 2 == 0;
        const int process = life.program().process();
        if (wanted == stress::Stage::kNothing) {
            life.press("your-pot keep");
            return pause_s(any(0.0, kPortraitS));
        }
        const auto stage = [&] { return stress::stage_of(gallery(), pots.size()); };
        ASSERT_TRUE(life.press_until(
            "your-pot keep", [&] { return stage() >= wanted; }, kLookS))
            << life.program().printed();
        if (while_written && wanted != stress::Stage::kKept)  // nothing is written after it
            life.until([&] { return stage() > wanted || stress::is_writing_a_pot(process); }, kLookS);
        pause_s(any(0.0, while_written ? kWriteS : kFileS));
        saving.with_a_nameless_file += stress::is_writing_a_pot(process) ? 1 : 0;
    }
    static void expect_pot(const std::string& folder_of_pot) {
        const auto verdict = visitors::judge_session(folder_of_pot + "/pot.onggi");
        ASSERT_TRUE(verdict) << verdict.error().message;
        EXPECT_TRUE(verdict->is_pot) << verdict->why_not << ": " << visitors::words_for(*verdict);
    }
    [[nodiscard]] std::filesystem::path gallery() const { return folder / "gallery"; }
    // The size of the current visit's journal.
    [[nodiscard]] std::uintmax_t journal_bytes() const {
        std::uintmax_t bytes = 0;
        std::error_code none;
        for (const auto& file : fs::directory_iterator(gallery() / "state", none)) {
            std::error_code gone;
            const std::uintmax_t size = file.file_size(gone);
            if (!gone && file.path().filename().string().starts_with("visit-")) bytes += size;
        }
        return bytes;
    }

    test::TemporaryFolder folder;
    std::mt19937 chance{static_cast<unsigned>(20261122 + kills())};
    const haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters;
    std::set<std::string> pots;  // complete ones after the last run
    SavingKills saving;
    bool went_on = false;  // whether it resumed the offered visit
};

TEST_F(RealKiosk, KilledAtAnyMomentLeavesPotsWholeAndOffersTheVisitAgain) {
    stress::Found left;
    int offered = 0;
    int resumed = 0;
    int in_safe_mode = 0;
    std::map<Moment, int> died;
    for (int kill = 0; kill < kills(); ++kill) {
        // In ./check: one kill while throwing, and one while saving, after the first one's pot was offered.
        const auto moment = kill == 0   ? Moment::kThrewOn
                            : kill == 1 ? Moment::kSaving
                                        : kMoments[chance() % kMoments.size()];
        const stress::Found before = left;
        went_on = false;
        // Three kills within ten minutes begin safe mode, without the room and the devices. Forgotten before
        // one visit of three, they leave most visits both.
        if (chance() % 3 == 0) fs::remove(gallery() / "state/starts");
        Life life(folder.path());
        visit(life, moment, before);
        offered += before.is_any && moment != Moment::kStarting ? 1 : 0;
        ++died[moment];
        in_safe_mode += life.is_safe_mode() ? 1 : 0;
        resumed += went_on ? 1 : 0;
        life.kill();
        const stress::Stage stage = stress::stage_of(gallery(), pots.size());
        if (moment == Moment::kSaving) ++saving.at[stage];
        const std::set<std::string> kept_before = pots;
        stress::expect_whole_pots(gallery(), pots);
        for (const std::string& pot : pots)
            if (!kept_before.contains(pot)) expect_pot(pot);
        EXPECT_EQ(pots.size(), kept_before.size() + (stage == stress::Stage::kKept ? 1 : 0));
        left = stress::expect_whole_visit(gallery(), folder / "copy", start, parameters);
        if (moment == Moment::kThrewOn) {
            EXPECT_TRUE(left.is_any) << "work of that duration is lost";
        }
        if (moment == Moment::kSaving && stage != stress::Stage::kKept) {
            EXPECT_TRUE(left.is_any) << "neither a pot nor a visit";
        }
        if ((moment == Moment::kStarting && before.is_any) || (went_on && stage != stress::Stage::kKept)) {
            EXPECT_GE(left.ticks, before.ticks) << "what waited to be picked up is lost";
        }
        if (HasFailure())
            FAIL() << "at kill " << kill + 1 << ", moment " << static_cast<int>(moment) << ", "
                   << stress::name_of(stage) << ":\n"
                   << life.program().printed();
    }
    std::printf(
        "%d kills: %d while starting, %d while throwing, %d after throwing for long, %d elsewhere; %d while "
        "saving%s. %zu pots whole, %d visits offered again, %d of them resumed; %d in safe mode\n",
        kills(), died[Moment::kStarting], died[Moment::kThrowing], died[Moment::kThrewOn],
        died[Moment::kAnything], died[Moment::kSaving], saving.words().c_str(), pots.size(), offered, resumed,
        in_safe_mode);
    EXPECT_GT(offered, 0) << "nothing was proved";
    if (kills() >= 40) {
        EXPECT_GT(pots.size(), 0U);
        EXPECT_GT(saving.between_files(), kills() / 10) << "too few fell while a pot was written";
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
    ASSERT_TRUE(life.press_to("attract anywhere", "choose")) << life.program().printed();
    EXPECT_TRUE(life.press_to("choose free", "throw")) << "who cannot read can throw";
    life.program().signal(SIGTERM);
    EXPECT_EQ(life.program().exit_code(), 0) << life.program().printed();
}

}  // namespace
}  // namespace onggi
