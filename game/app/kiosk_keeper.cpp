#include "game/app/kiosk_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/app/kiosk_pot.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kLookEveryNs = 4'000'000;
constexpr double kBeforeCollapseS = 2.0;
constexpr int kMostRecordsARound = 4000;
constexpr int kPortraitPx = 1024;

}  // namespace

KioskKeeper::KioskKeeper(haptic::HapticJob& job, const haptic::HapticState& start,
                         const haptic::HapticParameters& parameters, Gallery gallery,
                         std::filesystem::path statistics)
    : job_(job),
      history_(start, parameters),
      faults_(gallery.folder() / "faults"),
      rate_hz_(parameters.rate_hz()),
      gallery_(std::move(gallery)),
      statistics_(std::move(statistics)) {}

Result<void> KioskKeeper::start() {
    return thread_.start(*this, "keeper");
}

void KioskKeeper::save(std::shared_ptr<const screens::PotShape> shape, int glaze) {
    ask({Wish::Kind::kSave, 0, glaze, std::move(shape)});
}

std::shared_ptr<const KeeperAnswer> KioskKeeper::next_answer() {
    std::shared_ptr<const KeeperAnswer> next;
    return answers_.try_pop(next) ? next : nullptr;
}

void KioskKeeper::answer(KeeperAnswer answer) {
    static_cast<void>(answers_.try_push(std::make_shared<const KeeperAnswer>(std::move(answer))));
}

std::int64_t KioskKeeper::round(std::int64_t) noexcept {
    const bool more = follow();
    Wish wish;
    while (wishes_.try_pop(wish))
        obey(wish);
    return more ? 0 : kLookEveryNs;
}

// True when more records wait.
bool KioskKeeper::follow() {
    haptic::BlockHash hash;
    while (job_.take_hash(hash)) {
    }
    haptic::TickRecord record;
    for (int count = 0; count < kMostRecordsARound; ++count) {
        if (!job_.take_record(record)) return false;
        history_.add(record);
        // What cannot be kept is no reason to stop the wheel.
        const auto report = faults_.look(record, history_);
        if (report && *report)
            answer({.kind = KeeperAnswer::Kind::kRemark,
                    .words = fmt::format("fault: kept as {}, which onggi replay works out again",
                                         (*report)->string())});
    }
    return true;
}

void KioskKeeper::put_state_at(std::uint64_t tick) {
    if (!history_.is_whole()) {
        answer({.kind = KeeperAnswer::Kind::kRemark,
                .words = "undo: a tick's record was lost; new clay is needed"});
        return;
    }
    static_cast<void>(job_.put(std::make_unique<haptic::HapticState>(history_.state_at(tick))));
}

void KioskKeeper::obey(const Wish& wish) {
    // What was done up to now has to be known before it is taken back.
    while (follow()) {
    }
    switch (wish.kind) {
        case Wish::Kind::kUndo:
            if (const auto tick = history_.before_last_move()) put_state_at(*tick);
            break;
        case Wish::Kind::kBefore: {
            const auto back = static_cast<std::uint64_t>(kBeforeCollapseS * rate_hz_);
            const std::uint64_t until = std::min(wish.tick, history_.ticks());
            put_state_at(until > back ? until - back : 0);
            break;
        }
        case Wish::Kind::kCutOff:
            if (const clay::StudioClay* clay = history_.state().studio()) {
                cut_ = std::make_shared<const clay::StudioClay>(*clay);
                answer({.kind = KeeperAnswer::Kind::kCutOff, .clay = cut_});
            }
            break;
        case Wish::Kind::kSave:
            save_now(wish);
            break;
        case Wish::Kind::kForget:
            cut_.reset();
            break;
        case Wish::Kind::kSurvey:
            survey_now();
            break;
        case Wish::Kind::kRemove:
            remove_now(*wish.pot);
            break;
        case Wish::Kind::kNote:
            if (const auto noted = note_visit(statistics_, wish.visit); !noted)
                answer({.kind = KeeperAnswer::Kind::kRemark, .words = noted.error().message});
            break;
    }
}

void KioskKeeper::survey_now() {
    KeeperAnswer found{.kind = KeeperAnswer::Kind::kSurvey, .free_mb = gallery_.free_mb()};
    for (const KeptPot& pot : gallery_.pots())
        found.pots.push_back(pot.name);
    answer(std::move(found));
}

void KioskKeeper::remove_now(const std::string& name) {
    for (const KeptPot& pot : gallery_.pots()) {
        if (pot.name != name) continue;
        const auto removed = gallery_.remove(pot);
        answer({.kind = KeeperAnswer::Kind::kRemark,
                .words = removed ? "removed " + name : removed.error().message});
    }
    survey_now();
}

void KioskKeeper::save_now(const Wish& wish) {
    if (!cut_ || !wish.shape) return;
    const PotToKeep pot{.history = &history_,
                        .clay = cut_.get(),
                        .glaze = &finish::glaze_at(wish.glaze),
                        .portrait = portrait(*wish.shape, wish.glaze, kPortraitPx)};
    const auto number = gallery_.keep(pot, today());
    if (number) {
        answer({.kind = KeeperAnswer::Kind::kSaved,
                .number = *number,
                .words = fmt::format(
                    "kept {}", (gallery_.folder() / today() / fmt::format("pot-{:03}", *number)).string())});
    } else {
        answer({.kind = KeeperAnswer::Kind::kSaveFailed, .words = number.error().message});
    }
}

}  // namespace onggi::app
