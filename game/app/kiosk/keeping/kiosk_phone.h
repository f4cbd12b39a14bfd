// Puts kept pots into the outbox for phones on a background thread and returns their codes; removes expired
// pots and counts opened pages. The main thread sends requests and receives answers through queues. It has
// its own thread, because the disk may be slow and sharing must not delay the keeper.
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

#include "engine/asset/about.h"
#include "engine/core/result.h"
#include "engine/jobs/child_process.h"
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

// Files that a separate process of this program makes in a folder of its own. One thread at a time; does not
// block.
class KioskMaker {
  public:
    KioskMaker(const KioskMaker&) = delete;
    KioskMaker& operator=(const KioskMaker&) = delete;

    [[nodiscard]] bool is_in_the_making() { return maker_ && maker_->is_at_work(); }
    // Deletes its files and ends its process.
    void drop() noexcept;

  protected:
    // `program` is this program's executable; empty: makes nothing. `name` is for errors.
    KioskMaker(std::filesystem::path program, std::filesystem::path folder, std::string name)
        : program_(std::move(program)),
          folder_(std::move(folder)),
          name_(std::move(name)) {}
    ~KioskMaker() { drop(); }

    // Drops what was made, moves the file `input` to input_place() unless it is empty, and starts the program
    // with these words. System lacks: no space, no process.
    Result<void> make(std::vector<std::string> words, const std::filesystem::path& input = {});
    [[nodiscard]] std::filesystem::path input_place() const { return folder_ / "session.onggi"; }
    // Sends one line to the process.
    void tell(std::string_view line) { maker_->tell(line); }
    [[nodiscard]] bool was_begun() const { return maker_.has_value(); }
    [[nodiscard]] bool has_made() const { return maker_ && maker_->has_succeeded(); }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path program_;
    std::filesystem::path folder_;
    std::string name_;
    std::optional<jobs::ChildProcess> maker_;
};

// The film of the cut-off pot. It takes some seconds of a processor and 80 MB, which must not affect the
// wheel. Its process begins while the pot dries and receives the glaze once it is chosen.
class KioskFilm final : public KioskMaker {
  public:
    KioskFilm(std::filesystem::path program, std::filesystem::path folder)
        : KioskMaker(std::move(program), std::move(folder), "film") {}

    struct Files {
        std::filesystem::path film;
        std::filesystem::path still;  // shown until the film is requested
        std::filesystem::path mp4;    // missing if its encoder failed
    };
    static constexpr double kSeconds = 8.0;  // duration of a film

    // Starts a film of a session file, which it moves. Drops the previous film.
    Result<void> begin(const std::filesystem::path& session);
    // Sends the glaze of its last seconds (a finish::GlazeMaterial::id) and the decoration below it, or null.
    // Once per film.
    void finish_in(std::string_view glaze, const decoration::Marks* marks);
    // The files of the last film once it is complete; nothing if it failed.
    [[nodiscard]] std::optional<Files> files() const {
        return has_made() ? std::optional(places()) : std::nullopt;
    }

  private:
    [[nodiscard]] Files places() const {
        return {folder() / "film.webp", folder() / "still.webp", folder() / "film.mp4"};
    }
};

// The drawing and the measures of a kept pot. The library that sets their text ends a process that lacks
// fonts or memory.
class KioskDrawing final : public KioskMaker {
  public:
    KioskDrawing(std::filesystem::path program, std::filesystem::path folder)
        : KioskMaker(std::move(program), std::move(folder), "drawing") {}

    struct Files {
        std::filesystem::path svg;
        std::filesystem::path pdf;
        std::filesystem::path measures;
    };

    // Draws the pot that a session left, with a line of credit. Drops the previous drawing.
    Result<void> begin(const std::filesystem::path& session, const std::string& credit);
    // The files of the last drawing once all are complete; nothing if one failed.
    [[nodiscard]] std::optional<Files> files() const {
        return has_made() ? std::optional(places()) : std::nullopt;
    }

  private:
    [[nodiscard]] Files places() const {
        return {folder() / "pot.svg", folder() / "pot.pdf", folder() / "pot.json"};
    }
};

// A shared pot, for the staff.
struct SharedPotNote {
    std::string gallery_name;
    std::string until;  // "18:00", "2026-11-26, 18:00"

    friend bool operator==(const SharedPotNote&, const SharedPotNote&) = default;
};

