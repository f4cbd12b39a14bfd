// Keeps what the visitor does, and puts pots on the disk, beside the frame: it follows the haptic loop by its
// records, takes moves back, saves, journals the visit and goes on with one that was interrupted. Asked and
// answered by the main thread through rings; the work is done on a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/spsc_ring.h"
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
#include "game/screens/pot_picture.h"
#include "game/screens/view.h"

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

    // Main thread, wait-free.
    // Answered by kUndoneAll where nothing is left to take back.
    void undo() { ask({Request::Kind::kUndo}); }
    // The lump that comes is the first bowl of a jar after that pot of a museum.
    void begin_jar(std::string target) {
        ask({.kind = Request::Kind::kBeginJar,
             .pot = std::make_shared<const std::string>(std::move(target))});
    }
    // The bowl on the wheel is the first of a jar. Answered by kSetAside or kJarStays; new clay may come
    // then.
    void set_aside() { ask({Request::Kind::kSetAside}); }
    // How its rim meets that of the bowl on the wheel: kRims, or kRimsApart.
    void hold_together(double mouth_mm) {
        ask({.kind = Request::Kind::kHoldTogether, .join = {.mouth_mm = mouth_mm}});
    }
    // Both become one, on the wheel: kJoined, or kJarStays.
    void join_bowls(const JarJoin& join) { ask({.kind = Request::Kind::kJoinBowls, .join = join}); }
    // That bowl is on the wheel again as it was: the first one, or of a jar the second. Answered by kNotPut
    // where it is not.
    void take_back(int bowl) {
        ask({.kind = Request::Kind::kTakeBack, .number = static_cast<std::uint64_t>(bowl)});
    }
    // To two seconds before that tick. Answered by kNotPut where the clay stays as it is.
    void go_before(std::uint64_t tick) { ask({Request::Kind::kBefore, tick}); }
    void cut_off() { ask({Request::Kind::kCutOff}); }
    // What was drawn on it so far, for a power cut.
    void keep_drawing(std::vector<std::byte> drawn) {
        ask({.kind = Request::Kind::kKeepDrawing,
             .drawn = std::make_shared<const std::vector<std::byte>>(std::move(drawn))});
    }
    // Undoing goes no further back from here on, until other clay comes.
    void begin_trim() { ask({Request::Kind::kBeginTrim}); }
    // All that was done to the pot that was cut off last, as a session at that place; answered by
    // kSessionWritten where it is known.
    void write_session(std::filesystem::path place) {
        ask({.kind = Request::Kind::kWriteSession,
             .place = std::make_shared<const std::filesystem::path>(std::move(place))});
    }
    void save(std::shared_ptr<const pot::Section> shape, int glaze);
    // A kept pot to the wall of the day, or down from there; all of them. Answered by kWall, as is the start
    // and the end of a day.
    void put_on_wall(WallPot pot) {
        ask({.kind = Request::Kind::kPutOnWall, .hung = std::make_shared<const WallPot>(std::move(pot))});
    }
    void take_off_wall(std::string pot) {
        ask({.kind = Request::Kind::kTakeOffWall,
             .pot = std::make_shared<const std::string>(std::move(pot))});
    }
    void clear_wall() { ask({Request::Kind::kClearWall}); }
    void forget() { ask({Request::Kind::kForget}); }
    // A visit throws that lump, counted as Snapshot::run counts: it is journalled until forget(), or until
    // its pot is saved.
    void journal(std::uint64_t run) { ask({Request::Kind::kJournal, run}); }
    // Puts the pot of the interrupted visit on the wheel (after kLeftOver was answered) and goes on with its
    // journal.
    void resume(std::uint64_t run) { ask({Request::Kind::kResume, run}); }
    void drop_interrupted_session() { ask({Request::Kind::kDropInterrupted}); }
    // Answered by kSurvey: what the gallery holds, what the disk has left, how warm it is, the day's use.
    void survey() { ask({Request::Kind::kSurvey}); }
    void remove(std::string pot) {
        ask({.kind = Request::Kind::kRemove, .pot = std::make_shared<const std::string>(std::move(pot))});
    }
    void note(const VisitNote& visit) { ask({.kind = Request::Kind::kNote, .visit = visit}); }
    void note_attract_break() { ask({Request::Kind::kNoteBreak}); }
    void note_start() { ask({Request::Kind::kNoteStart}); }
    // The house's monitoring is told; every KioskHeartbeat::kEveryS.
    void beat(KioskPulse pulse) {
        ask({.kind = Request::Kind::kBeat, .pulse = std::make_shared<const KioskPulse>(std::move(pulse))});
    }
    // What the staff has set, for the next start.
    void keep(HouseDefaults house) {
        ask({.kind = Request::Kind::kKeepHouse,
             .house = std::make_shared<const HouseDefaults>(std::move(house))});
    }
    [[nodiscard]] std::shared_ptr<const KeeperAnswer> next_answer();

  private:
    // A few ms of an interrupted visit, so that the one that goes on is followed too.
    static constexpr int kInterruptedSessionTicksARound = 2000;
    struct Request {
        enum class Kind {
            kUndo,
            kBefore,
            kBeginJar,
            kSetAside,
            kHoldTogether,
            kJoinBowls,
            kTakeBack,
            kCutOff,
            kBeginTrim,
            kKeepDrawing,
            kWriteSession,
            kSave,
            kPutOnWall,
            kTakeOffWall,
            kClearWall,
            kForget,
            kJournal,
            kResume,
            kDropInterrupted,
            kSurvey,
            kRemove,
            kNote,
            kNoteBreak,
            kNoteStart,
            kBeat,
            kKeepHouse
        };
        Kind kind = Kind::kUndo;
        std::uint64_t number = 0;  // kBefore: a tick; kJournal, kResume: a run; kTakeBack: 1 or 2
        int glaze = 0;
        JarJoin join{};
        std::shared_ptr<const std::vector<std::byte>> drawn{};
        std::shared_ptr<const pot::Section> shape{};
        std::shared_ptr<const std::string> pot{};
        std::shared_ptr<const std::filesystem::path> place{};
        std::shared_ptr<const WallPot> hung{};
        VisitNote visit{};
        std::shared_ptr<const HouseDefaults> house{};
        std::shared_ptr<const KioskPulse> pulse{};
    };
    void ask(const Request& request) { static_cast<void>(requests_.try_push(request)); }

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
    void apply(const Request& request);
    void put_state_at(std::uint64_t tick);
    [[nodiscard]] std::filesystem::path drawing_place() const { return visits_ / "drawing"; }
    void remove_drawing() const noexcept;
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
    void save_now(const Request& request);
    void survey_now();
    void remove_now(const std::string& name);
    void answer(KeeperAnswer answer);
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
    jobs::SpscRing<Request> requests_{64};
    jobs::SpscRing<std::shared_ptr<const KeeperAnswer>> answers_{64};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
