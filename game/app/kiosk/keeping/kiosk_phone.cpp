#include "game/app/kiosk/keeping/kiosk_phone.h"

#include <fmt/format.h>
#include <qrcodegen/qrcodegen.hpp>

#include <map>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/within_memory.h"
#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/keeping/kiosk_share.h"
#include "game/finish/glaze.h"
#include "game/kiosk/config.h"
#include "game/sharing/page_folder.h"
#include "game/sharing/share_link.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kAsksEveryNs = 30'000'000;
constexpr std::int64_t kLooksEveryNs = 60'000'000'000;
constexpr int kPosterPx = 720;
constexpr int kPosterQuality = 85;
constexpr int kSurfaceQuality = 80;
constexpr std::size_t kMostFilmBytes = 64'000'000;

// Error correction M, which tolerates about 15 % of unreadable area, such as a lamp's reflection.
screens::PhoneCode code_of(const std::string& text) {
    const auto qr = qrcodegen::QrCode::encodeText(text.c_str(), qrcodegen::QrCode::Ecc::MEDIUM);
    screens::PhoneCode code{.side = qr.getSize(), .dark = {}};
    for (int row = 0; row < code.side; ++row) {
        for (int column = 0; column < code.side; ++column)
            code.dark.push_back(qr.getModule(column, row));
    }
    return code;
}

}  // namespace

