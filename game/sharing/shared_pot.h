// A pot as it is handed to the outbox: files, measures, words. Lengths mm. Any thread; plain values.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace onggi::sharing {

// A file that is on the disk already, or its bytes; neither: there is none, and no button for it.
struct FileContent {
    std::filesystem::path path{};
    std::vector<std::byte> bytes{};

    [[nodiscard]] bool is_given() const { return !path.empty() || !bytes.empty(); }
};

struct OutlinePoint {
    double radius_mm = 0.0;
    double height_mm = 0.0;
};

// Words of one language that are this pot's own; what is empty is left out.
struct PotWords {
    std::string glaze{};         // "Celadon", below the title
    std::string nearest_name{};  // the museum's pot that it is closest to: "Moon jar"
    std::string nearest_line{};  // "Joseon, 18th c.\nNational Museum of Korea"
};

struct SharedPot {
    // Pictures are PNG, JPEG or WebP, told apart by their bytes.
    FileContent picture{};     // to keep; also shown where there is no poster
    FileContent poster{};      // shown first, small: some 20 kB
    FileContent model_glb{};   // 3D model
    FileContent print_stl{};   // for printing
    FileContent print_3mf{};   // for printing
    FileContent film{};        // WebP that moves, how it was made
    FileContent film_still{};  // shown until the film is asked for
    double film_s = 0.0;

    // The fired pot's wall: up the outside from the foot, and down the inside from the rim, which may be
    // missing. Without an outside the page shows the poster only.
    std::vector<OutlinePoint> outside{};
    std::vector<OutlinePoint> inside{};
    // Wrapped round the outside: its columns go round, its rows from the rim down to the foot in equal steps
    // along the outline. Where there is none, the colour.
    FileContent surface{};
    std::array<double, 3> colour_linear{0.34, 0.2, 0.12};  // linear light, 0 to 1
    double gloss = 0.5;                                    // 0 matt to 1 glass

    // Of 0: left out.
    double height_mm = 0.0;
    double width_mm = 0.0;
    double mass_g = 0.0;
    double capacity_ml = 0.0;

    std::vector<PotWords> words{};                // one for each language of the outbox, in its order
    std::size_t first_language = 0;               // the visitor's
    std::vector<OutlinePoint> nearest_outside{};  // of the museum's pot, from the foot
    std::string gallery_name{};  // "2026-11-21/pot-014": what to withdraw when it is deleted there
};

}  // namespace onggi::sharing
