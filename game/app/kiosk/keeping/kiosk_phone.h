// Hands kept pots to the outbox for phones, beside the frame, and says by which code each is found; takes
// away what is over and counts what is opened. The main thread asks and is answered through queues; the work
// is done on a thread of its own, because a disk may be slow and because no answer of it may hold up a pot
// that is being kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/idle_process.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/message_queue.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/decoration/canvas.h"
#include "game/kiosk/events.h"
#include "game/screens/page/view.h"
#include "game/sharing/open_counter.h"
#include "game/sharing/outbox.h"

namespace onggi::app {

// The film of the pot that was cut off, made beside the visit by a process of its own: it takes some seconds
// of a processor and 80 MB, neither of which the wheel shall miss. The process begins while the pot dries and
// is told the glaze when that is chosen. One thread at a time; nothing blocks.
class KioskFilm {
  public:
    // `program`: what `film` is a command of; empty: no films are made. `folder` is this object's own.
    KioskFilm(std::filesystem::path program, std::filesystem::path folder)
        : program_(std::move(program)),
          folder_(std::move(folder)) {}
    ~KioskFilm() { drop(); }
    KioskFilm(const KioskFilm&) = delete;
    KioskFilm& operator=(const KioskFilm&) = delete;

    struct Files {
        std::filesystem::path film;
        std::filesystem::path still;  // shown until the film is asked for
    };
    static constexpr double kSeconds = 8.0;  // how long a film is

    // Of a session on the disk, which is taken from where it lies. The film before is dropped. System lacks:
    // no room, no process.
    Result<void> begin(const std::filesystem::path& session);
    // The glaze of its last seconds, as finish::GlazeMaterial::id has it, and what was drawn below it; null:
    // nothing. Once a film.
    void finish_in(std::string_view glaze, const decoration::Marks* marks);
    [[nodiscard]] bool is_in_the_making() { return maker_ && maker_->is_at_work(); }
    // Those of the film that was begun last, once it is made; none if it came to nothing.
    [[nodiscard]] std::optional<Files> files() const {
        return maker_ && maker_->has_succeeded() ? std::optional(places()) : std::nullopt;
    }
    // Whatever there is of it is taken away, and who makes it is ended.
    void drop() noexcept;

  private:
    [[nodiscard]] Files places() const { return {folder_ / "film.webp", folder_ / "still.webp"}; }

    std::filesystem::path program_;
    std::filesystem::path folder_;
    std::optional<jobs::IdleProcess> maker_;
};

// A pot that phones may fetch, for the staff.
struct SharedPotNote {
    std::string gallery_name;
    std::string until;  // "18:00", "2026-11-26, 18:00"

    friend bool operator==(const SharedPotNote&, const SharedPotNote&) = default;
};

// A kept pot, and what its page says of it.
struct PotToShare {
    std::string gallery_name{};  // "2026-11-21/pot-014"
    std::shared_ptr<const screens::FiredPot> pot{};
    int glaze = 0;
    int language = 0;
};

struct PhoneAnswer {
    // What became of a pot's code.
    struct OfPot {
        kiosk::ShareOutcome outcome = kiosk::ShareOutcome::kReady;
        std::string gallery_name;
        std::shared_ptr<const screens::PhoneWay> way{};  // if it is ready
    };
    struct Survey {
        std::vector<SharedPotNote> shared{};  // the newest first
    };
    struct Remark {};  // words alone

    std::variant<Remark, OfPot, Survey> what{};
    std::string words{};  // for the log; never the code
};

class KioskPhone final : private jobs::IoWork {
  public:
    // The visitor waits for a code meanwhile. Most films are made before a glaze is chosen, but for the last
    // second of them that shows it.
    static constexpr std::int64_t kFilmWaitNs = 15'000'000'000;

    // `settings` outlives it. `program`: who makes films, see KioskFilm.
    explicit KioskPhone(const KioskSettings& settings, std::filesystem::path program = {},
                        std::int64_t film_wait_ns = kFilmWaitNs)
        : settings_(settings),
          film_wait_ns_(film_wait_ns),
          film_(std::move(program), state_folder(settings.config.gallery.folder) / "film") {}
    ~KioskPhone() override { stop(); }

    // Does nothing where the settings share nothing.
    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Where the keeper lays the session of a pot that was cut off, for film().
    [[nodiscard]] std::filesystem::path session_place() const {
        return state_folder(settings_.config.gallery.folder) / "film.onggi";
    }

    // Main thread. Begins the film of a pot that may be shared later.
    void film(std::filesystem::path session);
    // Nobody waits for that pot's code any more. A film that its page lacks is made all the same.
    void forget();
    // Answered by kShared once every file is on the disk, or by kShareFailed. Waits for the film, but not for
    // long: one that is made later comes to the page then, where no other is begun before.
    void share(PotToShare pot);
    // The staff has deleted that pot, or will not have it shared. Answered by kShareOver where it had a code.
    void withdraw(std::string gallery_name);
    // What is shared now; answered by Survey.
    void survey();
    // Null: nothing is answered yet.
    [[nodiscard]] std::shared_ptr<const PhoneAnswer> next_answer() { return answers_.next(); }

  private:
    // The thread's own.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<screens::PhoneWay> shared(const PotToShare& kept);
    void share_when_filmed();
    void share_now(const PotToShare& kept);
    bool add_film(sharing::SharedPot& pot) const;
    void add_late_film();
    void look_after();
    void expire();
    void count_opened();
    void note(const PhoneNote& phones);
    void answer(PhoneAnswer answer) { answers_.post(std::move(answer)); }

    // Whose page there is, without its film.
    struct Unfilmed {
        sharing::SharedPot pot;
        sharing::ShareTime time;
        sharing::ShareCode code;
        bool is_forgotten = false;
    };

    const KioskSettings& settings_;
    std::int64_t film_wait_ns_;
    std::optional<sharing::Outbox> outbox_;
    std::optional<sharing::CounterReader> counter_;
    KioskFilm film_;
    std::optional<PotToShare> waiting_;  // for its film
    std::optional<Unfilmed> unfilmed_;
    std::int64_t now_ns_ = 0;  // of the round
    std::int64_t waits_until_ns_ = 0;
    std::int64_t looked_after_ns_ = 0;
    jobs::TaskQueue tasks_{16};
    jobs::MessageQueue<PhoneAnswer> answers_{16};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
