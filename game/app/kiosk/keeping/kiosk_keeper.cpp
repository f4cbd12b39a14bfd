#include "game/app/kiosk/keeping/kiosk_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "engine/core/within_memory.h"
#include "engine/files/atomic_file.h"
#include "engine/files/atomic_folder.h"
#include "engine/files/read_file.h"
#include "engine/jobs/thread_setup.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/kiosk/health/kiosk_health.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/app/system/crash_report.h"
#include "game/app/system/wall_clock.h"
#include "game/decoration/stroke.h"
#include "game/haptic/pot_copy.h"
#include "game/record/session_format.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kLookEveryNs = 20'000'000;  // at the loop's records; a task wakes the keeper
constexpr double kBeforeCollapseS = 2.0;
constexpr int kMostRecordsARound = 4000;
constexpr int kPortraitPx = 1024;

// Returns freed memory to the system when a visit goes on to another kind of work.
void give_back_memory() {
    jobs::give_back_freed_memory();
    jobs::give_back_code();
}

namespace event = kiosk::event;

}  // namespace

KioskKeeper::KioskKeeper(haptic::HapticJob& job, const haptic::HapticState& start,
                         const haptic::HapticParameters& parameters, Gallery gallery,
                         std::filesystem::path statistics, std::optional<KioskHeartbeat> heartbeat)
    : job_(job),
      history_(start, parameters, {.aside = state_folder(gallery.folder())}),
      faults_(faults_folder(gallery.folder())),
      start_(start),
      parameters_(parameters),
      visits_(state_folder(gallery.folder())),
      journal_(visits_),
      jar_(visits_, start, parameters),
      gallery_(std::move(gallery)),
      statistics_(std::move(statistics)),
      heartbeat_(std::move(heartbeat)),
      wall_(visits_ / "wall.json") {}

Result<void> KioskKeeper::start() {
    return thread_.start(*this, "keeper");
}

std::int64_t KioskKeeper::round(std::int64_t now_ns) noexcept {
    const bool more = follow();
    while (const auto task = tasks_.next()) {
        // Takes all records first, so that the undo starts from the current state.
        while (follow()) {
        }
        (*task)();
    }
    const bool works = work_out_interrupted_session();
    write_journal(now_ns);
    crash_leads_to(journal_.file(), faults_folder(gallery_.folder()));
    look_at_the_wall(now_ns);
    return more || works ? 0 : kLookEveryNs;
}

void KioskKeeper::ask(std::function<void()> task) {
    tasks_.post(std::move(task));
    thread_.wake();
}

void KioskKeeper::finish() noexcept {
    // Takes the visitor's last records from the ring.
    while (follow()) {
    }
    write_journal(0);
    if (const auto left = journal_.leave(); !left) complain(left);
    if (heartbeat_) complain(heartbeat_->end(wall_clock_s()));
}

// Returns true if more records are waiting.
bool KioskKeeper::follow() {
    haptic::TickRecord record;
    for (int count = 0; count < kMostRecordsARound; ++count) {
        if (!job_.take_record(record)) return false;
        run_ = record.run;
        const bool is_resumed = is_put_ && (record.flags & haptic::TickRecord::kStatePut) != 0 &&
                                record.tick == interrupted_session_->history().ticks();
        if (is_resumed) {
            history_ = std::move(interrupted_session_->history());
            interrupted_session_.reset();
            is_put_ = false;
        }
        take_arriving(record);
        history_.add(record);
        // A fault's session that cannot be kept does not stop the wheel.
        const auto report = faults_.look(record, history_);
        if (report && *report)
            complain(fmt::format("fault: session kept as {}, for onggi replay", (*report)->string()));
    }
    return true;
}

