#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/options.h"
#include "game/app/command_line/progress.h"
#include "game/app/replay/film.h"
#include "game/app/replay/stored_session.h"
#include "game/app/system/report.h"
#include "game/decoration/stroke.h"
#include "game/finish/glaze.h"

namespace onggi::app {
namespace {

constexpr std::string_view kOfStdin = "-";

struct FilmOptions {
    std::string session;
    std::string out;
    PictureSize size{FilmDesc{}.width, FilmDesc{}.height};
    std::optional<double> seconds;
    clay::Firing finished = clay::Firing::kWet;
    bool quick = false;
    std::string still;
    std::string mp4;
    std::string glaze;
};

// Returns one of the six glazes by its name.
Result<const finish::GlazeMaterial*> glaze_called(const std::string& name, const std::string& place) {
    if (const finish::GlazeMaterial* glaze = finish::find_glaze(name)) return glaze;
    std::string known;
    for (const finish::GlazeMaterial& glaze : finish::glazes())
        known += (known.empty() ? "" : ", ") + std::string(glaze.id);
    return bad_input(fmt::format("{}: expected one of {}, found {}", place, known, in_quotes(name)));
}

// Reads a line of standard input, for a film that starts before the glaze is chosen: the glaze's name and,
// after a space, the path of the decoration's file, if there is one.
Result<const finish::GlazeMaterial*> finish_as_stdin_says(FilmMaker& maker) {
    std::array<char, 4096> line{};  // longer than any path
    std::cin.getline(line.data(), line.size());
    const std::string all = line.data();
    const std::size_t space = std::min(all.find(' '), all.size());
    const auto glaze = glaze_called(all.substr(0, space), "standard input");
    if (!glaze) return glaze;
    maker.finish_in(**glaze);
    if (space + 1 >= all.size()) return glaze;
    const std::string place = all.substr(space + 1);
    const auto bytes = files::read_file(place, record::kMaxSupplementBytes);
    if (!bytes) return bytes.error();
    const auto drawn = decoration::recorded_from(std::as_bytes(std::span(*bytes)), shown_path(place));
    if (!drawn) return drawn.error();
    maker.decorate(*drawn);
    return glaze;
}

Result<void> check_places(const FilmOptions& options) {
    struct Asked {
        const std::string& place;
        const char* what;
        const char* ending;
    };
    for (const auto& [place, what, ending] : {Asked{options.out, "film", ".webp"},
                                              {options.still, "still", ".webp"},
                                              {options.mp4, "film", ".mp4"}}) {
        if (place.empty() && &place != &options.out) continue;
        if (!place.ends_with(ending))
            return bad_input(fmt::format("{}: expected a {}'s ending ({})", shown_path(place), what, ending));
        if (auto checked = files::check_output_place(place); !checked) return checked;
    }
    return {};
}

// The WebP film is whole: the lack of the MP4 is only reported.
Result<void> write_mp4(FilmMaker& maker, const std::string& place) {
    const auto film = maker.take_mp4();
    if (film) return files::write_file_atomically(place, *film);
    warn(film.error().message + "; the film is WebP only");
    return {};
}

Result<void> make_film(const FilmOptions& options) {
    if (auto places = check_places(options); !places) return places;
    const bool asks_later = options.glaze == kOfStdin;
    const finish::GlazeMaterial* glaze = nullptr;
    if (!options.glaze.empty() && !asks_later) {
        const auto called = glaze_called(options.glaze, "--glaze");
        if (!called) return called.error();
        glaze = *called;
    }
    auto loaded = load_session(options.session);
    if (!loaded) return loaded.error();
    if (const auto cut = remark_on_cut(loaded->session, options.session)) remark(*cut);
    if (loaded->start.state.studio() == nullptr &&
        (options.finished != clay::Firing::kWet || !options.glaze.empty()))
        return bad_input(
            "--fired, --glaze: expected the studio clay, found the paper's, which is never fired");
    const decoration::Recorded decoration = std::move(loaded->decoration);
    FilmDesc desc{.width = options.size.width,
                  .height = options.size.height,
                  .finished = options.finished,
                  .quick = options.quick,
                  .as_mp4 = !options.mp4.empty()};
    desc.seconds = options.seconds.value_or(desc.seconds);
    auto maker = FilmMaker::create(std::move(loaded->session), std::move(loaded->start), desc);
    if (!maker) return maker.error();
    if (glaze != nullptr) (*maker)->finish_in(*glaze);
    (*maker)->decorate(decoration);
    Progress progress("filming", (*maker)->picture_count());
    for (bool goes_on = true; goes_on;) {
        if (asks_later && glaze == nullptr && (*maker)->has_drawn_the_making()) {
            const auto called = finish_as_stdin_says(**maker);
            if (!called) return called.error();
            glaze = *called;
        }
        const auto worked = (*maker)->work();
        if (!worked) return worked.error();
        goes_on = *worked;
        progress.reached_rarely((*maker)->pictures_drawn());
    }
    const auto film = (*maker)->take();
    if (!film) return film.error();
    if (!options.still.empty()) {
        const auto still = (*maker)->still();
        if (!still) return still.error();
        if (auto written = files::write_file_atomically(options.still, *still); !written) return written;
    }
    if (auto written = files::write_file_atomically(options.out, *film); !written) return written;
    return options.mp4.empty() ? Result<void>{} : write_mp4(**maker, options.mp4);
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
    command
        ->add_option("--glaze", options->glaze,
                     "the finished pot's glaze; - reads its name, and the path of the decoration's file, "
                     "from standard "
                     "input once the making is drawn")
        ->type_name("NAME");
    command->add_option("--still", options->still, "a picture from late in the making, beside the film")
        ->type_name("F.webp");
    command->add_option("--mp4", options->mp4, "the same film as MP4, which loops, for phones and messengers")
        ->type_name("F.mp4");
    command->add_flag("--quick", options->quick, "draw like the live window, in a third of the time");
    command->callback([options, &exit_status] { exit_status = exit_code(make_film(*options)); });
}

}  // namespace onggi::app
