// Composes and paints screens beside the frame: a first label costs tens of milliseconds, and a pot as many.
// The newest request wins; what lies between is never painted. Main thread, except where it says otherwise.
#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"
#include "engine/ui/painter.h"
#include "game/screens/page/composition.h"
#include "game/screens/page/page.h"
#include "game/screens/page/view.h"

namespace onggi::screens {

// The pots of a composition as they stand just now, by the keys of their items.
struct Turned {
    std::uint64_t key = 0;
    std::shared_ptr<const ui::Painting> painting;
};
using TurnedPots = std::vector<Turned>;

// How far a pot on a shelf has turned: nine seconds a turn, not while a finger is on it; for who wants less
// motion four views, four seconds each. Pure; seconds.
class TurnTable {
  public:
    // dt_s after the last call. 0 to 1.
    double pass(double dt_s, bool still, bool held);

  private:
    double turned_s_ = 0.0;
};

// A composition and what it was made from.
struct Composed {
    std::shared_ptr<const View> view;
    Composition composition;
};

class Composer final : private jobs::IoWork {
  public:
    using Compose = Composition (*)(const View& view, ui::Painter& painter, PaintingStore& store);

    explicit Composer(Compose compose) : compose_(compose) {}
    ~Composer() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Wait-free.
    void ask(std::shared_ptr<const View> view) noexcept { requests_.put(view); }
    // A finger lies on the pots: they stand still.
    void hold(bool held) noexcept { held_.store(held, std::memory_order_relaxed); }
    // The pots of latest(), turned on; null while nothing turns.
    [[nodiscard]] std::shared_ptr<const TurnedPots> turned() noexcept { return turned_.latest(); }
    // The last one finished; null before the first.
    [[nodiscard]] std::shared_ptr<const Composed> latest() noexcept { return done_.latest(); }

  private:
    // The composer's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;
    [[nodiscard]] std::int64_t turn_pots(std::int64_t now_ns);

    const Compose compose_;
    jobs::Mailbox<std::shared_ptr<const View>> requests_;
    jobs::Mailbox<std::shared_ptr<const Composed>> done_;
    jobs::Mailbox<std::shared_ptr<const TurnedPots>> turned_;
    std::atomic<bool> held_{false};
    // Made and used by the composer's thread alone.
    std::unique_ptr<ui::Painter> painter_;
    std::unique_ptr<PaintingStore> store_;
    std::shared_ptr<const View> shown_;
    TurnTable table_;
    std::vector<std::pair<std::uint64_t, std::shared_ptr<const TurningPot>>> turning_;
    std::int64_t turned_ns_ = 0;
    double shown_turn_ = -1.0;
    jobs::IoThread thread_;
};

// The families that the design asks for and this machine lacks, as one line for the log; empty: none. Costs
// a font map: before the frame begins.
[[nodiscard]] std::string missing_fonts();

}  // namespace onggi::screens
