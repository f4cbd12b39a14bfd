#include "game/app/replay/film_thread.h"

#include <utility>

#include "engine/jobs/thread_setup.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kNothingToDoNs = 1'000'000'000;

}  // namespace

Result<void> FilmThread::begin(record::Session session, haptic::Start start, const FilmDesc& desc) {
    cancel();
    order_ = std::make_unique<Order>(Order{std::move(session), std::move(start), desc});
    return thread_.start(*this, "film");
}

void FilmThread::cancel() noexcept {
    thread_.stop();
    order_.reset();
    share_made_.store(0.0, std::memory_order_relaxed);
    std::shared_ptr<const Film> dropped;
    while (films_.try_pop(dropped)) {
    }
}

std::shared_ptr<const FilmThread::Film> FilmThread::next_film() {
    std::shared_ptr<const Film> film;
    return films_.try_pop(film) ? film : nullptr;
}

// One slice; the film when that was the last.
std::optional<FilmThread::Film> FilmThread::go_on() {
    if (!maker_) {
        jobs::let_others_go_first();  // before Vulkan starts workers, which do the same then
        const auto order = std::exchange(order_, nullptr);
        auto maker = FilmMaker::create(std::move(order->session), std::move(order->start), order->desc);
        if (!maker) return Film(maker.error());
        maker_ = std::move(maker).value();
        return std::nullopt;
    }
    const Result<bool> more = maker_->work();
    if (!more) return Film(more.error());
    share_made_.store(
        static_cast<double>(maker_->pictures_drawn()) / static_cast<double>(maker_->picture_count()),
        std::memory_order_relaxed);
    if (*more) return std::nullopt;
    return maker_->take();
}

std::int64_t FilmThread::round(std::int64_t /*now_ns*/) noexcept {
    if (!maker_ && !order_) return kNothingToDoNs;
    auto film = go_on();
    if (!film) return 0;
    maker_.reset();
    static_cast<void>(films_.try_push(std::make_shared<const Film>(std::move(*film))));
    return kNothingToDoNs;
}

}  // namespace onggi::app
