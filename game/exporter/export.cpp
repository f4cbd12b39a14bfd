// See export.h. Any thread but the haptic one.
#include "game/exporter/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "engine/asset/stl.h"
#include "engine/asset/three_mf.h"
#include "engine/asset/usdz.h"
#include "game/exporter/pot_solid.h"
#include "game/finish/clay_body.h"

namespace onggi::exporter {
namespace {

struct KnownEnding {
    std::string_view ending;
    ExportKind kind;
};
constexpr std::array<KnownEnding, 4> kKnownEndings{{{".glb", ExportKind::kGlb},
                                                    {".stl", ExportKind::kStl},
                                                    {".3mf", ExportKind::k3mf},
                                                    {".usdz", ExportKind::kUsdz}}};
constexpr const char* kProgram = "Onggi " ONGGI_VERSION;

char to_lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Stoneware as on the wheel, without the gloss of water.
asset::Material stoneware() {
    return {.name = "stoneware",
            .base_colour_linear = finish::kStoneware.raw,
            .roughness = 0.62,
            .metallic = 0.0};
}

// Its description is for the person who prints it; the story comes first.
asset::ThreeMfWords three_mf_words(const PotFile& file) {
    const asset::About& about = file.content.about;
    const std::string story = first_of(about.description);
    return {.title = file.title,
            .description = story.empty() || file.note.empty() ? story + file.note : story + ' ' + file.note,
            .application = kProgram,
            .copyright = first_of(about.publisher),
            .licence_terms = first_of(about.rights),
            .creation_date = about.date};
}

}  // namespace

Result<ExportKind> export_kind_of(std::string_view path) {
    for (const auto& [ending, kind] : kKnownEndings) {
        if (path.size() <= ending.size()) continue;
        const std::string_view tail = path.substr(path.size() - ending.size());
        if (std::equal(tail.begin(), tail.end(), ending.begin(),
                       [](char a, char b) { return to_lower(a) == b; })) {
            return kind;
        }
    }
    std::string known;
    for (const KnownEnding& one : kKnownEndings)
        known += fmt::format("{}{}",
                             known.empty()                   ? ""
                             : &one == &kKnownEndings.back() ? " or "
                                                             : ", ",
                             one.ending);
    return bad_input(fmt::format("{}: expected a name that ends in {}", path, known));
}

asset::GltfContent pot_content(std::string name, asset::Mesh mesh, asset::Material material,
                               std::vector<asset::Extra> measures, PotStory story) {
    if (!story.about.is_empty()) name = first_of(story.about.title);
    std::move(story.extras.begin(), story.extras.end(), std::back_inserter(measures));
    return {.name = std::move(name),
            .generator = kProgram,
            .mesh = std::move(mesh),
            .material = std::move(material),
            .extras = std::move(measures),
            .about = std::move(story.about)};
}

std::string_view program_name() {
    return kProgram;
}

std::string printing_note(double thinnest_wall_mm, double height_mm, double width_mm) {
    const double fits = std::min(1.0, kPrintedSideMm / std::max(height_mm, width_mm));
    if (!(thinnest_wall_mm > 0.0 && fits * thinnest_wall_mm < kThinnestPrintedMm)) return {};
    const std::string printed =
        fits < 1.0 ? fmt::format(", {:.1f} mm if the pot is scaled to {:.0f} % for a printer of {:.0f} mm",
                                 fits * thinnest_wall_mm, std::floor(100.0 * fits), kPrintedSideMm)
                   : "";
    return fmt::format(
        "Thinnest wall {:.1f} mm{}: below {:.0f} mm prints break. At {:.0f} % and above all walls are thick "
        "enough.",
        thinnest_wall_mm, printed, kThinnestPrintedMm,
        std::ceil(100.0 * kThinnestPrintedMm / thinnest_wall_mm));
}

Result<PotFile> pot_file(const PotRings& rings) {
    Result<PotSolid> pot = build_pot_solid(rings);
    if (!pot) return pot.error();
    double widest_mm = 0.0;
    for (const double radius_mm : rings.outer_mm)
        widest_mm = std::max(widest_mm, 2.0 * radius_mm);
    return PotFile{.content = pot_content("Pot", std::move(pot->mesh), stoneware(),
                                          {{"height_mm", rings.height_mm()},
                                           {"max_diameter_mm", widest_mm},
                                           {"volume_mm3", rings.volume_mm3}}),
                   .title = fmt::format("Onggi pot, {:.1f} mm high", rings.height_mm())};
}

Result<std::vector<std::byte>> encode_pot(const Result<PotFile>& file, ExportKind kind,
                                          const asset::Image* picture) {
    if (!file) return file.error();
    const asset::Mesh& mesh = file->content.mesh;
    switch (kind) {
        case ExportKind::kGlb:
            return asset::encode_glb(file->content);
        case ExportKind::kStl:
            return asset::encode_stl(mesh, file->title);
        case ExportKind::k3mf:
            return asset::encode_3mf(mesh, three_mf_words(*file), picture);
        case ExportKind::kUsdz:
            return asset::encode_usdz(file->content);
    }
    return bad_input("pot: expected a format, found none");
}

}  // namespace onggi::exporter
