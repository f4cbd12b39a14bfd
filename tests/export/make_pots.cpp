// make_pots DIR: writes the sample pots as files for the checks that other programs make (npm, browser,
// admesh), and the expected results as DIR/pots.json.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/asset/mp4_film.h"
#include "engine/asset/webp_film.h"
#include "game/exporter/export.h"
#include "game/exporter/pot_solid.h"
#include "game/exporter/studio_export.h"
#include "game/look/pot_drawing.h"
#include "game/look/pot_pictures.h"
#include "game/wheel/clay_look.h"
#include "tests/support/pot_samples.h"
#include "tests/support/studio_samples.h"

namespace {

using namespace onggi;

bool write(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    for (const std::byte byte : bytes)
        file.put(static_cast<char>(byte));
    file.close();
    return file.good();
}

bool write(const std::filesystem::path& path, const Result<std::vector<std::byte>>& bytes) {
    if (bytes && write(path, *bytes)) return true;
    fmt::print(stderr, "{}: {}\n", path.string(), bytes ? "cannot be written" : bytes.error().message);
    return false;
}

bool write_print(const std::filesystem::path& place, const Result<exporter::PotFile>& pot) {
    return write(place.string() + ".stl", exporter::encode_pot(pot, exporter::ExportKind::kStl)) &&
           write(place.string() + ".3mf", exporter::encode_pot(pot, exporter::ExportKind::k3mf));
}

void say(const std::string& name, const exporter::PotSolid& built) {
    fmt::print("{}: {} rings, {} rows of {}, {} triangles, tolerance {} mm, scale {:.6f}\n", name,
               built.rings, built.rows, built.corners, built.mesh.triangle_count(), built.tolerance_mm,
               built.across_scale);
}

bool add_paper_pot(const std::filesystem::path& folder, const support::PotSample& pot,
                   nlohmann::json& expected) {
    const auto file = exporter::pot_file(pot.rings());
    if (!write_print(folder / pot.name, file) ||
        !write(folder / (pot.name + ".glb"), exporter::encode_pot(file, exporter::ExportKind::kGlb)) ||
        !write(folder / (pot.name + ".usdz"), exporter::encode_pot(file, exporter::ExportKind::kUsdz)))
        return false;
    const auto built = exporter::build_pot_solid(pot.rings());
    if (!built) return false;
    expected.push_back({{"name", pot.name},
                        {"height_m", pot.height_mm * 1e-3},
                        {"diameter_m", 2e-3 * *std::max_element(pot.radii_mm.begin(), pot.radii_mm.end())},
                        {"volume_m3", pot.rings().volume_mm3 * 1e-9},
                        {"hand_made", pot.hand_made},
                        {"triangles", built->mesh.triangle_count()}});
    say(pot.name, *built);
    return true;
}

// The GLB has the pot's look, as what visitors take home.
bool add_studio_pot(const std::filesystem::path& folder, const support::StudioSample& pot,
                    nlohmann::json& expected) {
    const clay::ClayBody body = pot.clay.lump().body;
    const auto worn = look::lathe_look(wheel::clay_material(body, pot.stage), "clay");
    const auto drawing =
        look::pot_drawing(pot.clay, pot.stage, ui::VectorKind::kSvg, "House of Clay. CC BY 4.0");
    std::ofstream(folder / (pot.name + ".json")) << exporter::pot_json(pot.clay);
    if (!write_print(folder / pot.name, exporter::pot_file(pot.clay, pot.stage)) ||
        !write(folder / (pot.name + ".svg"), drawing) ||
        !write(folder / (pot.name + ".pdf"),
               look::pot_drawing(pot.clay, pot.stage, ui::VectorKind::kPdf, "House of Clay. CC BY 4.0")) ||
        !write(folder / (pot.name + ".glb"), look::dressed_glb(pot.clay, pot.stage, worn)) ||
        !write(
            folder / (pot.name + ".usdz"),
            exporter::encode_pot(look::dressed_pot(pot.clay, pot.stage, worn), exporter::ExportKind::kUsdz)))
        return false;
    const double scale = 1e-3 * clay::shrunk_scale(body, pot.stage);
    const auto built = exporter::viewed_solid(pot.clay, pot.stage);
    if (!built) return false;
    const auto outer = pot.clay.outer_mm();
    // Clay off its axis is wider across than twice its radius; the browser's check is for calm pots.
    expected.push_back({{"name", pot.name},
                        {"height_m", pot.clay.height_mm() * scale},
                        {"diameter_m", 2.0 * *std::max_element(outer.begin(), outer.end()) * scale},
                        {"volume_m3", pot.clay.volume_mm3() * scale * scale * scale},
                        {"hand_made", pot.calm && pot.off_axis_mm == 0.0},
                        {"dressed", true},
                        {"triangles", built->mesh.triangle_count()}});
    say(pot.name, *built);
    return true;
}

// A pot with all that its files can say, as GLB, USDZ, 3MF, STL, PNG and an animated WebP.
bool add_told_pot(const std::filesystem::path& folder, const support::StudioSample& pot,
                  nlohmann::json& expected) {
    const exporter::PotStory story{
        .about = {.title = {{"en", "Moon jar, celadon"},
                            {"ko", "달항아리, 청자"},
                            {"ar", "جرة القمر، سيلادون"}},
                  .description = {{"en", "Thrown & fired."}, {"ko", "빚고 구웠습니다."}},
                  .rights = {{"en", "CC BY 4.0"}, {"ko", "저작자표시 4.0"}},
                  .publisher = {{"en", "House of Clay"}, {"ko", "흙의 집"}},
                  .date = "2026-11-28",
                  .identifier = "onggi-session:0123456789abcdef",
                  .relation = "Moon jar, British Museum (1333756)",
                  .tool = std::string(exporter::program_name())},
        .extras = {{"glaze", "celadon"}, {"date", "2026-11-28"}, {"session_hash", "0123456789abcdef"}}};
    const std::filesystem::path place = folder / "told";
    const auto worn = look::lathe_look(wheel::clay_material(pot.clay.lump().body, pot.stage), "clay");
    asset::Image picture{.width = 64, .height = 64, .rgba = std::vector<std::uint8_t>(64 * 64 * 4, 200)};
    const auto png = asset::encode_png(picture);
    auto film = asset::WebpFilm::create({.width = 64, .height = 64});
    auto video = asset::Mp4Film::create({.width = 64, .height = 64});
    bool is_filmed = film && video && film->add(picture, 80) && video->add(picture);
    picture.rgba[0] = 0;
    is_filmed = is_filmed && film->add(picture, 80) && video->add(picture);
    if (!png || !is_filmed) return false;
    const auto webp = film->finish();
    const auto mp4 = video->finish();
    const auto built = exporter::viewed_solid(pot.clay, pot.stage);
    const auto drawing = look::pot_drawing(pot.clay, pot.stage, ui::VectorKind::kSvg);
    if (!webp || !mp4 || !drawing || !built ||
        !write_print(place, exporter::pot_file(pot.clay, pot.stage, story)) ||
        !write(folder / "told.png", asset::picture_about(*png, story.about)) ||
        !write(folder / "told.webp", asset::picture_about(*webp, story.about)) ||
        !write(folder / "told.mp4", asset::picture_about(*mp4, story.about)) ||
        !write(folder / "told.svg", asset::picture_about(*drawing, story.about)) ||
        !write(folder / "told.glb", look::dressed_glb(pot.clay, pot.stage, worn, story)) ||
        !write(folder / "told.usdz", exporter::encode_pot(look::dressed_pot(pot.clay, pot.stage, worn, story),
                                                          exporter::ExportKind::kUsdz)))
        return false;
    expected.push_back(
        {{"name", "told"},
         {"height_m", 1e-3 * clay::measure_pot(pot.clay.rings(), pot.clay.lump().body, pot.stage).height_mm},
         {"hand_made", false},
         {"dressed", true},
         {"has_rights", true},
         {"triangles", built->mesh.triangle_count()}});
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "expected: make_pots DIR\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    nlohmann::json expected = nlohmann::json::array();
    for (const support::PotSample& pot : support::all_pot_samples()) {
        if (!add_paper_pot(folder, pot, expected)) return 1;
    }
    for (const support::StudioSample& pot : support::all_studio_samples()) {
        if (!add_studio_pot(folder, pot, expected)) return 1;
    }
    if (!add_told_pot(folder, support::all_studio_samples().front(), expected)) return 1;
    std::ofstream list(folder / "pots.json");
    list << expected.dump(1) << '\n';
    list.close();
    return list.good() ? 0 : 1;
}
