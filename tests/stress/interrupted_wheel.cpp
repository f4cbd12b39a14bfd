// interrupted_wheel FOLDER SEED: simulated visitors without a picture, until the program is killed: the real
// loop, keeper, gallery and journals on the real disk. It resumes or drops an interrupted visit; throws,
// undoes, keeps, discards. For interrupted_test.cpp; it reports progress by bytes on standard output.
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>

#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/app/system/start_log.h"
#include "game/haptic/simulated_device.h"
#include "tests/stress/interrupted_wheel.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;

void say(char byte) {
    if (::write(STDOUT_FILENO, &byte, 1) != 1) std::_Exit(3);
}

class Visitors {
  public:
    Visitors(const fs::path& gallery, unsigned seed) : chance_(seed) {
        auto device = std::make_unique<haptic::SimulatedDevice>();
        hand_ = device.get();
        parameters_.set_rate_hz(stress::kRateHz);
        parameters_.safety = haptics::limits_for(device->capabilities());
        job_ = std::make_unique<haptic::HapticJob>(start_, parameters_, std::move(device),
                                                   haptic::HapticJobOptions{.spares_the_core = true});
        kiosk::Config config;
        config.gallery.folder = gallery.string();
        config.gallery.least_free_mb = 1.0;
        config.gallery.most_pots = stress::kMostPots;  // so that pots are removed too
        keeper_ = std::make_unique<app::KioskKeeper>(*job_, start_, parameters_, app::Gallery(config),
                                                     gallery / "statistics");
    }
    bool start() { return job_->start() && keeper_->start(); }

    void come_and_go() {
        for (;;) {
            pass(5, 20);
            if (interrupted_session_ && one_of(2)) {
                interrupted_session_ = false;
                is_resumed_ = true;
                keeper_->resume(run_);
                say(stress::kResumed);
            } else {
                if (interrupted_session_) keeper_->drop_interrupted_session();
                interrupted_session_ = false;
                is_resumed_ = false;
                if (job_->send(haptic::Command::kFreshLump)) ++run_;
                keeper_->journal(run_);
                say(stress::kThrows);
            }
            throw_for_a_while();
            say(stress::kThrown);
            if (one_of(3)) keeper_->undo();
            if (one_of(2)) keep();
            keeper_->forget();
            say(stress::kGone);
        }
    }

  private:
    unsigned any_below(unsigned count) { return static_cast<unsigned>(chance_() % count); }
    bool one_of(unsigned count) { return any_below(count) == 0; }
    // Waits a random number of milliseconds and takes answers.
    void pass(unsigned least, unsigned most) {
        std::this_thread::sleep_for(std::chrono::milliseconds(least + any_below(most - least)));
        static_cast<void>(job_->newest_snapshot());
        while (const auto answer = keeper_->next_answer()) {
            const auto& what = answer->what;
            if (std::holds_alternative<app::KeeperAnswer::Interrupted>(what)) interrupted_session_ = true;
            if (const auto* cut = std::get_if<app::KeeperAnswer::CutOff>(&what)) cut_ = cut->clay;
            if (std::holds_alternative<app::KeeperAnswer::Saved>(what)) is_saved_ = true;
        }
    }
    void throw_for_a_while() {
        const unsigned moves = one_of(2) ? 2 + any_below(20) : 50 + any_below(80);
        bool threw_on = false;
        for (unsigned move = 0; move < moves; ++move) {
            tool::ToolState tool;
            tool.position_mm = {40.0 + any_below(60), 10.0 + any_below(90), 0.0};
            tool.wheel_button = true;
            tool.water = 1.0;
            hand_->set_target(tool);
            pass(5, 30);
            const haptic::Snapshot& now = job_->newest_snapshot();
            if (is_resumed_ || threw_on || now.run != run_ || now.tick < stress::kTicksToKeep) continue;
            threw_on = true;
            say(stress::kThrewOn);
        }
    }
    void keep() {
        keeper_->cut_off();
        for (int round = 0; round < 1000 && !cut_; ++round)
            pass(1, 3);
        if (!cut_) return;
        const auto pot = std::make_shared<const screens::FiredPot>(app::fired_pot(*cut_, {}, {}));
        keeper_->save(std::shared_ptr<const pot::Section>(pot, &pot->shape), static_cast<int>(any_below(6)));
        say(stress::kSaves);
        is_saved_ = false;
        for (int round = 0; round < 10'000 && !is_saved_; ++round)
            pass(1, 3);
        if (is_saved_) say(stress::kSaved);
        cut_.reset();
    }

    std::mt19937 chance_;
    haptic::HapticState start_ = stress::start();
    haptic::HapticParameters parameters_;
    haptic::SimulatedDevice* hand_ = nullptr;
    std::unique_ptr<haptic::HapticJob> job_;
    std::unique_ptr<app::KioskKeeper> keeper_;
    std::uint64_t run_ = 0;
    std::shared_ptr<const clay::StudioClay> cut_;
    bool interrupted_session_ = false;
    bool is_resumed_ = false;
    bool is_saved_ = false;
};

}  // namespace
}  // namespace onggi

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const std::filesystem::path gallery = argv[1];
    std::vector<std::string> remarks;
    onggi::app::StartKeeper starts(gallery / "state");
    static_cast<void>(starts.begin_now(remarks));
    onggi::Visitors visitors(gallery, static_cast<unsigned>(std::atoi(argv[2])));
    if (!visitors.start()) return 1;
    visitors.come_and_go();
}
