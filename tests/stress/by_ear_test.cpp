// Visitors who see nothing: they decide by the words that reach the synthesiser alone, and press keys, from
// the attract screen to a kept pot, which must be a good one. One works the buttons by keys, one throws with
// the arrow keys and Enter alone, one by a single switch, one moves a force device alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/control_sense.h"
#include "engine/jobs/mailbox.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"
#include "tests/visitors/judge.h"

namespace onggi::app {
namespace {

using window::Key;

// Hears what a synthesiser would speak, for as long as that takes.
class Ear {
  public:
    [[nodiscard]] KioskVoice::Synthesise synthesiser() {
        return [this](const std::string& /*language*/, const std::string& text,
                      const std::function<bool()>& /*is_wanted*/) -> Result<sound::SpokenLine> {
            const std::lock_guard lock(mutex_);
            heard_.push_back(text);
            return sound::SpokenLine{
                std::vector<float>(static_cast<std::size_t>(seconds_of(text) * sound::kSampleRateHz))};
        };
    }
    // At about 160 words a minute.
    [[nodiscard]] static double seconds_of(const std::string& text) {
        constexpr double kSPerLetter = 0.06;
        return kSPerLetter * static_cast<double>(text.size());
    }
    // What was begun to be said since the last call.
    [[nodiscard]] std::vector<std::string> listen() {
        const std::lock_guard lock(mutex_);
        return std::exchange(heard_, {});
    }

  private:
    std::mutex mutex_;
    std::vector<std::string> heard_;
};

bool has(const std::string& text, std::string_view words) {
    return text.find(words) != std::string::npos;
}

// Of the visit, for each frame. Screens and speech are made by threads in real time, which a busy machine
// gives little of.
constexpr double kFrameS = 1.0 / 120.0;

class ByEar : public testing::Test {
  protected:
    // Waits for up to that many seconds of the visit until a line with these words was said to its end: what
    // another line cuts off is not understood. What was said before does not count again.
    bool hears(std::string_view words, double within_s, double frame_s = kFrameS) {
        return !hears_any({words}, within_s, frame_s).empty();
    }
    // The first line with any of these words; empty if there was none.
    std::string hears_any(std::initializer_list<std::string_view> all_words, double within_s,
                          double frame_s = kFrameS) {
        const double until_s = kiosk.now_s() + within_s;
        for (; kiosk.now_s() < until_s; lives(frame_s)) {
            listens();
            for (; taken < all.size(); ++taken)
                for (const std::string_view words : all_words)
                    if (has(all[taken], words)) return all[taken++];
        }
        return {};
    }
    void listens() {
        if (!saying.empty() && kiosk.now_s() >= said_s) all.push_back(std::exchange(saying, {}));
        for (std::string& line : ear.listen()) {
            said_s = kiosk.now_s() + Ear::seconds_of(line);
            saying = std::move(line);
        }
    }
    // Time passes: as the wheel's while it works, because its clay has a clock of its own.
    void lives(double frame_s) {
        if (kiosk.snapshot().tool.pressing || kiosk.state().throwing.shown) {
            kiosk.passes(0.05);
        } else {
            static_cast<void>(kiosk.until([n = 0]() mutable { return n++ > 0; }, frame_s));
        }
    }
    void waits(double seconds) {
        const double until_s = kiosk.now_s() + seconds;
        for (; kiosk.now_s() < until_s; lives(kFrameS))
            listens();
    }
    void presses(Key key) {
        taken = all.size();
        saying.clear();
        kiosk.press_key(key);
    }
    // For what was perhaps said while the visitor listened for something else.
    bool heard_or_hears(std::string_view words, double within_s) {
        return std::any_of(all.begin(), all.end(), [&](const auto& line) { return has(line, words); }) ||
               hears(words, within_s);
    }
    // What wakes the kiosk.
    virtual void wakes() { presses(first_key()); }
    // What to do to come to a button, and to press it.
    virtual bool chooses(std::string_view words) = 0;

    virtual void comes_to_the_foot() {}
    [[nodiscard]] virtual Key first_key() const { return Key::kTab; }

