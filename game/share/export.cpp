// See export.h. Any thread but the haptic one.
#include "game/share/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "engine/asset/gltf.h"
#include "engine/asset/stl.h"
#include "game/share/pot_mesh.h"
#include "game/share/pot_profile.h"

namespace onggi::share {
namespace {

struct KnownEnding {
    std::string_view ending;
    ExportKind kind;
};
constexpr std::array<KnownEnding, 2> kKnownEndings{{{".glb", ExportKind::kGlb}, {".stl", ExportKind::kStl}}};

char to_lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Stoneware as the wheel shows it, without the gloss of its water.
asset::Material stoneware() {
    return {.name = "stoneware",
            .base_colour_linear = dvec3(0.36, 0.29, 0.215),
            .roughness = 0.62,
            .metallic = 0.0};
}

double max_diameter_mm(const PotShape& shape) {
    return 2.0 * double{*std::max_element(shape.radii_mm.begin(), shape.radii_mm.end())};
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
        known += fmt::format("{}{}", known.empty() ? "" : " or ", one.ending);
    return bad_input(fmt::format("{}: expected a name that ends in {}", path, known));
}

Result<std::vector<std::byte>> export_pot(const PotShape& shape, ExportKind kind) {
    if (const Result<void> good = check_shape(shape); !good) return good.error();
    PotMesh pot = build_pot_mesh(shape);
    if (kind == ExportKind::kStl) {
        return asset::encode_stl(pot.mesh, fmt::format("Onggi pot, {:.1f} mm high", shape.height_mm));
    }
    asset::GltfContent content;
    content.name = "pot";
    content.generator = "Onggi " ONGGI_VERSION;
    content.mesh = std::move(pot.mesh);
    content.material = stoneware();
    content.extras = {{"height_mm", shape.height_mm},
                      {"max_diameter_mm", max_diameter_mm(shape)},
                      {"volume_mm3", clay_volume_mm3(shape)}};
    return asset::encode_glb(content);
}

}  // namespace onggi::share
