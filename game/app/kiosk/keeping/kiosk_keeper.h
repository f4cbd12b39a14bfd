// Keeps what the visitor does, and puts pots on the disk, beside the frame: it follows the haptic loop by its
// records, takes moves back, saves, journals the visit and goes on with one that was interrupted. The main
// thread asks and is answered through queues; the work is done on a thread of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/message_queue.h"
#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/app/kiosk/gallery/jar_keeping.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/kiosk_heartbeat.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/haptic/fault_report.h"
#include "game/haptic/history.h"
#include "game/haptic/job.h"
#include "game/screens/page/view.h"
#include "game/screens/pots/pot_picture.h"

namespace onggi::app {

struct KeeperAnswer {
    enum class Kind {
        kCutOff,
        kUndoneAll,
        kSetAside,
        kRims,
        kRimsApart,
        kJoined,
        kJarStays,
        kSaved,
        kSaveFailed,
        kSurvey,
        kInterruptedSession,
        kNotPut,
        kSessionWritten,
        kWall,
        kRemark
    };
    Kind kind = Kind::kRemark;
    std::shared_ptr<const clay::StudioClay> clay{};  // of a cut pot
    std::shared_ptr<const pot::Pot> pot{};  // likewise, as it is drawn on; of a bowl that was set aside
    int number = 0;                         // of a saved one, of the day; of rims, mm between them
    std::string gallery_name{};             // likewise: "2026-11-21/pot-014"
    std::filesystem::path session{};        // of one that was written
    std::shared_ptr<const std::vector<screens::ShelfPot>> wall{};  // of kWall: as it is now, the oldest first
    JarStage jar = JarStage::kNone;                                // of an interrupted session
    std::shared_ptr<const decoration::Recorded> drawn{};           // likewise; null: nothing was
    std::string jar_target{};                                      // likewise
    std::string words{};                                           // for the log
    bool is_trouble = false;                                       // what they tell of
    static constexpr std::size_t kMostPots = 1000;                 // that anybody pages through
    std::vector<std::string> pots{};                               // of a survey: the newest, newest first
    std::size_t pots_beyond = 0;                                   // likewise: how many more there are
    double free_mb = 0.0;                                          // of a survey, as all below
    std::optional<double> celsius{};
    UseOfDay use{};
};

class KioskKeeper final : private jobs::IoWork {
  public:
    // The job's state at its start, which every fresh lump is. No heartbeat: nobody asks from afar.
    KioskKeeper(haptic::HapticJob& job, const haptic::HapticState& start,
                const haptic::HapticParameters& parameters, Gallery gallery, std::filesystem::path statistics,
                std::optional<KioskHeartbeat> heartbeat = {});
    ~KioskKeeper() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Main thread; each is done on the keeper's, once all that was done to the clay up to then is known.
    // Answered by kUndoneAll where nothing is left to take back.
    void undo() {
        tasks_.post([this] { undo_now(); });
    }
    // The lump that comes is the first bowl of a jar after that pot of a museum.
    void begin_jar(std::string target) {
        tasks_.post([this, target = std::move(target)] { complain(jar_.begin(target)); });
    }
    // The bowl on the wheel is the first of a jar. Answered by kSetAside or kJarStays; new clay may come
    // then.
    void set_aside() {
        tasks_.post([this] { set_aside_now(); });
    }
    // How its rim meets that of the bowl on the wheel: kRims, or kRimsApart.
    void hold_together(double mouth_mm) {
        tasks_.post([this, mouth_mm] { hold_together_now(mouth_mm); });
    }
    // Both become one, on the wheel: kJoined, or kJarStays.
    void join_bowls(const JarJoin& join) {
        tasks_.post([this, join] { join_now(join); });
    }
    // That bowl is on the wheel again as it was: the first one, or of a jar the second. Answered by kNotPut
    // where it is not.
    void take_back(int bowl) {
        tasks_.post([this, is_second = bowl == 2] { take_back_now(is_second); });
    }
    // To two seconds before that tick. Answered by kNotPut where the clay stays as it is.
    void go_before(std::uint64_t tick) {
        tasks_.post([this, tick] { go_before_now(tick); });
    }
    // Answered by kCutOff.
    void cut_off() {
        tasks_.post([this] { cut_off_now(); });
    }
    // What was drawn on it so far, for a power cut.
    void keep_drawing(std::vector<std::byte> drawn) {
        tasks_.post([this, drawn = std::move(drawn)] { keep_drawing_now(drawn); });
    }
    // Undoing goes no further back from here on, until other clay comes.
    void begin_trim() {
        tasks_.post([this] { trimmed_from_ = history_.ticks(); });
    }
    // All that was done to the pot that was cut off last, as a session at that place; answered by
    // kSessionWritten where it is known.
    void write_session(std::filesystem::path place) {
        tasks_.post([this, place = std::move(place)] { write_session_now(place); });
    }
    // Answered by kSaved or kSaveFailed.
    void save(std::shared_ptr<const pot::Section> shape, int glaze) {
        tasks_.post([this, shape = std::move(shape), glaze] { save_now(shape.get(), glaze); });
    }
    // A kept pot to the wall of the day, or down from there; all of them. Answered by kWall, as is the start
    // and the end of a day.
    void put_on_wall(WallPot pot) {
        tasks_.post([this, pot = std::move(pot)] { show_wall(wall_.put(pot, today())); });
    }
    void take_off_wall(std::string pot) {
        tasks_.post([this, pot = std::move(pot)] { show_wall(wall_.take(pot)); });
    }
    void clear_wall() {
        tasks_.post([this] { show_wall(wall_.clear()); });
    }
    void forget() {
        tasks_.post([this] { forget_now(); });
    }
    // A visit throws that lump, counted as Snapshot::run counts: it is journalled until forget(), or until
    // its pot is saved.
    void journal(std::uint64_t run) {
        tasks_.post([this, run] { journal_now(run); });
    }
    // Puts the pot of the interrupted visit on the wheel (after kInterruptedSession was answered) and goes on
    // with its journal.
    void resume(std::uint64_t run) {
        tasks_.post([this, run] { resume_now(run); });
    }
    void drop_interrupted_session() {
        tasks_.post([this] { drop_interrupted_session_now(); });
    }
    // Answered by kSurvey: what the gallery holds, what the disk has left, how warm it is, the day's use.
    void survey() {
        tasks_.post([this] { survey_now(); });
    }
    void remove(std::string pot) {
        tasks_.post([this, pot = std::move(pot)] { remove_now(pot); });
    }
    void note(const VisitNote& visit) {
        tasks_.post([this, visit] { complain(note_visit(statistics_, visit)); });
    }
    void note_attract_break() {
        tasks_.post([this] { complain(app::note_attract_break(statistics_)); });
    }
    void note_start() {
        tasks_.post([this] { complain(app::note_start(statistics_)); });
    }
    // The house's monitoring is told; every KioskHeartbeat::kEveryS.
    void beat(KioskPulse pulse) {
        tasks_.post([this, pulse = std::move(pulse)] { beat_now(pulse); });
    }
    // What the staff has set, for the next start.
    void keep(HouseDefaults house) {
        tasks_.post([this, house = std::move(house)] { complain(keep_house(statistics_, house)); });
    }
    // Null: nothing is answered yet.
    [[nodiscard]] std::shared_ptr<const KeeperAnswer> next_answer() { return answers_.next(); }