    // From the attract screen to the clay, and from the finished pot to the shelf.
    void comes() {
        ASSERT_TRUE(hears("Touch anywhere, press any key", 20.0));
        wakes();
        ASSERT_TRUE(hears("What will you make?", 20.0));
        ASSERT_TRUE(hears(says_where_, 60.0)) << "how to go on";
        ASSERT_TRUE(chooses("As you like"));
        ASSERT_TRUE(hears("Step one of three", 20.0));
    }
    // The lesson, each step of it shown.
    void throws() {
        constexpr int kMostSteps = 4;
        std::string step;
        for (int i = 0; i < kMostSteps && !has(step, "Step three of three"); ++i) {
            ASSERT_TRUE(chooses("Show me"));
            step = hears_any({"Step two of three", "Step three of three"}, 40.0);
        }
        ASSERT_TRUE(has(step, "Step three of three"));
        for (int i = 0; i < 3; ++i)
            pulls();
    }
    void pulls() {
        ASSERT_TRUE(chooses("Show me"));
        static_cast<void>(hears("centimetres high", 12.0));
    }
    // "Done", and once more pulls where the kiosk asks for them.
    void ends() {
        constexpr int kMostPulls = 6;
        for (int i = 0; i < kMostPulls; ++i) {
            ASSERT_TRUE(chooses("Done. Cut the pot off the wheel"));
            if (!has(hears_any({"still thick", "Drying"}, 20.0), "still thick")) break;
            ASSERT_TRUE(chooses("Back to the wheel"));
            pulls();
        }
        if (has(hears_any({"Turn the foot", "Decorate the pot"}, 20.0), "Turn the foot")) {
            comes_to_the_foot();
            ASSERT_TRUE(chooses("Leave the foot as it is"));
        }
        ASSERT_TRUE(heard_or_hears("Decorate the pot", 20.0));
        ASSERT_TRUE(chooses("Leave it plain"));
        ASSERT_TRUE(hears("Choose a glaze", 20.0));
        ASSERT_TRUE(chooses("Use this glaze"));
        ASSERT_TRUE(hears("Height", 20.0)) << "the pot in numbers";
        ASSERT_TRUE(chooses("Keep it"));
        ASSERT_TRUE(hears("saved on the museum shelf", 30.0, kSlowly));
    }
    void expect_good_pot() {
        const auto pots = kept_pots(folder.path());
        ASSERT_EQ(pots.size(), 1U);
        const auto verdict = visitors::judge_session((pots.front().folder / "pot.onggi").string());
        ASSERT_TRUE(verdict) << verdict.error().message;
        fmt::print("{}\n", visitors::words_for(*verdict));
        EXPECT_TRUE(verdict->is_good) << verdict->why_not_good;
    }
    void TearDown() override {
        if (!HasFailure() && std::getenv("ONGGI_LOOK") == nullptr) return;
        for (const std::string& line : all)
            fmt::print("  \"{}\"\n", line);
    }

    explicit ByEar(std::optional<OtherDevice> arm = {})
        : kiosk(folder.path(), {.config = english(), .speech = ear.synthesiser()}, std::move(arm)) {}

    const test::TemporaryFolder folder;
    Ear ear;
    UnseenKiosk kiosk;
    std::string says_where_ = "W says where you are";
    std::vector<std::string> all;  // that was said to its end
    std::size_t taken = 0;         // of them were acted on
    std::string saying;            // what is being said
    double said_s = 0.0;           // when that will have been said

  private:
    static kiosk::Config english() {
        kiosk::Config config;
        config.visit.shows_by_itself = false;  // what is shown is asked for
        return config;
    }
};

class ByKeysAndEar : public ByEar {
  protected:
    bool chooses(std::string_view words) override {
        constexpr int kMostButtons = 30;
        for (int i = 0; i < kMostButtons; ++i) {
            presses(Key::kTab);
            constexpr double kANameS = 10.0;
            if (!hears({}, kANameS)) return false;
            if (!has(all.back(), words)) continue;
            presses(Key::kEnter);
            return true;
        }
        return false;
    }
};

TEST_F(ByKeysAndEar, AVisitorWhoIsShownEachStepKeepsAGoodPot) {
    ASSERT_NO_FATAL_FAILURE(comes());
    ASSERT_NO_FATAL_FAILURE(throws());
    presses(Key::kW);
    ASSERT_TRUE(hears("Open", 20.0)) << "asked, the kiosk says how the clay stands";
    ASSERT_NO_FATAL_FAILURE(ends());
    expect_good_pot();
}

class ByArrowsAndEar : public ByEar {
  protected:
    [[nodiscard]] Key first_key() const override { return Key::kRight; }
    bool chooses(std::string_view words) override {
        constexpr int kMostButtons = 30;
        constexpr double kANameS = 10.0;
        for (int i = 0; i < kMostButtons; ++i) {
            if (!has(name_, words)) {
                presses(at_clay_ ? Key::kEnter : Key::kRight);
                if (!hears({}, kANameS)) return false;
                name_ = all.back();
                at_clay_ = has(name_, "your hand");
                continue;
            }
            presses(Key::kEnter);
            name_.clear();
            return true;
        }
        return false;
    }
    void comes_to_the_foot() override { at_clay_ = hears("The arrow keys are your hand", 20.0); }
    // An arrow key, `times` in a row, and to listen, until the words are heard.
    bool until_heard(Key key, int times, std::string_view words) {
        constexpr int kMostRounds = 20;
        constexpr double kListensS = 9.0;
        for (int round = 0; round < kMostRounds; ++round) {
            for (int i = 0; i < times; ++i) {
                kiosk.press_key(key);  // which cuts nothing off that is said of the clay
                waits(0.3);
            }
            if (hears(words, kListensS)) return true;
        }
        return false;
    }
    std::string name_;
    bool at_clay_ = false;
};

TEST_F(ByArrowsAndEar, AVisitorThrowsAndKeepsAGoodPot) {
    ASSERT_NO_FATAL_FAILURE(comes());
    at_clay_ = true;
    ASSERT_TRUE(hears("The arrow keys are your hand", 60.0));
    ASSERT_TRUE(until_heard(Key::kLeft, 4, "Step two"));
    ASSERT_TRUE(until_heard(Key::kUp, 1, "At the rim"));
    ASSERT_TRUE(until_heard(Key::kUp, 1, "Over the middle"));
    ASSERT_TRUE(until_heard(Key::kDown, 4, "Step three"));
    ASSERT_TRUE(until_heard(Key::kUp, 4, "16 centimetres"));
    ASSERT_NO_FATAL_FAILURE(ends());
    expect_good_pot();
}

// An arm with three axes of force that is where the visitor's hand is, in the wheel's time.
class Arm final : public haptics::HapticDevice {
  public:
    explicit Arm(jobs::Mailbox<dvec3>& hand_mm) : hand_mm_(hand_mm) {}
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
        return {.name = "arm", .force_axes = 3, .peak_force_n = 3.0, .continuous_force_n = 3.0};
    }
    [[nodiscard]] haptics::HandSample read(std::uint64_t /*tick*/, double dt_s) noexcept override {
        const dvec3 hand_mm = hand_mm_.latest();
        is_moving_ = sense_.moved_to(hand_mm, dt_s);
        sample_.position_mm = hand_mm + offset_mm_;
        return sample_;
    }
    [[nodiscard]] bool is_moving() const noexcept override { return is_moving_; }
    void take_over(const dvec3& position_mm) noexcept override {
        offset_mm_ += position_mm - sample_.position_mm;
        sample_.position_mm = position_mm;
    }
    void write(const dvec3& /*force_n*/) noexcept override {}

