// Films visitors at the whole kiosk: a sheet of pictures for each, for inspection. Not a test.
//   visitors_film_strip FOLDER                           a lesson, a bowl, a vase, a scribble
//   visitors_film_strip FOLDER KIND SEED [FROM_S TO_S]   one visitor, or some seconds of the visit
// Each visit goes on to the kept pot.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "engine/files/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/visitors/filmed_rig.h"
#include "tests/visitors/people.h"

namespace onggi::visitors {
namespace {

constexpr std::size_t kAcross = 4;
constexpr std::size_t kPictures = 24;

struct Take {
    Kind kind = Kind::kLesson;
    std::uint64_t seed = 1;
    double from_s = 0.0;
    double to_s = 1e9;
};

// Selects evenly spaced shots.
std::vector<const FilmedRig::Shot*> chosen(const std::vector<FilmedRig::Shot>& film, const Take& take) {
    std::vector<const FilmedRig::Shot*> all;
    for (const FilmedRig::Shot& shot : film)
        if (shot.at_s >= take.from_s && shot.at_s <= take.to_s) all.push_back(&shot);
    if (all.size() <= kPictures) return all;
    std::vector<const FilmedRig::Shot*> some;
    for (std::size_t i = 0; i < kPictures; ++i)
        some.push_back(all[i * (all.size() - 1) / (kPictures - 1)]);
    return some;
}

asset::Image sheet_of(const std::vector<const FilmedRig::Shot*>& shots) {
    const std::size_t down = (shots.size() + kAcross - 1) / kAcross;
    asset::Image sheet{.width = static_cast<int>(kAcross) * kFilmWidth,
                       .height = static_cast<int>(std::max<std::size_t>(down, 1)) * kFilmHeight,
                       .rgba = {}};
    sheet.rgba.assign(4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), 0);
    constexpr std::size_t kRow = 4 * static_cast<std::size_t>(kFilmWidth);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        for (std::size_t y = 0; y < static_cast<std::size_t>(kFilmHeight); ++y) {
            const auto from = shots[i]->picture.rgba.begin() + static_cast<std::ptrdiff_t>(y * kRow);
            const std::size_t to =
                (i / kAcross * static_cast<std::size_t>(kFilmHeight) + y) * kAcross + i % kAcross;
            std::copy_n(from, kRow, sheet.rgba.begin() + static_cast<std::ptrdiff_t>(to * kRow));
        }
    }
    return sheet;
}

bool film(const std::filesystem::path& folder, const Take& take) {
    constexpr double kEveryS = 1.0 / 12.0;
    const test::TemporaryFolder gallery;
    FilmedRig rig(gallery.path(), kEveryS);
    static_cast<void>(throw_a_pot(take.kind, take.seed, {}, rig));
    if (!rig.finishes()) fmt::print(stderr, "visitors_film_strip: the visit ended before its pot was kept\n");
    const auto shots = chosen(rig.film(), take);
    std::string name(kKindNames[static_cast<std::size_t>(take.kind)]);
    std::replace(name.begin(), name.end(), ' ', '-');
    const auto path = folder / fmt::format("{}-{}.png", name, take.seed);
    const auto png = asset::encode_png(sheet_of(shots));
    if (!png || !files::write_file_atomically(path, *png)) {
        fmt::print(stderr, "visitors_film_strip: {}: cannot be written\n", path.string());
        return false;
    }
    fmt::print("{}, s:", path.string());
    for (const FilmedRig::Shot* shot : shots)
        fmt::print(" {:.2f}{}", shot->at_s, shot->pressed ? "*" : "");
    fmt::print("\n");
    return true;
}

}  // namespace
}  // namespace onggi::visitors

int main(int count, char** words) {
    using namespace onggi::visitors;
    if (count < 2 || count == 3) {
        fmt::print(stderr, "visitors_film_strip FOLDER [KIND SEED [FROM_S TO_S]]\n");
        return 2;
    }
    std::filesystem::create_directories(words[1]);
    if (count == 2) {
        bool all = true;
        for (const Kind kind : {Kind::kLesson, Kind::kBowl, Kind::kVase, Kind::kScribble})
            all = film(words[1], {.kind = kind, .seed = 3}) && all;
        return all ? 0 : 1;
    }
    const auto kind = std::find(kKindNames.begin(), kKindNames.end(), words[2]);
    if (kind == kKindNames.end()) {
        fmt::print(stderr, "visitors_film_strip: {}: expected a kind of people.h\n", words[2]);
        return 2;
    }
    Take take{.kind = static_cast<Kind>(kind - kKindNames.begin()),
              .seed = std::strtoull(words[3], nullptr, 10)};
    if (count > 5) {
        take.from_s = std::strtod(words[4], nullptr);
        take.to_s = std::strtod(words[5], nullptr);
    }
    return film(words[1], take) ? 0 : 1;
}
