#include "game/app/kiosk/kiosk_film.h"

#include <fmt/format.h>

#include <system_error>

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

void KioskFilm::drop() noexcept {
    maker_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace onggi::app