  private:
    // A few ms of an interrupted visit, so that the one that goes on is followed too.
    static constexpr int kInterruptedSessionTicksARound = 2000;

    // The keeper's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;
    bool follow();
    bool work_out_interrupted_session();
    bool find_interrupted_session();
    void tell_all(std::vector<std::string> remarks);
    void write_journal(std::int64_t now_ns);
    void resume_now(std::uint64_t run);
    void end_journal();
    void go_before_now(std::uint64_t tick);
    void cut_off_now();
    void keep_drawing_now(const std::vector<std::byte>& drawn);
    void forget_now();
    void journal_now(std::uint64_t run);
    void drop_interrupted_session_now();
    void beat_now(const KioskPulse& pulse);
    void put_state_at(std::uint64_t tick);
    [[nodiscard]] std::filesystem::path drawing_place() const { return visits_ / "drawing"; }
    void remove_drawing() const noexcept;
    void remove_interrupted_session();
    [[nodiscard]] std::shared_ptr<const decoration::Recorded> interrupted_drawing();
    void undo_now();
    void set_aside_now();
    void hold_together_now(double mouth_mm);
    void join_now(const JarJoin& join);
    void take_back_now(bool is_second);
    void take_arriving(const haptic::TickRecord& record);
    void look_at_the_wall(std::int64_t now_ns);
    void show_wall(const Result<void>& changed);
    void write_session_now(const std::filesystem::path& place);
    void save_now(const pot::Section* shape, int glaze);
    void survey_now();
    void remove_now(const std::string& name);
    void answer(KeeperAnswer answer) { answers_.post(std::move(answer)); }
    void complain(std::string words);
    void complain(const Result<void>& done);

    haptic::HapticJob& job_;
    haptic::History history_;
    haptic::FaultReport faults_;
    haptic::HapticState start_;
    haptic::HapticParameters parameters_;
    std::filesystem::path visits_;  // where journals are
    VisitJournal journal_;
    std::optional<std::uint64_t> journalled_run_;
    std::uint64_t run_ = 0;                                    // of the last record
    std::unique_ptr<InterruptedSession> interrupted_session_;  // until it is on the wheel
    bool has_looked_ = false;
    bool has_found_ = false;
    bool is_worked_out_ = false;
    bool is_put_ = false;                        // its state is on the way to the wheel
    bool was_resumed_ = false;                   // and is not in the new journal yet
    std::optional<std::uint64_t> trimmed_from_;  // the tick
    JarKeeping jar_;
    std::optional<haptic::History> arriving_;  // of the jar's; goes on once its state is on the wheel
    bool is_jar_ = false;                      // what history_ is of began as two bowls
    Gallery gallery_;
    std::string gallery_trouble_;  // as it was told last
    std::filesystem::path statistics_;
    std::optional<KioskHeartbeat> heartbeat_;
    WallOfTheDay wall_;
    std::optional<std::int64_t> looked_at_wall_ns_;
    std::shared_ptr<const clay::StudioClay> cut_;
    jobs::TaskQueue tasks_{64};
    jobs::MessageQueue<KeeperAnswer> answers_{64};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
