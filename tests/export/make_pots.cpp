// make_pots DIR: writes the sample pots as files for the checks that other programs make (npm, browser,
// admesh), and what those must find in them as DIR/pots.json.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "game/share/export.h"
#include "game/share/pot_mesh.h"
#include "tests/support/pot_samples.h"

namespace {

using namespace onggi;

bool write(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    for (const std::byte byte : bytes)
        file.put(static_cast<char>(byte));
    file.close();
    return file.good();
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
        for (const auto& [kind, ending] :
             {std::pair{share::ExportKind::kGlb, ".glb"}, {share::ExportKind::kStl, ".stl"}}) {
            const Result<std::vector<std::byte>> bytes = share::export_pot(pot.shape(), kind);
            const std::filesystem::path path = folder / (pot.name + ending);
            if (!bytes || !write(path, *bytes)) {
                fmt::print(stderr, "{}: {}\n", path.string(),
                           bytes ? "cannot be written" : bytes.error().message);
                return 1;
            }
        }
        const share::PotMesh built = share::build_pot_mesh(pot.shape());
        expected.push_back(
            {{"name", pot.name},
             {"height_m", pot.height_mm * 1e-3},
             {"diameter_m", 2e-3 * *std::max_element(pot.radii_mm.begin(), pot.radii_mm.end())},
             {"volume_m3", share::clay_volume_mm3(pot.shape()) * 1e-9},
             {"hand_made", pot.hand_made},
             {"triangles", built.mesh.triangle_count()}});
        fmt::print("{}: {} elements, {} rings of {}, {} triangles, tolerance {} mm, scale {:.6f}\n", pot.name,
                   built.elements, built.profile.size(), built.sectors, built.mesh.triangle_count(),
                   built.tolerance_mm, built.radius_scale);
    }
    std::ofstream list(folder / "pots.json");
    list << expected.dump(1) << '\n';
    list.close();
    return list.good() ? 0 : 1;
}