// Returns true while there is more work.
bool KioskKeeper::work_out_interrupted_session() {
    if (!has_looked_) {
        has_looked_ = true;
        gallery_.clear_parts();
        files::clear_parts(statistics_);  // may be elsewhere
        std::vector<std::string> remarks;
        const auto looked = jar_.look(remarks);
        // A visit that belongs to a jar that is not read is left alone.
        has_found_ = !looked;
        complain(looked);
        tell_all(std::move(remarks));
    }
    if (!has_found_ && find_interrupted_session()) return true;
    if (!interrupted_session_ || is_worked_out_) return false;
    const auto more = interrupted_session_->work(kInterruptedSessionTicksARound);
    if (more && *more) return true;
    is_worked_out_ = true;
    if (more && (interrupted_session_->is_worth_it() || jar_.has_bowl())) {
        answer({.what = KeeperAnswer::Interrupted{.bowl = jar_.has_bowl() ? std::make_shared<const pot::Pot>(
                                                                                haptic::pot_of(jar_.bowl()))
                                                                          : nullptr,
                                                  .jar = jar_.stage(),
                                                  .jar_target = jar_.target(),
                                                  .drawn = interrupted_drawing(),
                                                  .place = interrupted_place(),
                                                  .pot = std::make_shared<const pot::Pot>(haptic::pot_of(
                                                      interrupted_session_->history().state()))},
                .words = fmt::format("interrupted visit: {:.1f} s of throwing can be resumed",
                                     interrupted_session_->seconds())});
        return false;
    }
    if (!more) {
        complain(more.error().message);
        InterruptedSession::set_aside(visits_);
    }
    remove_interrupted_session();
    return false;
}

void KioskKeeper::remove_interrupted_session() {
    interrupted_session_.reset();
    InterruptedSession::remove(visits_);
    remove_drawing();
    remove_place(visits_);
    jar_.forget();
}

void KioskKeeper::write_journal(std::int64_t now_ns) {
    if (!journalled_run_ || run_ != *journalled_run_ || is_put_) return;
    if (const auto written = journal_.follow(history_, now_ns); !written) complain(written);
    // The journal now contains the resumed visit.
    if (was_resumed_ && journal_.has_caught_up()) {
        was_resumed_ = false;
        InterruptedSession::remove(visits_);
    }
}

// Ends the journal when the pot is on the shelf or the visitor has left.
void KioskKeeper::end_journal() {
    journalled_run_.reset();
    journal_.drop();
    remove_drawing();
    remove_place(visits_);
    if (!std::exchange(was_resumed_, false)) return;
    is_put_ = false;
    interrupted_session_.reset();
    InterruptedSession::remove(visits_);
}

void KioskKeeper::resume(std::uint64_t run) {
    ask([this, run] {
        if (!interrupted_session_ || !is_worked_out_ ||
            !job_.put(std::make_unique<haptic::HapticState>(interrupted_session_->history().state()), run))
            return answer({.what = KeeperAnswer::NotPut{}});
        is_put_ = true;
        was_resumed_ = true;
        is_jar_ = !jar_.sessions().empty();
        journal_.drop();
        journalled_run_ = run;
    });
}

void KioskKeeper::put_state_at(std::uint64_t tick) {
    if (!history_.is_whole())
        return answer(
            {.what = KeeperAnswer::NotPut{}, .words = "undo: a tick's record was lost; new clay is needed"});
    auto state = history_.state_at(tick);
    if (!state || !job_.put(std::make_unique<haptic::HapticState>(std::move(*state)), run_))
        answer({.what = KeeperAnswer::NotPut{}, .words = state ? "" : state.error().message});
}

void KioskKeeper::go_before(std::uint64_t tick) {
    ask([this, tick] {
        const auto back = static_cast<std::uint64_t>(kBeforeCollapseS * parameters_.rate_hz());
        const std::uint64_t until = std::min(tick, history_.ticks());
        put_state_at(until > back ? until - back : 0);
    });
}

void KioskKeeper::cut_off() {
    ask([this] {
        give_back_memory();  // of throwing and of the view into the pot
        const clay::StudioClay* const clay = history_.state().studio();
        if (clay == nullptr) return;
        cut_ = std::make_shared<const clay::StudioClay>(*clay);
        answer({.what = KeeperAnswer::CutOff{
                    cut_, std::make_shared<const pot::Pot>(haptic::pot_of(history_.state()))}});
    });
}

