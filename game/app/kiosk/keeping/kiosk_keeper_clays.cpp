// What the keeper does where one clay gives way to another: undoing, a jar's bowls, an interrupted visit and
// its drawing.
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "engine/files/read_file.h"
#include "engine/record/session_format.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/decoration/stroke_bytes.h"
#include "game/haptic/pot_copy.h"

namespace onggi::app {
namespace {

using kiosk::Event;

}  // namespace

// True while there is more of the bowls of an interrupted jar to be worked out.
bool KioskKeeper::find_interrupted_session() {
    const auto more = jar_.restore(kInterruptedSessionTicksARound);
    if (more && *more) return true;
    if (!more) complain("interrupted jar: " + more.error().message);
    has_found_ = true;
    std::vector<std::string> remarks;
    interrupted_session_ = InterruptedSession::find(visits_, jar_.start(), parameters_, remarks);
    tell_all(std::move(remarks));
    if (!interrupted_session_) interrupted_session_ = jar_.left_over();
    if (!interrupted_session_) jar_.forget();
    return false;
}

void KioskKeeper::remove_drawing() const noexcept {
    std::error_code ignored;
    std::filesystem::remove(drawing_place(), ignored);
}

std::shared_ptr<const decoration::Recorded> KioskKeeper::interrupted_drawing() {
    std::error_code ignored;
    if (!std::filesystem::exists(drawing_place(), ignored)) return nullptr;
    const auto bytes = files::read_file(drawing_place(), record::kMaxSupplementBytes);
    auto drawn = bytes ? decoration::recorded_from(std::as_bytes(std::span(*bytes)), drawing_place().string())
                       : Result<decoration::Recorded>(bytes.error());
    if (drawn) return std::make_shared<const decoration::Recorded>(std::move(*drawn));
    complain("interrupted visit: what was drawn is dropped: " + drawn.error().message);
    remove_drawing();
    return nullptr;
}

void KioskKeeper::tell_all(std::vector<std::string> remarks) {
    for (std::string& line : remarks)
        complain(std::move(line));
}

void KioskKeeper::undo() {
    tasks_.post([this] {
        if (arriving_) return;  // what it would take back is not there yet
        if (const auto tick = history_.before_last_move(); tick && *tick >= trimmed_from_.value_or(0)) {
            put_state_at(*tick);
        } else {
            answer(Event::Kind::kUndoneAll);
        }
    });
}

void KioskKeeper::begin_jar(std::string target) {
    tasks_.post([this, target = std::move(target)] { complain(jar_.begin(target)); });
}

void KioskKeeper::set_aside() {
    tasks_.post([this] {
        if (arriving_) return answer(Event::Kind::kJarStays);
        if (!history_.is_whole() || history_.state().studio() == nullptr)
            return answer(Event::Kind::kJarStays,
                          "jar: a tick's record was lost; the bowl stays on the wheel");
        auto bowl = std::make_shared<const pot::Pot>(haptic::pot_of(history_.state()));
        complain(jar_.set_aside(std::move(history_)));
        journalled_run_.reset();  // it is on the disk as a whole
        journal_.drop();
        complain(jar_.note(JarStage::kSecondBowl));
        history_ = haptic::History(start_, parameters_, {.aside = visits_});  // new clay is about to come
        answer({.what = KeeperAnswer::SetAside{std::move(bowl)}});
    });
}

void KioskKeeper::hold_together(double mouth_mm) {
    tasks_.post([this, mouth_mm] {
        const clay::StudioClay* const second = history_.state().studio();
        if (!jar_.has_bowl() || !history_.is_whole() || second == nullptr || arriving_)
            return answer(Event::Kind::kJarStays);
        const auto rims_mm = jar_.rims_mm(*second, mouth_mm);
        if (!rims_mm) return answer(Event::Kind::kRimsApart, "jar: " + rims_mm.error().message);
        answer({.what = Event{Event::Kind::kRims, kiosk::Button::kNone,
                              static_cast<int>(std::lround(*rims_mm))}});
    });
}

void KioskKeeper::join_bowls(const JarJoin& join) {
    tasks_.post([this, join] {
        if (!jar_.has_bowl() || !history_.is_whole() || arriving_) return answer(Event::Kind::kJarStays);
        auto jar = jar_.join(history_, join);
        if (!jar) return answer(Event::Kind::kJarStays, "jar: " + jar.error().message);
        if (!job_.put(std::make_unique<haptic::HapticState>(jar->state()), run_)) {
            history_ = jar_.take_back();
            return answer(Event::Kind::kJarStays);
        }
        history_ = haptic::History(start_, parameters_, {.aside = visits_});  // until the jar's is there
        arriving_ = std::move(*jar);
        answer(Event::Kind::kJoined);
    });
}

void KioskKeeper::take_back(int bowl) {
    tasks_.post([this, is_second = bowl == 2] {
        const haptic::History* const taken = jar_.to_take_back(is_second);
        if (taken == nullptr || !job_.put(std::make_unique<haptic::HapticState>(taken->state()), run_))
            return answer({.what = KeeperAnswer::NotPut{}});
        arriving_ = jar_.take_back();
    });
}

// What is on the wheel from that tick on may be of another history than what was there before.
void KioskKeeper::take_arriving(const haptic::TickRecord& record) {
    if ((record.flags & haptic::TickRecord::kFreshLump) != 0) {
        arriving_.reset();
        trimmed_from_.reset();
        if (!std::exchange(is_jar_, false)) return;
        history_ = haptic::History(start_, parameters_, {.aside = visits_});
        complain(jar_.drop_second());
    }
    const bool is_there =
        arriving_ && (record.flags & haptic::TickRecord::kStatePut) != 0 && record.tick == arriving_->ticks();
    if (!is_there) return;
    history_ = std::move(*arriving_);
    arriving_.reset();
    is_jar_ = !jar_.sessions().empty();
    complain(jar_.note(is_jar_           ? JarStage::kJar
                       : jar_.has_bowl() ? JarStage::kSecondBowl
                                         : JarStage::kFirstBowl));
    journal_.drop();  // it began with another clay
    journalled_run_ = run_;
}

}  // namespace onggi::app
