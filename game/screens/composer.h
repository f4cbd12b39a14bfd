// Composes and paints screens beside the frame: a first label costs tens of milliseconds, and a pot as many.
// The newest wish wins; what lies between is never painted. Main thread, except where it says otherwise.
#pragma once

#include <atomic>
#include <memory>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"
#include "engine/ui/painter.h"
#include "game/screens/composition.h"
#include "game/screens/page.h"
#include "game/screens/view.h"

namespace onggi::screens {

// A composition and what it was made from.
struct Composed {
    std::shared_ptr<const View> view;
    Composition composition;
};

class Composer final : private jobs::IoWork {
  public:
    Composer() = default;
    ~Composer() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Wait-free.
    void ask(std::shared_ptr<const View> view) noexcept { wishes_.put(view); }
    // The last one finished; null before the first.
    [[nodiscard]] std::shared_ptr<const Composed> latest() noexcept { return done_.latest(); }

  private:
    // The composer's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;

    jobs::Mailbox<std::shared_ptr<const View>> wishes_;
    jobs::Mailbox<std::shared_ptr<const Composed>> done_;
    // Made and used by the composer's thread alone.
    std::unique_ptr<ui::Painter> painter_;
    std::unique_ptr<PaintingStore> store_;
    std::shared_ptr<const View> shown_;
    jobs::IoThread thread_;
};

// The families that the design asks for and this machine lacks, as one line for the log; empty: none. Costs
// a font map: before the frame begins.
[[nodiscard]] std::string missing_fonts();

}  // namespace onggi::screens
