#include "game/app/kiosk/gallery/visit_journal.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace onggi::app {
namespace {

constexpr std::int64_t kSyncEveryNs = 1'000'000'000;
// About 5 ms of writing: an undo rewrites minutes of ticks, and other jobs of the thread may be waiting.
constexpr std::size_t kMostTicksACall = 40'000;

}  // namespace

Result<void> VisitJournal::give_up(const Error& error) {
    drop();
    gave_up_ = true;
    return Error{error.kind, "journal: this visit cannot be resumed: " + error.message};
}

Result<void> VisitJournal::begin(const haptic::History& history) {
    // A fresh lump: the previous pot was discarded and must not be restored.
    if (history.ticks() <= record::kHashInterval) written_.reset();
    next_.reset();
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    number_ = 1 - number_;
    auto begun =
        history.begin_session(folder_ / fmt::format("visit-{}.onggi", number_ + 1), files::Beside::kNamed);
    if (!begun) return begun.error();
    next_ = std::move(*begun);
    lineage_ = history.lineage();
    return {};
}

Result<void> VisitJournal::follow(const haptic::History& history, std::int64_t now_ns) {
    if (gave_up_ || !history.is_whole()) return {};
    if (lineage_ != history.lineage()) {
        if (auto begun = begin(history); !begun) return give_up(begun.error());
    }
    record::SessionWriter& writer = next_ ? *next_ : *written_;
    if (auto written = history.write_on(writer, kMostTicksACall); !written) return give_up(written.error());
    const bool arrived = next_ && writer.tick_count() == history.ticks() - history.first_tick();
    if (!arrived && (next_ || now_ns - synced_ns_ < kSyncEveryNs)) return {};
    synced_ns_ = now_ns;
    if (auto synced = writer.sync(); !synced) return give_up(synced.error());
    if (!arrived) return {};
    written_ = std::move(*next_);  // which deletes the older file
    next_.reset();
    return {};
}

std::filesystem::path VisitJournal::file() const {
    // Until the newer file has caught up, the older one is longer.
    const auto& longer = written_ ? written_ : next_;
    return longer ? longer->beside() : std::filesystem::path();
}

void VisitJournal::drop() noexcept {
    written_.reset();
    next_.reset();
    lineage_.reset();
    gave_up_ = false;
}

Result<void> VisitJournal::leave() {
    // Until the newer file has caught up, the older one is longer.
    auto& longer = written_ ? written_ : next_;
    Result<void> left;
    if (longer) left = longer->leave();
    drop();
    return left;
}

}  // namespace onggi::app
