// Keeps what the visitor does, and puts pots on the disk, beside the frame: it follows the haptic loop by its
// records, takes moves back, saves, journals the visit and goes on with one that was interrupted. The main
// thread asks and is answered through queues; the work is done on a thread of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/message_queue.h"
#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/app/kiosk/gallery/jar_keeping.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/haptic/history.h"
#include "game/haptic/job.h"
#include "game/kiosk/events.h"
#include "game/screens/page/view.h"
#include "game/screens/pots/pot_picture.h"

namespace onggi::app {

struct KeeperAnswer {
    // Of a cut pot: its clay, and the pot as it is drawn on.
    struct CutOff {
        std::shared_ptr<const clay::StudioClay> clay;
        std::shared_ptr<const pot::Pot> pot;
    };
    struct SetAside {
        std::shared_ptr<const pot::Pot> bowl;
    };
    struct Saved {
        int number = 0;            // of the day
        std::string gallery_name;  // "2026-11-21/pot-014"
    };
    struct SessionWritten {
        std::filesystem::path place;
    };
    struct Wall {
        std::shared_ptr<const std::vector<screens::ShelfPot>> pots;  // as it is now, the oldest first
    };
    struct Interrupted {
        std::shared_ptr<const pot::Pot> bowl;  // the first of a jar; null: none
        JarStage jar = JarStage::kNone;
        std::string jar_target;
        std::shared_ptr<const decoration::Recorded> drawn;  // null: nothing was
    };
    struct Survey {
        static constexpr std::size_t kMostPots = 1000;  // that anybody pages through
        std::vector<std::string> pots{};                // the newest, newest first
        std::size_t pots_beyond = 0;                    // how many more there are
        double free_mb = 0.0;
        std::optional<double> celsius{};
        UseOfDay use{};
    };
    struct NotPut {};  // the clay on the wheel stays as it is
    struct Remark {};  // words alone

    // An event: what the visit has to know, and no more.
    std::variant<Remark, kiosk::Event, CutOff, SetAside, Saved, SessionWritten, Wall, Interrupted, Survey,
                 NotPut>
        what{};
    std::string words{};      // for the log
    bool is_trouble = false;  // what they tell of
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
    // Answered by event::UndoneAll where nothing is left to take back.
    void undo();
    // The lump that comes is the first bowl of a jar after that pot of a museum.
    void begin_jar(std::string target);
    // The bowl on the wheel is the first of a jar. Answered by SetAside or event::JarStays; new clay may
    // come then.
    void set_aside();
    // How its rim meets that of the bowl on the wheel: event::Rims or
    // event::RimsApart.
    void hold_together(double mouth_mm);
    // Both become one, on the wheel: event::Joined or event::JarStays.
    void join_bowls(const JarJoin& join);
    // That bowl is on the wheel again as it was: the first one, or of a jar the second. Answered by NotPut
    // where it is not.
    void take_back(int bowl);
    // To two seconds before that tick. Answered by NotPut where the clay stays as it is.
    void go_before(std::uint64_t tick);
    // Answered by CutOff.
    void cut_off();
    // What was drawn on it so far, for a power cut.
    void keep_drawing(std::vector<std::byte> drawn);
    // Undoing goes no further back from here on, until other clay comes.
    void begin_trim();
    // All that was done to the pot that was cut off last, as a session at that place; answered by
    // SessionWritten where it is known.
    void write_session(std::filesystem::path place);
    // Answered by Saved or event::SaveFailed.
    void save(std::shared_ptr<const pot::Section> shape, int glaze);
    // A kept pot to the wall of the day, or down from there; all of them. Answered by Wall, as is the start
    // and the end of a day.
    void put_on_wall(WallPot pot);
    void take_off_wall(std::string pot);
    void clear_wall();
    // Of a visit that is over, nothing stays.
    void forget();
    // A visit throws that lump, counted as Snapshot::run counts: it is journalled until forget(), or until
    // its pot is saved.
    void journal(std::uint64_t run);
    // Puts the pot of the interrupted visit on the wheel (after Interrupted was answered) and goes on with
    // its journal.
    void resume(std::uint64_t run);
    void drop_interrupted_session();
    // Answered by Survey: what the gallery holds, what the disk has left, how warm it is, the day's use.
    void survey();
    void remove(std::string pot);
    void note(const VisitNote& visit);
    void note_attract_break();
    void note_start();
    // The house's monitoring is told; every KioskHeartbeat::kEveryS.
    void beat(KioskPulse pulse);
    // What the staff has set, for the next start.
    void keep(HouseDefaults house);
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
    void end_journal();
    void put_state_at(std::uint64_t tick);
    [[nodiscard]] std::filesystem::path drawing_place() const { return visits_ / "drawing"; }
    void remove_drawing() const noexcept;
    void remove_interrupted_session();
    [[nodiscard]] std::shared_ptr<const decoration::Recorded> interrupted_drawing();
    void take_arriving(const haptic::TickRecord& record);
    void look_at_the_wall(std::int64_t now_ns);
    void show_wall(const Result<void>& changed);
    void look_at_the_gallery();
    void answer_survey();
    void answer(KeeperAnswer answer) { answers_.post(std::move(answer)); }
    void answer_by(const kiosk::Event& event, std::string words = {}) {
        answer({.what = event, .words = std::move(words)});
    }
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
    bool has_said_unsynced_ = false;
    bool gallery_was_there_ = false;
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
