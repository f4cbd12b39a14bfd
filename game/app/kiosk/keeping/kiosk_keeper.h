// Keeps the visitor's history and writes pots to the disk on a background thread: follows the haptic loop by
// its records, undoes moves, saves, journals the visit and resumes an interrupted one. The main thread sends
// requests and receives answers through queues.
#pragma once

#include <cstdint>
#include <functional>
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
    // The clay of a cut-off pot, and the pot to be decorated.
    struct CutOff {
        std::shared_ptr<const clay::StudioClay> clay;
        std::shared_ptr<const pot::Pot> pot;
    };
    struct SetAside {
        std::shared_ptr<const pot::Pot> bowl;
    };
    struct Saved {
        int number = 0;            // number within the day
        std::string gallery_name;  // "2026-11-21/pot-014"
    };
    struct SessionWritten {
        std::filesystem::path place;
    };
    struct Wall {
        std::shared_ptr<const std::vector<screens::ShelfPot>> pots;  // the present wall, oldest first
    };
    struct Interrupted {
        std::shared_ptr<const pot::Pot> bowl;  // the first bowl of a jar, or null
        JarStage jar = JarStage::kNone;
        std::string jar_target;
        std::shared_ptr<const decoration::Recorded> drawn;  // null: no decoration
        VisitPlace place;
        std::shared_ptr<const pot::Pot> pot;
    };
    struct Survey {
        static constexpr std::size_t kMostPots = 1000;  // limit for the panel's pages
        std::vector<std::string> pots{};                // newest first
        std::size_t pots_beyond = 0;                    // number of further pots
        double free_mb = 0.0;
        std::optional<double> celsius{};
        UseOfDay use{};
    };
    struct NotPut {};  // the clay on the wheel is unchanged
    struct Remark {};  // only words for the log

    // The answer; an Event is dispatched to the visit.
    std::variant<Remark, kiosk::Event, CutOff, SetAside, Saved, SessionWritten, Wall, Interrupted, Survey,
                 NotPut>
        what{};
    std::string words{};      // for the log
    bool is_trouble = false;  // the words report an error
};

class KioskKeeper final : private jobs::IoWork {
  public:
    // `start` is the state of every fresh lump. No heartbeat without monitoring.
    KioskKeeper(haptic::HapticJob& job, const haptic::HapticState& start,
                const haptic::HapticParameters& parameters, Gallery gallery, std::filesystem::path statistics,
                std::optional<KioskHeartbeat> heartbeat = {});
    ~KioskKeeper() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Main thread. The keeper executes each of these requests once it has received all records of the clay up
    // to the request. Answered by event::UndoneAll if nothing is left to undo.
    void undo();
    // The next lump is the first bowl of a jar modelled on that museum's pot.
    void begin_jar(std::string target);
    // Sets aside the bowl on the wheel as the first of a jar. Answered by SetAside, after which new clay may
    // come, or event::JarStays.
    void set_aside();
    // Compares the first bowl's rim with that of the bowl on the wheel. Answered by event::Rims or
    // event::RimsApart.
    void hold_together(double mouth_mm);
    // Joins both bowls on the wheel. Answered by event::Joined or event::JarStays.
    void join_bowls(const JarJoin& join);
    // Puts a bowl back on the wheel: the first one, or the second of a joined jar. Answered by NotPut on
    // failure.
    void take_back(int bowl);
    // Returns to the state two seconds before that tick. Answered by NotPut if the clay is unchanged.
    void go_before(std::uint64_t tick);
    // Answered by CutOff.
    void cut_off();
    // Stores the unfinished decoration, in case of a power cut.
    void keep_drawing(std::vector<std::byte> drawn);
    // Stores the visitor's choices, in case of a power cut.
    void keep_place(VisitPlace place);
    // Limits undo to the ticks from here on, until other clay comes.
    void begin_trim();
    // Writes the session of the last cut-off pot to that place. Answered by SessionWritten if the history is
    // complete.
    void write_session(std::filesystem::path place);
    // Answered by Saved or event::SaveFailed.
    void save(std::shared_ptr<const pot::Section> shape, int glaze, exporter::PotStory story = {});
    // Puts a kept pot on the wall of the day, takes one down, or takes down all. Answered by Wall, which is
    // also sent at the start and the end of a day.
    void put_on_wall(WallPot pot);
    void take_off_wall(std::string pot);
    void clear_wall();
    // Drops everything of a visit that is over.
    void forget();
    // Journals the visit's lump `run` (see Snapshot::run) until forget(), or until its pot is saved.
    void journal(std::uint64_t run);
    // Puts the pot of the interrupted visit on the wheel, after the answer Interrupted, and continues its
    // journal.
    void resume(std::uint64_t run);
    void drop_interrupted_session();
    // Answered by Survey: the gallery's pots, free disk space, temperature, the day's statistics.
    void survey();
    void remove(std::string pot);
    void note(const VisitNote& visit);
    void note_attract_break();
    void note_start();
    // Writes the heartbeat for the museum's monitoring, every KioskHeartbeat::kEveryS.
    void beat(KioskPulse pulse);
    // Stores the staff's settings for the next start.
    void keep(HouseDefaults house);
    // Null: no answer yet.
    [[nodiscard]] std::shared_ptr<const KeeperAnswer> next_answer() { return answers_.next(); }

  private:
    // A few ms of replay per round, so that the current visit is still followed.
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
    [[nodiscard]] VisitPlace interrupted_place();
    void take_arriving(const haptic::TickRecord& record);
    void look_at_the_wall(std::int64_t now_ns);
    void show_wall(const Result<void>& changed);
    void look_at_the_gallery();
    void answer_survey();
    // Main thread.
    void ask(std::function<void()> task);
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
    std::filesystem::path visits_;  // folder of the journals
    VisitJournal journal_;
    std::optional<std::uint64_t> journalled_run_;
    std::uint64_t run_ = 0;                                    // run of the last record
    std::unique_ptr<InterruptedSession> interrupted_session_;  // until its pot is on the wheel
    bool has_looked_ = false;
    bool has_found_ = false;
    bool is_worked_out_ = false;
    bool is_put_ = false;                        // its state was sent to the wheel
    bool was_resumed_ = false;                   // and the new journal has not caught up yet
    std::optional<std::uint64_t> trimmed_from_;  // the tick
    JarKeeping jar_;
    std::optional<haptic::History> arriving_;  // a jar's history, continued once its state is on the wheel
    bool is_jar_ = false;                      // history_ is of a joined jar
    Gallery gallery_;
    std::string gallery_trouble_;  // as last reported
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
