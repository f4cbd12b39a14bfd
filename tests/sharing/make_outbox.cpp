// make_outbox SESSION|SAMPLE FOLDER [OPTION FILE ...]: puts the pot that a session left, or one of
// tests/support/studio_samples.h by its name, into the outbox FOLDER/box, as the kiosk does, with Korean,
// English and Arabic pages, for checks that other programs make; and copies the published files to
// FOLDER/pot.glb and so on. Prints the code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "game/app/command_line/performance.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/keeping/kiosk_share.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/app/replay/session_marks.h"
#include "game/exporter/studio_export.h"
#include "game/finish/glaze.h"
#include "game/haptic/pot_copy.h"
#include "tests/support/studio_samples.h"
#include "tests/unit/screens/sample_decorations.h"

namespace {

using namespace onggi;

struct Words {
    std::string session;
    std::filesystem::path folder;
    std::string glaze = "celadon";
    bool decorated = false;  // cranes all round it, between two bands of black slip
    bool banded = false;     // thin lines of cobalt
    std::string poster;
    std::string film;
    std::string mp4;
    std::string drawing;
    std::string surface;
    std::string url;
};

decoration::Marks cranes_on(const clay::StudioClay& clay) {
    using decoration::Technique;
    const decoration::Wall wall = app::wall_of(haptic::pot_of(haptic::HapticState{clay}));
    const double tall_mm = double{wall.height_mm};
    decoration::Strokes strokes{
        screens::motif_round(decoration::Motif::kCrane, 0.55 * tall_mm, 0.34 * tall_mm, 5)};
    for (const double height : {0.3, 0.78}) {
        strokes.push_back(screens::stroke_round(Technique::kInlay, height * tall_mm, 2.0));
        strokes.back().slip = decoration::Slip::kBlack;
    }
    return decoration::Canvas::of(wall, strokes).value().marks();
}

decoration::Marks lines_on(const clay::StudioClay& clay) {
    constexpr double kThinMm = 0.8;
    const decoration::Wall wall = app::wall_of(haptic::pot_of(haptic::HapticState{clay}));
    decoration::Strokes strokes;
    for (int i = 1; i < 10; ++i) {
        strokes.push_back(
            screens::stroke_round(decoration::Technique::kCobalt, 0.1 * i * double{wall.height_mm}, kThinMm));
    }
    return decoration::Canvas::of(wall, strokes).value().marks();
}

Result<std::optional<clay::StudioClay>> clay_of(const std::string& session) {
    for (const support::StudioSample& sample : support::all_studio_samples())
        if (sample.name == session) return std::optional(sample.clay);
    return app::start_pot({.on = session});
}

Result<sharing::ShareCode> put(const Words& words) {
    auto settings = app::load_settings("");
    if (!settings) return settings.error();
    settings->config.sharing.outbox = (words.folder / "box").string();
    settings->config.sharing.public_url = words.url;
    const auto clay = clay_of(words.session);
    if (!clay) return clay.error();
    screens::FiredPot fired = app::fired_pot(**clay, settings->targets, settings->relatives);
    if (words.decorated) fired.shape.marks = std::make_shared<const decoration::Marks>(cranes_on(**clay));
    if (words.banded) fired.shape.marks = std::make_shared<const decoration::Marks>(lines_on(**clay));
    const finish::GlazeMaterial* material = finish::find_glaze(words.glaze);
    if (material == nullptr) return bad_input("make_outbox: expected a glaze, found " + words.glaze);
    const int glaze = static_cast<int>(material->glaze);
    constexpr int kPortraitPx = 1024;
    sharing::SharedPot pot = app::shared_pot(fired, glaze, *settings, settings->rules.default_language);
    const ui::Painting painting = app::portrait(fired.shape, glaze, kPortraitPx);
    auto picture = asset::encode_png(
        {.width = painting.width, .height = painting.height, .rgba = painting.rgba});  // opaque
    auto model = exporter::encode_pot(app::glazed_model(**clay, *material, fired.shape.marks.get()),
                                      exporter::ExportKind::kGlb);
    auto print =
        exporter::encode_pot(exporter::pot_file(**clay, clay::Firing::kGlaze), exporter::ExportKind::kStl);
    if (!picture) return picture.error();
    if (!model) return model.error();
    if (!print) return print.error();
    pot.picture.bytes = *picture;
    pot.model_glb.bytes = *model;
    pot.print_stl.bytes = *print;
    constexpr int kPosterPx = 720;
    auto poster = asset::encode_png(app::share_poster(fired.shape, glaze, kPosterPx));
    if (!poster) return poster.error();
    if (words.poster.empty()) {
        pot.poster.bytes = *poster;
    } else {
        pot.poster.path = words.poster;
    }
    pot.film.path = words.film;
    pot.film_mp4.path = words.mp4;
    pot.drawing_svg.path = words.drawing;
    pot.film_still.path = words.film.empty() ? "" : words.poster;
    pot.film_s = 8.0;
    pot.surface.path = words.surface;
    if (const asset::Image wrapped = app::share_surface(fired.shape, glaze);
        words.surface.empty() && wrapped.width > 0) {
        auto surface = asset::encode_png(wrapped);
        if (!surface) return surface.error();
        pot.surface.bytes = std::move(*surface);
    }
    std::filesystem::create_directories(words.folder);
    for (const auto& [name, bytes] : {std::pair{"pot.png", &pot.picture.bytes},
                                      {"poster.png", &*poster},
                                      {"pot.glb", &pot.model_glb.bytes},
                                      {"pot.stl", &pot.print_stl.bytes}})
        if (auto written = files::write_file_atomically(words.folder / name, *bytes); !written)
            return written.error();
    auto outbox = sharing::Outbox::open(app::outbox_options(*settings));
    if (!outbox) return outbox.error();
    const auto begun = std::chrono::steady_clock::now();
    auto code = outbox->put(pot, app::share_time_now(settings->config));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    fmt::print(stderr, "put in {:.3f} s\n", took.count());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program{"An outbox with a pot in it", "make_outbox"};
    Words words;
    program.add_option("SESSION", words.session)->required();
    program.add_option("FOLDER", words.folder)->required();
    program.add_option("--glaze", words.glaze);
    program.add_flag("--decorated", words.decorated);
    program.add_flag("--banded", words.banded);
    program.add_option("--poster", words.poster);
    program.add_option("--film", words.film);
    program.add_option("--mp4", words.mp4);
    program.add_option("--drawing", words.drawing);
    program.add_option("--surface", words.surface);
    program.add_option("--url", words.url);
    CLI11_PARSE(program, argc, argv);
    const auto code = put(words);
    if (!code) {
        fmt::print(stderr, "{}\n", code.error().message);
        return 1;
    }
    fmt::print("{}\n", code->text());
    return 0;
}