Result<void> KioskMaker::make(std::vector<std::string> words, const std::filesystem::path& input) {
    drop();
    if (program_.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (!error && !input.empty()) std::filesystem::rename(input, input_place(), error);
    if (error) return system_lacks(fmt::format("{}: {}: {}", name_, folder_.string(), error.message()));
    words.insert(words.begin(), program_);
    auto maker = jobs::ChildProcess::start(std::move(words));
    if (!maker) return system_lacks(fmt::format("{}: {}", name_, maker.error().message));
    maker_.emplace(std::move(*maker));
    return {};
}

void KioskMaker::drop() noexcept {
    maker_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

Result<void> KioskFilm::begin(const std::filesystem::path& session) {
    const Files made = places();
    return make({"film", input_place(), "--out", made.film, "--still", made.still, "--mp4", made.mp4,
                 "--quick", "--glaze", "-", "--seconds", fmt::format("{}", kSeconds)},
                session);
}

void KioskFilm::finish_in(std::string_view glaze, const decoration::Marks* marks) {
    if (!was_begun()) return;
    std::string words(glaze);
    // If the decoration's file is missing, the film shows the plain pot.
    const std::filesystem::path place = folder() / "marks";
    if (marks != nullptr && files::write_file_atomically(place, decoration::bytes_of(marks->recorded)))
        words += ' ' + place.string();
    tell(words);
}

Result<void> KioskDrawing::begin(const std::filesystem::path& session, const std::string& credit) {
    const Files made = places();
    std::vector<std::string> words{"replay", session,     "--fired", "glaze",      "--drawing",
                                   made.svg, "--drawing", made.pdf,  "--measures", made.measures};
    if (!credit.empty()) words.push_back("--credit=" + credit);
    return make(std::move(words));
}

Result<void> KioskPhone::start() {
    if (!kiosk::shares(settings_.config)) return {};
    return thread_.start(*this, "phone");
}

std::int64_t KioskPhone::round(std::int64_t now_ns) noexcept {
    now_ns_ = now_ns;
    while (const auto task = tasks_.next())
        (*task)();
    share_when_made();
    add_late_files();
    look_after();
    return kAsksEveryNs;
}

// A pot is shared also without a film.
void KioskPhone::film(std::filesystem::path session) {
    tasks_.post([this, session = std::move(session)] {
        unfinished_.reset();
        if (const auto begun = film_.begin(session); !begun) answer({.words = begun.error().message});
    });
}

void KioskPhone::forget() {
    tasks_.post([this] {
        waiting_.reset();
        if (unfinished_)
            unfinished_->is_forgotten = true;
        else
            drop_made();
    });
}

void KioskPhone::share(PotToShare pot) {
    tasks_.post([this, pot = std::move(pot)] {
        film_.finish_in(finish::glaze_at(pot.glaze).id, pot.pot ? pot.pot->shape.marks.get() : nullptr);
        const auto begun = drawing_.begin(
            std::filesystem::path(settings_.config.gallery.folder) / pot.gallery_name / "pot.onggi",
            credit_of(settings_));
        if (!begun) answer({.words = begun.error().message});
        waiting_ = pot;
        waits_until_ns_ = now_ns_ + film_wait_ns_;
    });
}

void KioskPhone::share_when_made() {
    if (!waiting_ || (is_making() && now_ns_ < waits_until_ns_)) return;
    share_now(*std::exchange(waiting_, std::nullopt));
}

void KioskPhone::drop_made() noexcept {
    film_.drop();
    drawing_.drop();
}

// A file that cannot be read is missing, like one that could not be made. With `about` it tells of itself.
bool KioskPhone::add_file(const std::filesystem::path& place, sharing::FileContent& into,
                          const asset::About* about) {
    const auto plain = files::read_file(place, kMostFilmBytes);
    if (!plain) {
        answer({.words = "page: " + plain.error().message});
        return false;
    }
    const auto bytes = std::as_bytes(std::span(*plain));
    auto told = about != nullptr ? asset::picture_about(bytes, *about)
                                 : std::vector<std::byte>(bytes.begin(), bytes.end());
    if (!told) {
        answer({.words = "page: " + told.error().message});
        return false;
    }
    into.bytes = std::move(*told);
    return true;
}

bool KioskPhone::add_film(sharing::SharedPot& pot, const asset::About& about) {
    const auto film = film_.files();
    if (!film || !add_file(film->film, pot.film, &about) || !add_file(film->still, pot.film_still, &about))
        return false;
    std::error_code ignored;
    if (std::filesystem::exists(film->mp4, ignored))
        static_cast<void>(add_file(film->mp4, pot.film_mp4, &about));
    pot.film_s = KioskFilm::kSeconds;
    return true;
}

bool KioskPhone::add_drawing(sharing::SharedPot& pot, const asset::About& about) {
    const auto drawn = drawing_.files();
    return drawn && add_file(drawn->svg, pot.drawing_svg, &about) &&
           add_file(drawn->pdf, pot.drawing_pdf, nullptr) &&
           add_file(drawn->measures, pot.measures_json, nullptr);
}

void KioskPhone::add_late_files() {
    if (!unfinished_ || is_making()) return;
    Unfinished late = *std::exchange(unfinished_, std::nullopt);
    const bool adds_film = !late.has_film && add_film(late.pot, late.about);
    const bool adds_drawing = !late.has_drawing && add_drawing(late.pot, late.about);
    if (adds_film || adds_drawing) {
        const auto renewed = outbox_->renew(late.code, late.pot, late.time);
        if (!renewed) answer({.words = "page: " + renewed.error().message});
    }
    if (late.is_forgotten) drop_made();
}

// Called again later, because the folder may be on a disk that is plugged in late.
Result<void> KioskPhone::open() {
    if (outbox_) return {};
    auto opened = sharing::Outbox::open(outbox_options(settings_));
    if (!opened) return opened.error();
    outbox_.emplace(std::move(*opened));
    return {};
}

Result<screens::PhoneWay> KioskPhone::shared(const PotToShare& kept) {
    const kiosk::Config& config = settings_.config;
    if (auto opened = open(); !opened) return opened.error();
    // Checked first, because a pot without an address is not reachable.
    const auto base = share_base_url(config);
    if (!base) return base.error();
    const std::filesystem::path folder = std::filesystem::path(config.gallery.folder) / kept.gallery_name;
    sharing::SharedPot pot = shared_pot(*kept.pot, kept.glaze, settings_, kept.language);
    pot.gallery_name = kept.gallery_name;
    pot.picture.path = folder / "pot.png";
    pot.model_glb.path = folder / "pot.glb";
    if (std::error_code error; std::filesystem::exists(folder / "pot.usdz", error))
        pot.model_usdz.path = folder / "pot.usdz";
    pot.print_stl.path = folder / "pot.stl";
    pot.print_3mf.path = folder / "pot.3mf";
    asset::About about = pot_story(*kept.pot, kept.glaze, settings_).about;
    about.date = today();
    const auto plain =
        asset::encode_webp(share_poster(kept.pot->shape, kept.glaze, kPosterPx), kPosterQuality);
    auto poster = plain ? asset::picture_about(*plain, about) : plain;
    if (!poster) return poster.error();
    pot.poster.bytes = std::move(*poster);
    if (const asset::Image wrapped = share_surface(kept.pot->shape, kept.glaze); wrapped.width > 0) {
        auto surface = asset::encode_jpeg(wrapped, kSurfaceQuality);
        if (!surface) return surface.error();
        pot.surface.bytes = std::move(*surface);
    }
    const bool has_film = add_film(pot, about);
    const bool has_drawing = add_drawing(pot, about);
    const sharing::ShareTime time = share_time_now(config);
    const auto code = outbox_->put(pot, time);
    if (!code) return code.error();
    if (!has_film || !has_drawing)
        unfinished_ = {std::move(pot), time, *code, std::move(about), has_film, has_drawing};
    screens::PhoneWay way{.page = code_of(sharing::page_url(*base, *code)), .code = code->shown()};
    if (const std::string wifi = sharing::wifi_text(config); !wifi.empty()) {
        way.wifi = code_of(wifi);
        way.wifi_name = config.sharing.wifi_name;
    }
    return way;
}

void KioskPhone::share_now(const PotToShare& kept) {
    auto way = within_memory("the page", [&] { return shared(kept); });
    if (!way)
        return answer({.what = PhoneAnswer::OfPot{kiosk::ShareOutcome::kFailed, kept.gallery_name},
                       .words = "sharing: " + way.error().message});
    note({.codes = 1});
    answer({.what = PhoneAnswer::OfPot{kiosk::ShareOutcome::kReady, kept.gallery_name,
                                       std::make_shared<const screens::PhoneWay>(std::move(*way))}});
}

void KioskPhone::withdraw(std::string gallery_name) {
    tasks_.post([this, name = std::move(gallery_name)] {
        if (auto opened = open(); !opened) return;
        const auto gone = outbox_->withdraw_named(name);
        if (!gone) return answer({.words = "sharing: " + gone.error().message});
        if (*gone) answer({.what = PhoneAnswer::OfPot{kiosk::ShareOutcome::kOver, name}});
    });
}

void KioskPhone::survey() {
    tasks_.post([this] {
        if (auto opened = open(); !opened) return;  // reported with the next request
        const auto entries = outbox_->list();
        if (!entries) return answer({.words = "sharing: " + entries.error().message});
        PhoneAnswer::Survey found;
        sharing::ShareTime time = share_time_now(settings_.config);
        for (auto entry = entries->rbegin(); entry != entries->rend(); ++entry) {
            time.expires_s = entry->expires_s;
            found.shared.push_back(
                {.gallery_name = entry->gallery_name, .until = sharing::gone_at(time).text});
        }
        answer({.what = std::move(found)});
    });
}

void KioskPhone::look_after() {
    if (now_ns_ - looked_after_ns_ < kLooksEveryNs) return;
    looked_after_ns_ = now_ns_;
    expire();
    count_opened();
}

void KioskPhone::expire() {
    if (auto opened = open(); !opened) return;  // reported with the next request
    const auto gone = outbox_->expire(share_time_now(settings_.config).now_s);
    if (!gone) answer({.words = "sharing: " + gone.error().message});
}

void KioskPhone::count_opened() {
    using sharing::ShareEvent;
    const std::string& pipe = settings_.config.sharing.counter;
    if (pipe.empty()) return;
    if (!counter_) {
        auto opened = sharing::CounterReader::open(pipe);
        if (!opened) return;
        counter_.emplace(std::move(*opened));
    }
    std::map<ShareEvent, int> counts = counter_->take();
    if (counts.empty()) return;
    note({.pages = counts[ShareEvent::kPageOpened],
          .models = counts[ShareEvent::kModelTaken],
          .prints = counts[ShareEvent::kPrintTaken],
          .films = counts[ShareEvent::kFilmTaken]});
}

// A failed write is only reported.
void KioskPhone::note(const PhoneNote& phones) {
    if (const auto noted = note_phones(statistics_folder(settings_.config), phones); !noted)
        answer({.words = noted.error().message});
}

}  // namespace onggi::app
