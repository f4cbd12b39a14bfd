// A kiosk's progress in keeping a pot, derived from the files on disk, so that a kill can fall between any
// two files and during a write. `Gallery::keep` writes them in this order.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace onggi::stress {

enum class Stage { kNothing, kFolder, kSession, kGlb, kStl, kPicture, kKept };
constexpr int kStages = 7;

inline const char* name_of(Stage stage) {
    constexpr std::array<const char*, kStages> kNames{"before anything is written",
                                                      "in an empty folder",
                                                      "behind pot.onggi",
                                                      "behind pot.glb",
                                                      "behind pot.stl",
                                                      "behind pot.png",
                                                      "on the shelf"};
    return kNames[static_cast<std::size_t>(stage)];
}

// `pots`: complete ones in the gallery at the kiosk's start, which removes incomplete ones.
inline Stage stage_of(const std::filesystem::path& gallery, std::size_t pots) {
    namespace fs = std::filesystem;
    std::error_code error;  // a folder that is renamed while it is looked at seems empty, once
    std::size_t found = 0;
    fs::path part;
    for (fs::directory_iterator day(gallery, error), end; !error && day != end; day.increment(error)) {
        if (!day->is_directory(error)) continue;
        for (fs::directory_iterator pot(day->path(), error); !error && pot != end; pot.increment(error)) {
            if (!pot->path().filename().string().starts_with("pot-")) continue;
            if (pot->path().extension() == ".part") {
                part = pot->path();
            } else {
                ++found;
            }
        }
    }
    if (found > pots) return Stage::kKept;
    if (part.empty()) return Stage::kNothing;
    Stage stage = Stage::kFolder;
    for (const auto& [name, behind] :
         {std::pair("pot.onggi", Stage::kSession), std::pair("pot.glb", Stage::kGlb),
          std::pair("pot.stl", Stage::kStl), std::pair("pot.png", Stage::kPicture)})
        if (fs::exists(part / name, error)) stage = behind;
    return stage;
}

// Whether the process has an unnamed file of a pot open, that is, it is writing one.
inline bool is_writing_a_pot(int process) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (fs::directory_iterator open("/proc/" + std::to_string(process) + "/fd", error), end;
         !error && open != end; open.increment(error)) {
        std::error_code gone;
        const std::string place = fs::read_symlink(open->path(), gone).string();
        if (place.find(".part/") != std::string::npos) return true;
    }
    return false;
}

}  // namespace onggi::stress
