// The film of the pot that was cut off, made beside the visit by a process of its own: it takes some seconds
// of a processor and 80 MB, neither of which the wheel shall miss. The process begins while the pot dries and
// is told the glaze when that is chosen. One thread at a time; nothing blocks.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/core/result.h"
#include "engine/jobs/idle_process.h"
#include "game/decoration/canvas.h"

namespace onggi::app {

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

}  // namespace onggi::app
