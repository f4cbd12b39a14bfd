// A film made beside the frame, by a thread to which everybody else goes first: while the pot dries and is
// fired, say. Every method belongs to the one thread that owns the object; none of them waits for the film.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/spsc_ring.h"
#include "game/app/replay/film.h"

namespace onggi::app {

// What it costs at 480 x 360, drawn quickly, on one core of a Zen 3 EPYC: a second until the first picture,
// 70 ms for each, and until it is made 42 MB of memory and 35 MB of the software Vulkan's code; all of it is
// given back after jobs::give_back_freed_memory() and give_back_code().
class FilmThread final : private jobs::IoWork {
  public:
    using Film = Result<std::vector<std::byte>>;

    FilmThread() = default;
    ~FilmThread() override { cancel(); }

    // Ends the film that is being made, if any, and begins this one. kFailed: no thread can be made.
    Result<void> begin(record::Session session, haptic::Start start, const FilmDesc& desc);
    // Waits for the picture that is being drawn, or for the first one's room; nothing comes of the film.
    void cancel() noexcept;

    [[nodiscard]] double share_made() const { return share_made_.load(std::memory_order_relaxed); }  // 0 to 1
    // The film or why there is none, once; null: not yet.
    [[nodiscard]] std::shared_ptr<const Film> next_film();

  private:
    struct Order {
        record::Session session;
        haptic::Start start;
        FilmDesc desc;
    };
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override { maker_.reset(); }
    [[nodiscard]] std::optional<Film> go_on();

    std::unique_ptr<Order> order_;      // the film's thread, once it runs
    std::unique_ptr<FilmMaker> maker_;  // likewise
    std::atomic<double> share_made_ = 0.0;
    jobs::SpscRing<std::shared_ptr<const Film>> films_{2};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