// Drops the decoration of a saved pot, or of a visitor who has left.
void KioskKeeper::keep_drawing(std::vector<std::byte> drawn) {
    ask([this, drawn = std::move(drawn)] {
        if (journalled_run_) complain(files::write_file_atomically(drawing_place(), drawn));
    });
}

void KioskKeeper::keep_place(VisitPlace place) {
    ask([this, place = std::move(place)] {
        if (journalled_run_) complain(write_place(visits_, place));
    });
}

void KioskKeeper::forget() {
    ask([this] {
        cut_.reset();
        end_journal();
        arriving_.reset();
        jar_.forget();
        give_back_memory();  // of the last visit
    });
}

void KioskKeeper::journal(std::uint64_t run) {
    ask([this, run] {
        is_put_ = false;  // if it is still on its way, the new lump overtook it
        journalled_run_ = run;
        give_back_memory();  // of the previous screens
    });
}

void KioskKeeper::drop_interrupted_session() {
    ask([this] {
        is_put_ = false;
        remove_interrupted_session();
    });
}

void KioskKeeper::begin_trim() {
    ask([this] { trimmed_from_ = history_.ticks(); });
}

void KioskKeeper::note(const VisitNote& visit) {
    ask([this, visit] { complain(note_visit(statistics_, visit)); });
}

void KioskKeeper::note_attract_break() {
    ask([this] { complain(app::note_attract_break(statistics_)); });
}

void KioskKeeper::note_start() {
    ask([this] { complain(app::note_start(statistics_)); });
}

void KioskKeeper::beat(KioskPulse pulse) {
    ask([this, pulse = std::move(pulse)] {
        look_at_the_gallery();
        if (heartbeat_) complain(heartbeat_->beat(pulse, wall_clock_s()));
    });
}

void KioskKeeper::keep(HouseDefaults house) {
    ask([this, house = std::move(house)] { complain(keep_house(statistics_, house)); });
}

void KioskKeeper::complain(std::string words) {
    answer({.words = std::move(words), .is_trouble = true});
}

// A failed write is only reported.
void KioskKeeper::complain(const Result<void>& done) {
    if (!done) complain(done.error().message);
}

// Reports an unplugged disk or moved folder once each time it disappears.
void KioskKeeper::look_at_the_gallery() {
    std::error_code error;
    const bool is_there = std::filesystem::exists(gallery_.folder(), error);
    if (std::exchange(gallery_was_there_, is_there) && !is_there)
        complain(gallery_.folder().string() +
                 ": expected the folder of the pots, found none; the next pot begins a new one");
}

void KioskKeeper::answer_survey() {
    look_at_the_gallery();
    KeeperAnswer::Survey found{
        .free_mb = gallery_.free_mb(), .celsius = hottest_celsius(), .use = use_of(statistics_, today())};
    std::string trouble;
    std::vector<KeptPot> pots = gallery_.pots(&trouble);
    if (pots.size() > found.kMostPots) {
        found.pots_beyond = pots.size() - found.kMostPots;
        pots.resize(found.kMostPots);
    }
    for (KeptPot& pot : pots)
        found.pots.push_back(std::move(pot.name));
    // Reports an error once, not with every survey.
    if (trouble != gallery_trouble_ && !trouble.empty()) complain("gallery: " + trouble);
    gallery_trouble_ = std::move(trouble);
    answer({.what = std::move(found)});
}

void KioskKeeper::survey() {
    ask([this] { answer_survey(); });
}

void KioskKeeper::remove(std::string pot) {
    ask([this, name = std::move(pot)] {
        show_wall(wall_.take(name));
        for (const KeptPot& kept : gallery_.pots()) {
            if (kept.name != name) continue;
            const auto removed = gallery_.remove(kept);
            answer({.words = removed ? "removed " + name : removed.error().message});
        }
        answer_survey();
    });
}