// A kept pot, and the data of its page.
struct PotToShare {
    std::string gallery_name{};  // "2026-11-21/pot-014"
    std::shared_ptr<const screens::FiredPot> pot{};
    int glaze = 0;
    int language = 0;
};

struct PhoneAnswer {
    // The new state of a pot's code.
    struct OfPot {
        kiosk::ShareOutcome outcome = kiosk::ShareOutcome::kReady;
        std::string gallery_name;
        std::shared_ptr<const screens::PhoneWay> way{};  // if it is ready
    };
    struct Survey {
        std::vector<SharedPotNote> shared{};  // newest first
    };
    struct Remark {};  // only words for the log

    std::variant<Remark, OfPot, Survey> what{};
    std::string words{};  // for the log; never contains the code
};

class KioskPhone final : private jobs::IoWork {
  public:
    // The visitor waits for the code meanwhile. Most films are complete before a glaze is chosen, except for
    // the last second, which shows it.
    static constexpr std::int64_t kFilmWaitNs = 15'000'000'000;

    // `settings` must outlive it. `program`: see KioskFilm.
    explicit KioskPhone(const KioskSettings& settings, const std::filesystem::path& program = {},
                        std::int64_t film_wait_ns = kFilmWaitNs)
        : settings_(settings),
          film_wait_ns_(film_wait_ns),
          film_(program, state_folder(settings.config.gallery.folder) / "film"),
          drawing_(program, state_folder(settings.config.gallery.folder) / "drawn") {}
    ~KioskPhone() override { stop(); }

    // Does nothing if sharing is off.
    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // The place where the session of a cut-off pot is written for film().
    [[nodiscard]] std::filesystem::path session_place() const {
        return state_folder(settings_.config.gallery.folder) / "film.onggi";
    }

    // Main thread. Begins the film of a pot that may be shared later.
    void film(std::filesystem::path session);
    // Drops the request for the pot of a visitor who has left. A film or a drawing that its page lacks is
    // still made.
    void forget();
    // Answered by kShared once every file is on the disk, or by kShareFailed. Waits for film and drawing for
    // kFilmWaitNs at most; later ones are added to the page, unless another film is begun before.
    void share(PotToShare pot);
    // Ends the sharing of a pot that the staff deleted or withdrew. Answered by kShareOver if it had a code.
    void withdraw(std::string gallery_name);
    // Answered by Survey: the shared pots.
    void survey();
    // Null: no answer yet.
    [[nodiscard]] std::shared_ptr<const PhoneAnswer> next_answer() { return answers_.next(); }

  private:
    // The background thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<screens::PhoneWay> shared(const PotToShare& kept);
    [[nodiscard]] bool is_making() { return film_.is_in_the_making() || drawing_.is_in_the_making(); }
    void drop_made() noexcept;
    void share_when_made();
    void share_now(const PotToShare& kept);
    [[nodiscard]] bool add_file(const std::filesystem::path& place, sharing::FileContent& into,
                                const asset::About* about);
    [[nodiscard]] bool add_film(sharing::SharedPot& pot, const asset::About& about);
    [[nodiscard]] bool add_drawing(sharing::SharedPot& pot, const asset::About& about);
    void add_late_files();
    void look_after();
    void expire();
    void count_opened();
    void note(const PhoneNote& phones);
    void answer(PhoneAnswer answer) { answers_.post(std::move(answer)); }

    // A pot whose page lacks its film or its drawing.
    struct Unfinished {
        sharing::SharedPot pot;
        sharing::ShareTime time;
        sharing::ShareCode code;
        asset::About about;
        bool has_film = false;
        bool has_drawing = false;
        bool is_forgotten = false;
    };

    const KioskSettings& settings_;
    std::int64_t film_wait_ns_;
    std::optional<sharing::Outbox> outbox_;
    std::optional<sharing::CounterReader> counter_;
    KioskFilm film_;
    KioskDrawing drawing_;
    std::optional<PotToShare> waiting_;  // waits for its film and its drawing
    std::optional<Unfinished> unfinished_;
    std::int64_t now_ns_ = 0;  // time of the round
    std::int64_t waits_until_ns_ = 0;
    std::int64_t looked_after_ns_ = 0;
    jobs::TaskQueue tasks_{16};
    jobs::MessageQueue<PhoneAnswer> answers_{16};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