  private:
    jobs::Mailbox<dvec3>& hand_mm_;
    haptics::ControlSense sense_{1.5};
    haptics::HandSample sample_;
    dvec3 offset_mm_{0.0};
    bool is_moving_ = false;
};

struct Hand {
    OtherDevice arm() {
        return {.word = "Arm",
                .device = std::make_unique<Arm>(place_mm),
                .status = [this]() -> const haptics::hid::HidStatus& { return status; }};
    }
    jobs::Mailbox<dvec3> place_mm;
    haptics::hid::HidStatus status{.state = haptics::hid::HidStatus::State::kReady, .name = "Arm"};
};

class ByDeviceAndEar : private Hand, public ByEar {
  protected:
    ByDeviceAndEar() : ByEar(arm()) { says_where_ = "A stroke towards you says where you are"; }
    // The hand goes there in a straight line, with the ears open. mm, mm/s.
    void moves(const dvec3& by_mm, double mm_s = 120.0) {
        constexpr double kStepS = 0.02;
        const int steps = std::max(1, static_cast<int>(glm::length(by_mm) / (mm_s * kStepS)));
        for (int i = 0; i < steps; ++i) {
            hand_mm_ += by_mm / static_cast<double>(steps);
            place_mm.put(hand_mm_);
            kiosk.passes(kStepS);
            listens();
        }
    }
    void strokes(const dvec3& by_mm) {
        taken = all.size();
        saying.clear();
        moves(by_mm, 200.0);
        moves(-by_mm, 200.0);
        waits(0.4);
    }
    void wakes() override {
        moves({30.0, 0.0, 0.0});
        moves({-30.0, 0.0, 0.0});
    }
    // Who hears nothing strokes again, and then looks for the buttons above.
    bool chooses(std::string_view words) override {
        constexpr int kMostStrokes = 40;
        constexpr double kANameS = 5.0;
        waits(1.0);
        int silent = 0;
        for (int i = 0; i < kMostStrokes; ++i) {
            strokes({45.0, 0.0, 0.0});
            if (!hears({}, kANameS)) {
                if (++silent % 2 == 0) moves({0.0, 50.0, 0.0});
                waits(1.0);
                continue;
            }
            silent = 0;
            if (!has(all.back(), words)) continue;
            strokes({0.0, 45.0, 0.0});
            return true;
        }
        return false;
    }
    dvec3 hand_mm_{0.0, 100.0, 100.0};
};

TEST_F(ByDeviceAndEar, AVisitorWhoIsShownEachStepKeepsAGoodPot) {
    ASSERT_NO_FATAL_FAILURE(comes());
    ASSERT_TRUE(hears("The device in your hand", 90.0));
    ASSERT_NO_FATAL_FAILURE(throws());
    ASSERT_NO_FATAL_FAILURE(ends());
    expect_good_pot();
}

class BySwitchAndEar : public ByEar {
  protected:
    // The first press starts the scan; then the ring goes on by itself, and a press takes what was just
    // named.
    bool chooses(std::string_view words) override {
        if (!std::exchange(scans_, true)) presses(Key::kSpace);
        constexpr double kARoundS = 150.0;
        if (!hears(words, kARoundS)) return false;
        presses(Key::kSpace);
        return true;
    }
    bool scans_ = false;
};

TEST_F(BySwitchAndEar, AVisitorKeepsAGoodPot) {
    ASSERT_NO_FATAL_FAILURE(comes());
    ASSERT_NO_FATAL_FAILURE(throws());
    ASSERT_NO_FATAL_FAILURE(ends());
    expect_good_pot();
}

}  // namespace
}  // namespace onggi::app