// At the start, restores the day's wall; later, watches for midnight.
void KioskKeeper::look_at_the_wall(std::int64_t now_ns) {
    constexpr std::int64_t kEveryNs = 60'000'000'000;
    if (looked_at_wall_ns_ && now_ns - *looked_at_wall_ns_ < kEveryNs) return;
    const bool is_first = !looked_at_wall_ns_;
    looked_at_wall_ns_ = now_ns;
    if (is_first) {
        show_wall(wall_.open(today()));
    } else if (wall_.day() != today()) {
        show_wall(wall_.turn_to(today()));
    }
}

// Shows the change even if writing it failed.
void KioskKeeper::show_wall(const Result<void>& changed) {
    complain(changed);
    auto seen = std::make_shared<std::vector<screens::ShelfPot>>();
    for (const WallPot& pot : wall_.pots())
        seen->push_back({pot.shape, pot.glaze});
    answer({.what = KeeperAnswer::Wall{std::move(seen)}});
}

void KioskKeeper::put_on_wall(WallPot pot) {
    ask([this, pot = std::move(pot)] { show_wall(wall_.put(pot, today())); });
}

void KioskKeeper::take_off_wall(std::string pot) {
    ask([this, pot = std::move(pot)] { show_wall(wall_.take(pot)); });
}

void KioskKeeper::clear_wall() {
    ask([this] { show_wall(wall_.clear()); });
}

void KioskKeeper::write_session(std::filesystem::path place) {
    ask([this, place = std::move(place)] {
        if (!cut_ || !history_.is_whole()) return;
        if (const auto saved = history_.save(place); !saved) return complain(saved);
        answer({.what = KeeperAnswer::SessionWritten{place}});
    });
}

void KioskKeeper::save(std::shared_ptr<const pot::Section> shape, int glaze, exporter::PotStory story) {
    ask([this, shape = std::move(shape), glaze, story = std::move(story)] {
        if (!cut_ || shape == nullptr) return;
        history_.let_go_of_states();  // a fired pot cannot be undone
        give_back_memory();
        const std::string day = today();
        const auto number = within_memory("gallery", [&] {
            PotToKeep pot{.history = &history_,
                          .clay = cut_.get(),
                          .glaze = &finish::glaze_at(glaze),
                          .portrait = portrait(*shape, glaze, kPortraitPx),
                          .marks = shape->marks,
                          .bowls = is_jar_ ? jar_.sessions() : std::vector<std::filesystem::path>(),
                          .story = story};
            return gallery_.keep(std::move(pot), day);
        });
        if (number) {
            end_journal();
            jar_.forget();
            const std::string name = fmt::format("{}/pot-{:03}", day, *number);
            if (files::folder_sync_was_refused() && !std::exchange(has_said_unsynced_, true))
                complain(gallery_.folder().string() +
                         ": this file system does not sync folders; "
                         "a power cut may lose the pots kept last");
            answer({.what = KeeperAnswer::Saved{*number, name},
                    .words = fmt::format("kept {}", (gallery_.folder() / name).string())});
        } else {
            answer({.what = kiosk::Event{event::SaveFailed{}},
                    .words = number.error().message,
                    .is_trouble = true});
        }
        give_back_memory();  // of making the files
    });
}

// Operations that replace the clay: undo, a jar's bowls, an interrupted visit and its decoration.

// Returns true while bowls of an interrupted jar are still to be replayed.
bool KioskKeeper::find_interrupted_session() {
    const auto more = jar_.restore(kInterruptedSessionTicksARound);
    if (more && *more) return true;
    if (!more) complain("interrupted jar: " + more.error().message);
    has_found_ = true;
    if (!more && jar_.stage() != JarStage::kNone) return false;  // may be read at the next start
    std::vector<std::string> remarks;
    interrupted_session_ = InterruptedSession::find(visits_, jar_.start(), parameters_, remarks);
    tell_all(std::move(remarks));
    if (interrupted_session_) return false;
    auto left_over = jar_.left_over();
    if (!left_over) {
        complain("interrupted jar: " + left_over.error().message);
        return false;
    }
    interrupted_session_ = std::move(*left_over);
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
    complain("interrupted visit: decoration dropped: " + drawn.error().message);
    if (drawn.error().kind == ErrorKind::kBadInput) remove_drawing();
    return nullptr;
}

