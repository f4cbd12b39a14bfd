// Keeps what the visitor does, and puts pots on the disk, beside the frame: it follows the haptic loop by its
// records, takes moves back, and saves. Asked and answered by the main thread through rings; the work is done
// on a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/spsc_ring.h"
#include "game/app/kiosk_gallery.h"
#include "game/app/kiosk_statistics.h"
#include "game/haptic/fault_report.h"
#include "game/haptic/history.h"
#include "game/haptic/job.h"
#include "game/screens/pot_picture.h"

namespace onggi::app {

struct KeeperAnswer {
    enum class Kind { kCutOff, kSaved, kSaveFailed, kSurvey, kRemark };
    Kind kind = Kind::kRemark;
    std::shared_ptr<const clay::StudioClay> clay{};  // of a cut pot
    int number = 0;                                  // of a saved one, of the day
    std::string words{};                             // for the log
    std::vector<std::string> pots{};                 // of a survey: newest first
    double free_mb = 0.0;                            // of a survey
};

class KioskKeeper final : private jobs::IoWork {
  public:
    // The job's state at its start, which every fresh lump is.
    KioskKeeper(haptic::HapticJob& job, const haptic::HapticState& start,
                const haptic::HapticParameters& parameters, Gallery gallery,
                std::filesystem::path statistics);
    ~KioskKeeper() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Main thread, wait-free.
    void undo() { ask({Wish::Kind::kUndo}); }
    // To two seconds before that tick.
    void go_before(std::uint64_t tick) { ask({Wish::Kind::kBefore, tick}); }
    void cut_off() { ask({Wish::Kind::kCutOff}); }
    void save(std::shared_ptr<const screens::PotShape> shape, int glaze);
    void forget() { ask({Wish::Kind::kForget}); }
    // Answered by kSurvey: what the gallery holds and what the disk has left.
    void survey() { ask({Wish::Kind::kSurvey}); }
    void remove(std::string pot) {
        ask({.kind = Wish::Kind::kRemove, .pot = std::make_shared<const std::string>(std::move(pot))});
    }
    void note(const VisitNote& visit) { ask({.kind = Wish::Kind::kNote, .visit = visit}); }
    [[nodiscard]] std::shared_ptr<const KeeperAnswer> next_answer();

  private:
    struct Wish {
        enum class Kind { kUndo, kBefore, kCutOff, kSave, kForget, kSurvey, kRemove, kNote };
        Kind kind = Kind::kUndo;
        std::uint64_t tick = 0;
        int glaze = 0;
        std::shared_ptr<const screens::PotShape> shape{};
        std::shared_ptr<const std::string> pot{};
        VisitNote visit{};
    };
    void ask(const Wish& wish) { static_cast<void>(wishes_.try_push(wish)); }

    // The keeper's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}
    bool follow();
    void obey(const Wish& wish);
    void put_state_at(std::uint64_t tick);
    void save_now(const Wish& wish);
    void survey_now();
    void remove_now(const std::string& name);
    void answer(KeeperAnswer answer);

    haptic::HapticJob& job_;
    haptic::History history_;
    haptic::FaultReport faults_;
    double rate_hz_;
    Gallery gallery_;
    std::filesystem::path statistics_;
    std::shared_ptr<const clay::StudioClay> cut_;
    jobs::SpscRing<Wish> wishes_{64};
    jobs::SpscRing<std::shared_ptr<const KeeperAnswer>> answers_{64};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
