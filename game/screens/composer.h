// Composes and paints screens on a background thread, because a first label or a pot costs tens of
// milliseconds. Only the newest request is painted. Main thread, except as noted.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <string>
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

// The current pictures of a composition's turning pots, by the keys of their items.
struct Turned {
    std::uint64_t key = 0;
    std::shared_ptr<const ui::Painting> painting;
};
using TurnedPots = std::vector<Turned>;

// The rotation of a shelf's pots: nine seconds a turn, paused while a finger holds one; with less motion,
// four views for four seconds each. Pure; seconds.
class TurnTable {
  public:
    // dt_s is the time since the last call. Returns 0 to 1.
    double pass(double dt_s, bool still, bool held);

  private:
    double turned_s_ = 0.0;
};

// A composition and the view it shows.
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

    // Wakes the composer.
    void ask(std::shared_ptr<const View> view);
    // Pauses the turning while a finger is on a pot.
    void hold(bool held) noexcept { held_.store(held, std::memory_order_relaxed); }
    // The current pictures of latest()'s pots; null if none turns.
    [[nodiscard]] std::shared_ptr<const TurnedPots> turned() noexcept { return turned_.latest(); }
    // The last finished composition; null before the first.
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
    // Created and used only by the composer's thread.
    std::unique_ptr<ui::Painter> painter_;
    std::unique_ptr<PaintingStore> store_;
    std::shared_ptr<const View> shown_;
    TurnTable table_;
    std::vector<std::pair<std::uint64_t, std::shared_ptr<const TurningPot>>> turning_;
    std::int64_t turned_ns_ = 0;
    double shown_turn_ = -1.0;
    jobs::IoThread thread_;
};

// The font families for these languages (BCP 47) that this machine lacks, as one line for the log, or empty.
// Creates a font map: call it before the first frame.
[[nodiscard]] std::string missing_fonts(std::span<const std::string> codes);

}  // namespace onggi::screens
