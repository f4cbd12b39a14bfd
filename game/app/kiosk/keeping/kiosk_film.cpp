#include "game/app/kiosk/keeping/kiosk_film.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

#include "engine/files/atomic_file.h"

namespace onggi::app {

Result<void> KioskFilm::begin(const std::filesystem::path& session) {
    drop();
    if (program_.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    const std::filesystem::path taken = folder_ / "session.onggi";
    if (!error) std::filesystem::rename(session, taken, error);
    if (error) return system_lacks(fmt::format("film: {}: {}", taken.string(), error.message()));
    const Files made = places();
    auto maker =
        jobs::IdleProcess::start({program_, "film", taken, "--out", made.film, "--still", made.still,
                                  "--quick", "--glaze", "-", "--seconds", fmt::format("{}", kSeconds)});
    if (!maker) return system_lacks("film: " + maker.error().message);
    maker_.emplace(std::move(*maker));
    return {};
}

void KioskFilm::finish_in(std::string_view glaze, const decoration::Marks* marks) {
    if (!maker_) return;
    std::string words(glaze);
    // A film of the pot as it was before is a film all the same.
    const std::filesystem::path place = folder_ / "marks";
    if (marks != nullptr && files::write_file_atomically(place, decoration::bytes_of(marks->recorded)))
        words += ' ' + place.string();
    maker_->tell(words);
}

void KioskFilm::drop() noexcept {
    maker_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace onggi::app