// One that cannot be read costs the visitor the choices, but not the pot.
VisitPlace KioskKeeper::interrupted_place() {
    const auto place = read_place(visits_);
    if (!place) complain("interrupted visit: choices dropped: " + place.error().message);
    return place ? *place : VisitPlace{};
}

void KioskKeeper::tell_all(std::vector<std::string> remarks) {
    for (std::string& line : remarks)
        complain(std::move(line));
}

void KioskKeeper::undo() {
    ask([this] {
        if (arriving_) return;  // the clay to undo has not arrived yet
        if (const auto tick = history_.before_last_move(); tick && *tick >= trimmed_from_.value_or(0)) {
            put_state_at(*tick);
        } else {
            answer_by(event::UndoneAll{});
        }
    });
}

void KioskKeeper::begin_jar(std::string target) {
    ask([this, target = std::move(target)] { complain(jar_.begin(target)); });
}

void KioskKeeper::set_aside() {
    ask([this] {
        if (arriving_) return answer_by(event::JarStays{});
        if (!history_.is_whole() || history_.state().studio() == nullptr)
            return answer_by(event::JarStays{}, "jar: a tick's record was lost; the bowl stays on the wheel");
        auto bowl = std::make_shared<const pot::Pot>(haptic::pot_of(history_.state()));
        complain(jar_.set_aside(std::move(history_)));
        journalled_run_.reset();  // it is complete on the disk
        journal_.drop();
        complain(jar_.note(JarStage::kSecondBowl));
        history_ = haptic::History(start_, parameters_, {.aside = visits_});  // new clay comes next
        answer({.what = KeeperAnswer::SetAside{std::move(bowl)}});
    });
}

void KioskKeeper::hold_together(double mouth_mm) {
    ask([this, mouth_mm] {
        const clay::StudioClay* const second = history_.state().studio();
        if (!jar_.has_bowl() || !history_.is_whole() || second == nullptr || arriving_)
            return answer_by(event::JarStays{});
        const auto rims_mm = jar_.rims_mm(*second, mouth_mm);
        if (!rims_mm) return answer_by(event::RimsApart{}, "jar: " + rims_mm.error().message);
        answer_by(event::Rims{static_cast<int>(std::lround(*rims_mm))});
    });
}

void KioskKeeper::join_bowls(const JarJoin& join) {
    ask([this, join] {
        if (!jar_.has_bowl() || !history_.is_whole() || arriving_) return answer_by(event::JarStays{});
        auto jar = jar_.join(history_, join);
        if (!jar) return answer_by(event::JarStays{}, "jar: " + jar.error().message);
        if (!job_.put(std::make_unique<haptic::HapticState>(jar->state()), run_)) {
            history_ = jar_.take_back();
            return answer_by(event::JarStays{});
        }
        history_ = haptic::History(start_, parameters_, {.aside = visits_});  // until the jar's arrives
        arriving_ = std::move(*jar);
        answer_by(event::Joined{});
    });
}

void KioskKeeper::take_back(int bowl) {
    ask([this, is_second = bowl == 2] {
        const haptic::History* const taken = jar_.to_take_back(is_second);
        if (taken == nullptr || !job_.put(std::make_unique<haptic::HapticState>(taken->state()), run_))
            return answer({.what = KeeperAnswer::NotPut{}});
        arriving_ = jar_.take_back();
    });
}

// From that tick on the clay on the wheel may belong to another history.
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
    journal_.drop();  // the old journal began with another clay
    journalled_run_ = run_;
}

}  // namespace onggi::app
