// Hands kept pots to the outbox for phones, beside the frame, and says by which code each is found; takes
// away what is over and counts what is opened. Asked and answered by the main thread through rings; the work
// is done on a thread of its own, because a disk may be slow and because no answer of it may hold up a pot
// that is being kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/spsc_ring.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/keeping/kiosk_film.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/screens/view.h"
#include "game/sharing/open_counter.h"
#include "game/sharing/outbox.h"

namespace onggi::app {

// A pot that phones may fetch, for the staff.
struct SharedPotNote {
    std::string gallery_name;
    std::string until;  // "18:00", "2026-11-26, 18:00"

    friend bool operator==(const SharedPotNote&, const SharedPotNote&) = default;
};

struct PhoneRequest {
    enum class Kind { kShare, kWithdraw, kFilm, kForget, kSurvey };
    Kind kind = Kind::kShare;
    // Of kShare: a kept pot, its files and what the page says of it. Of kWithdraw: its name in the gallery.
    int number = 0;              // of the day
    std::string gallery_name{};  // "2026-11-21/pot-014"
    std::shared_ptr<const screens::FiredPot> pot{};
    int glaze = 0;
    int language = 0;
    std::filesystem::path session{};  // of kFilm
};

struct PhoneAnswer {
    enum class Kind { kShared, kFailed, kOver, kRemark, kSurvey };
    Kind kind = Kind::kRemark;
    int number = 0;                                  // of the request
    std::string gallery_name{};                      // likewise; of kOver: whose code is over
    std::shared_ptr<const screens::PhoneWay> way{};  // of kShared
    std::string words{};                             // for the log; never the code
    std::vector<SharedPotNote> shared{};             // of kSurvey, the newest first
};

class KioskPhone final : private jobs::IoWork {
  public:
    // `settings` outlives it. `program`: who makes films, see KioskFilm.
    explicit KioskPhone(const KioskSettings& settings, std::filesystem::path program = {})
        : settings_(settings),
          film_(std::move(program), state_folder(settings.config.gallery.folder) / "film") {}
    ~KioskPhone() override { stop(); }

    // Does nothing where the settings share nothing.
    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Where the keeper lays the session of a pot that was cut off, for film().
    [[nodiscard]] std::filesystem::path session_place() const {
        return state_folder(settings_.config.gallery.folder) / "film.onggi";
    }

    // Main thread, wait-free. Begins the film of a pot that may be shared later.
    void film(std::filesystem::path session) {
        ask({.kind = PhoneRequest::Kind::kFilm, .session = std::move(session)});
    }
    // Nobody wants that pot's code any more, nor its film.
    void forget() { ask({.kind = PhoneRequest::Kind::kForget}); }
    // Answered by kShared once every file is on the disk, or by kFailed. Waits for the film, but not for
    // long.
    void share(PhoneRequest request) { ask(std::move(request)); }
    // The staff has deleted that pot, or will not have it shared. Answered by kOver where it had a code.
    void withdraw(std::string gallery_name) {
        ask({.kind = PhoneRequest::Kind::kWithdraw, .gallery_name = std::move(gallery_name)});
    }
    // What is shared now; answered by kSurvey.
    void survey() { ask({.kind = PhoneRequest::Kind::kSurvey}); }
    [[nodiscard]] std::shared_ptr<const PhoneAnswer> next_answer();

  private:
    void ask(PhoneRequest request) {
        static_cast<void>(requests_.try_push(std::make_shared<const PhoneRequest>(std::move(request))));
    }
    // The thread's own.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<screens::PhoneWay> shared(const PhoneRequest& request);
    void take(const PhoneRequest& request, std::int64_t now_ns);
    void begin_film(const PhoneRequest& request);
    void share_when_filmed(std::int64_t now_ns);
    void share_now(const PhoneRequest& request);
    void withdraw_now(const std::string& gallery_name);
    void survey_now();
    void look_after(std::int64_t now_ns);
    void expire();
    void count_opened();
    void note(const PhoneNote& phones);
    void answer(PhoneAnswer answer);

    const KioskSettings& settings_;
    std::optional<sharing::Outbox> outbox_;
    std::optional<sharing::CounterReader> counter_;
    KioskFilm film_;
    std::optional<PhoneRequest> waiting_;  // for its film
    std::int64_t waits_until_ns_ = 0;
    std::int64_t looked_after_ns_ = 0;
    jobs::SpscRing<std::shared_ptr<const PhoneRequest>> requests_{16};
    jobs::SpscRing<std::shared_ptr<const PhoneAnswer>> answers_{16};
    jobs::IoThread thread_;
};

}  // namespace onggi::app
