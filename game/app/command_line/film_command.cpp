#include "game/app/command_line/film_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <utility>

#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "game/app/command_line/options.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/progress.h"
#include "game/app/replay/film.h"
#include "game/app/replay/film_plan.h"
#include "game/app/system/report.h"

namespace onggi::app {
namespace {

struct FilmOptions {
    std::string session;
    std::string out;
    PictureSize size{FilmDesc{}.width, FilmDesc{}.height};
    std::optional<double> seconds;
    clay::Firing finished = clay::Firing::kWet;
    bool quick = false;
};

Result<void> make_film(const FilmOptions& options) {
    if (!options.out.ends_with(".webp"))
        return bad_input(fmt::format("{}: expected a film's ending (.webp)", shown_path(options.out)));
    if (auto place = files::check_output_place(options.out); !place) return place;
    auto loaded = load_session(options.session);
    if (!loaded) return loaded.error();
    if (const auto cut = remark_on_cut(loaded->session, options.session)) remark(*cut);
    if (loaded->start.state.studio() == nullptr && options.finished != clay::Firing::kWet)
        return bad_input("--fired: expected the studio clay, found the paper's, which is never fired");
    FilmDesc desc{.width = options.size.width,
                  .height = options.size.height,
                  .finished = options.finished,
                  .quick = options.quick};
    desc.seconds = options.seconds.value_or(desc.seconds);
    auto maker = FilmMaker::create(std::move(loaded->session), std::move(loaded->start), desc);
    if (!maker) return maker.error();
    Progress progress("filming", (*maker)->picture_count());
    for (bool goes_on = true; goes_on;) {
        const auto worked = (*maker)->work();
        if (!worked) return worked.error();
        goes_on = *worked;
        progress.reached_rarely((*maker)->pictures_drawn());
    }
    const auto film = (*maker)->take();
    if (!film) return film.error();
    return files::write_file_atomically(options.out, *film);
}

}  // namespace

void add_film_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand("film", "Replay a session as a short film of its making");
    const auto options = std::make_shared<FilmOptions>();
    command->add_option("file", options->session, "a recorded session")
        ->type_name("SESSION.onggi")
        ->required();
    command->add_option("--out", options->out, "the film, an animated WebP; needs Vulkan")
        ->type_name("F.webp")
        ->required();
    add_size_option(*command, options->size);
    add_number_option(*command, "--seconds", options->seconds, kLeastFilmS, kLongestFilmS,
                      fmt::format("how long it is ({})", FilmDesc{}.seconds));
    add_firing_option(*command, options->finished, "the stage at which the finished pot is shown");
    command->add_flag("--quick", options->quick,
                      "drawn as the live window is: a quarter of the time, and a little coarser");
    command->callback([options, &exit_status] {
        const auto done = make_film(*options);
        exit_status = done ? 0 : report(done.error());
    });
}

}  // namespace onggi::app
