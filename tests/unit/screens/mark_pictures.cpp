// Paints what was drawn on pots under each of the six glazes, to be looked at: mark_pictures FOLDER.
#include <fmt/format.h>

#include <filesystem>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "game/screens/pots/pot_picture.h"
#include "tests/unit/screens/flatten.h"
#include "tests/unit/screens/sample_decorations.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

// Pots beside each other, one a glaze.
asset::Image sheet(const pot::Section& shape, float px_per_mm) {
    constexpr float kElevationRad = 0.16F;
    constexpr int kMarginPx = 12;
    asset::Image image;
    std::vector<ui::Painting> pots;
    for (int glaze = 0; glaze < finish::kGlazeCount; ++glaze)
        pots.push_back(paint_pot(shape, finish::glaze_at(glaze), px_per_mm, kElevationRad).painting);
    image.width = (pots[0].width + kMarginPx) * finish::kGlazeCount + kMarginPx;
    image.height = pots[0].height + 2 * kMarginPx;
    image.rgba.assign(static_cast<std::size_t>(image.width * image.height) * 4, 60);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
    for (std::size_t i = 0; i < pots.size(); ++i) {
        const int left = kMarginPx + static_cast<int>(i) * (pots[i].width + kMarginPx);
        for (int y = 0; y < pots[i].height; ++y) {
            for (int x = 0; x < pots[i].width; ++x) {
                const auto from = static_cast<std::size_t>(y * pots[i].width + x) * 4;
                const auto to = static_cast<std::size_t>((y + kMarginPx) * image.width + left + x) * 4;
                const int under = 255 - pots[i].rgba[from + 3];
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    image.rgba[to + channel] = static_cast<std::uint8_t>(
                        pots[i].rgba[from + channel] + image.rgba[to + channel] * under / 255);
                }
            }
        }
    }
    return image;
}

}  // namespace
}  // namespace onggi::screens

int main(int argc, char** argv) {
    using namespace onggi;
    using decoration::Motif;
    using decoration::Technique;
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out/marks";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const pot::Section jar = screens::sample_exhibits()->at(3).shape;  // 300 mm or so
    const double tall = jar.height_mm();
    const auto write = [&](const char* name, const pot::Section& shape, float px_per_mm) {
        const auto png = asset::encode_png(screens::sheet(shape, px_per_mm));
        return png && files::write_file_atomically(folder / name, *png);
    };
    bool done = write("materials.png", screens::sheet_cylinder(), 3.4F);
    for (const auto& [name, motif] :
         {std::pair("crane.png", Motif::kCrane), std::pair("cloud.png", Motif::kCloud),
          std::pair("chrysanthemum.png", Motif::kChrysanthemum), std::pair("fish.png", Motif::kFish),
          std::pair("grass.png", Motif::kGrass), std::pair("wave.png", Motif::kWave)}) {
        const auto repeats = static_cast<std::uint8_t>(motif == Motif::kWave ? 8 : 5);
        done = write(name,
                     screens::drawn_on(jar, {screens::motif_round(motif, 0.5 * tall, 0.4 * tall, repeats)}),
                     1.0F) &&
               done;
    }
    return done ? 0 : 1;
}
