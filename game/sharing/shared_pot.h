// A pot for the outbox: files, measures, words. Lengths mm. Any thread; plain values.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace onggi::sharing {

// A file on disk, or its bytes; without either the page has no button for it.
struct FileContent {
    std::filesystem::path path{};
    std::vector<std::byte> bytes{};

    [[nodiscard]] bool is_given() const { return !path.empty() || !bytes.empty(); }
};

struct OutlinePoint {
    double radius_mm = 0.0;
    double height_mm = 0.0;
};

// The pot's own words in one language; empty ones are left out.
struct PotWords {
    std::string glaze{};         // "Celadon", below the title
    std::string nearest_name{};  // the most similar museum pot: "Moon jar"
    std::string nearest_line{};  // "Joseon, 18th c.\nNational Museum of Korea"
};

// The centre of a pot that is not round at a height, in the page's frame: x to the right, z to the eye.
struct AxisPoint {
    double height_mm = 0.0;
    double x_mm = 0.0;
    double z_mm = 0.0;
};

struct SharedPot {
    // Pictures are PNG, JPEG or WebP, detected from their bytes.
    FileContent picture{};     // to save; also the poster if there is none
    FileContent poster{};      // shown first, small: some 20 kB
    FileContent model_glb{};   // 3D model
    FileContent model_usdz{};  // the same for iPhones; offered by https only
    FileContent print_stl{};   // for printing
    FileContent print_3mf{};   // for printing
    FileContent film{};        // animated WebP of the making
    FileContent film_mp4{};    // the same as MP4
    FileContent film_still{};  // shown until the film starts
    FileContent drawing_svg{};
    FileContent drawing_pdf{};
    FileContent measures_json{};
    double film_s = 0.0;

    // The fired pot's wall: up the outside from the foot, and down the inside from the rim; the inside may be
    // empty. Without an outside the page shows only the poster.
    std::vector<OutlinePoint> outside{};
    std::vector<OutlinePoint> inside{};
    std::vector<AxisPoint> axis{};  // from foot to rim; empty: round
    // Rows evenly spaced from foot to rim, added to both walls' radii: directions evenly spaced,
    // counter-clockwise from the right as seen from above. Empty: each row is round about its centre.
    std::vector<std::vector<double>> dents_mm{};
    double reach_mm = 0.0;  // of a pot that is not round: largest distance from the wheel's axis
    // Texture wrapped round the outside: columns go round, rows go from the rim down to the foot in equal
    // steps along the outline. Without it the page uses the colour.
    FileContent surface{};
    std::array<double, 3> colour_linear{0.34, 0.2, 0.12};  // linear light, 0 to 1
    double gloss = 0.5;                                    // 0 matt to 1 glass

    // Measures; 0 is left out.
    double height_mm = 0.0;
    double width_mm = 0.0;
    double mass_g = 0.0;
    double capacity_ml = 0.0;

    std::vector<PotWords> words{};                // one for each language of the outbox, in its order
    std::size_t first_language = 0;               // index of the visitor's language
    std::vector<OutlinePoint> nearest_outside{};  // of the museum's pot, from the foot
    std::string gallery_name{};  // "2026-11-21/pot-014": deleting it in the gallery withdraws the shared pot
};

}  // namespace onggi::sharing
