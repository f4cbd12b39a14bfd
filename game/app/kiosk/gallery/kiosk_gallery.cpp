#include "game/app/kiosk/gallery/kiosk_gallery.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/list_folder.h"
#include "engine/core/number_in.h"
#include "engine/core/within_memory.h"
#include "engine/files/atomic_file.h"
#include "engine/files/atomic_folder.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/system/wall_clock.h"
#include "game/exporter/studio_export.h"
#include "game/look/pot_pictures.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

}  // namespace

int pot_number(std::string_view name) {
    constexpr std::string_view kPrefix = "pot-";
    if (!name.starts_with(kPrefix)) return 0;
    return number_in<int>(name.substr(kPrefix.size())).value_or(0);
}

int next_pot_number(const fs::path& day) {
    int number = 1;
    for (const fs::path& entry : list_folder(day).entries)
        number = std::max(number, pot_number(entry.filename().string()) + 1);
    return number;
}

asset::Image straight_picture(ui::Painting painting) {
    asset::Image image{.width = painting.width, .height = painting.height, .rgba = std::move(painting.rgba)};
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
        const unsigned alpha = image.rgba[at + 3];
        for (std::size_t channel = 0; alpha > 0 && channel < 3; ++channel) {
            const unsigned value = image.rgba[at + channel] * 255U / alpha;
            image.rgba[at + channel] = static_cast<std::uint8_t>(std::min(255U, value));
        }
    }
    return image;
}

Result<exporter::PotFile> glazed_model(const clay::StudioClay& clay, const finish::GlazeMaterial& glaze,
                                       const decoration::Marks* marks, exporter::PotStory story) {
    constexpr clay::Firing kStage = clay::Firing::kGlaze;
    const auto height_mm =
        static_cast<float>(clay.height_mm() * clay::shrunk_scale(clay.lump().body, kStage));
    look::PotLook worn = look::glaze_look(glaze, height_mm);
    if (marks != nullptr) worn = look::marked_look(std::move(worn), *marks, glaze.marks, height_mm);
    return look::dressed_pot(clay, kStage, worn, std::move(story));
}

std::string today() {
    return day_of(wall_clock_s());
}

std::string day_of(std::int64_t s) {
    return fmt::format("{:%Y-%m-%d}", fmt::localtime(static_cast<std::time_t>(s)));
}

Gallery::Gallery(const kiosk::Config& config)
    : folder_(config.gallery.folder),
      most_pots_(config.gallery.most_pots),
      least_free_mb_(config.gallery.least_free_mb),
      for_phones_rooms_(config.sharing.public_url.starts_with("https://")) {}

void Gallery::clear_parts() const {
    constexpr bool kInDays = true;
    files::clear_parts(folder_, kInDays);
}

double free_mb_at(const fs::path& folder) {
    std::error_code error;
    const fs::space_info space = fs::space(fs::exists(folder, error) ? folder : fs::path("."), error);
    return error ? 0.0 : static_cast<double>(space.available) / kiosk::kBytesPerMb;
}

std::vector<KeptPot> kept_pots(const fs::path& folder, std::string* trouble) {
    struct Aged {
        std::pair<std::string, int> age;  // day, number within the day
        fs::path folder;
    };
    std::vector<Aged> found;
    const auto entries_of = [&](const fs::path& around) {
        FolderListing listing = list_folder(around);
        if (!listing.is_whole() && trouble != nullptr) *trouble = listing_trouble(around, listing);
        return std::move(listing.entries);
    };
    std::error_code ignored;
    for (const fs::path& day : entries_of(folder)) {
        if (!fs::is_directory(day, ignored)) continue;
        for (const fs::path& pot : entries_of(day)) {
            if (const int number = pot_number(pot.filename().string()); number != 0)
                found.push_back({{day.filename().string(), number}, pot});
        }
    }
    // By day, then by number: the thousandth pot of a day comes after the last with three digits.
    std::sort(found.begin(), found.end(), [](const Aged& a, const Aged& b) { return a.age > b.age; });
    std::vector<KeptPot> pots;
    pots.reserve(found.size());
    for (Aged& pot : found)
        pots.push_back({pot.folder, pot.age.first + "/" + pot.folder.filename().string()});
    return pots;
}

Result<void> Gallery::expect_free(double more_mb) const {
    const double free = free_mb();
    if (free >= least_free_mb_ + more_mb) return {};
    return system_lacks(fmt::format("{}: expected {:.0f} MB free, found {:.0f}", folder_.string(),
                                    least_free_mb_ + more_mb, free));
}

Result<void> Gallery::remove(const KeptPot& pot) {
    return files::take_away_folder(pot.folder);
}

// Deletes the oldest pots first, but never the new one. A day after today was recorded before the clock went
// back, so its pots are older than all others.
void Gallery::make_room(const fs::path& newcomer, const std::string& today) {
    std::string trouble;
    std::vector<KeptPot> all = pots(&trouble);
    if (!trouble.empty()) return;  // the oldest ones are unknown
    std::erase_if(all, [&](const KeptPot& pot) { return pot.folder == newcomer; });
    std::stable_partition(all.begin(), all.end(),
                          [&](const KeptPot& pot) { return pot.folder.parent_path().filename() <= today; });
    while (all.size() >= static_cast<std::size_t>(most_pots_)) {
        static_cast<void>(remove(all.back()));
        all.pop_back();
    }
}

namespace {

// The hash is that of the clay at the session's end, as in its last block: `onggi replay` finds it again.
exporter::PotStory dated_story(exporter::PotStory story, const haptic::History& history,
                               const std::string& today) {
    const std::string hash = fmt::format("{:016x}", history.state().hash());
    story.about.date = today;
    story.about.identifier = "onggi-session:" + hash;
    story.extras.insert(story.extras.end(), {{"date", today}, {"session_hash", hash}});
    return story;
}

}  // namespace

Result<int> Gallery::keep(PotToKeep pot, const std::string& today) {
    std::error_code error;
    fs::create_directories(folder_ / today, error);
    if (error)
        return system_lacks(fmt::format("{}: expected a folder to save in, found none: {}",
                                        (folder_ / today).string(), error.message()));
    if (auto room = expect_free(); !room) return room.error();
    int number = next_pot_number(folder_ / today);
    const auto place_of = [&] { return folder_ / today / fmt::format("pot-{:03}", number); };
    // If the disk fails, the listing may be incomplete.
    while (fs::exists(place_of(), error))
        ++number;

    const fs::path place = place_of();
    auto folder = files::AtomicFolder::create(place);
    if (!folder) return folder.error();
    const fs::path session = folder->inside() / "pot.onggi";
    const std::vector<std::byte> drawn =
        pot.marks ? decoration::bytes_of(pot.marks->recorded) : std::vector<std::byte>();
    const auto saved = pot.history->is_whole() ? pot.history->save(session, drawn)
                                               : pot.history->save_outcome(session, drawn);
    if (!saved) return saved.error();
    const auto write = [&](const char* name, const Result<std::vector<std::byte>>& bytes) -> Result<void> {
        if (!bytes) return bytes.error();
        return files::write_file_atomically(folder->inside() / name, *bytes);
    };
    for (std::size_t i = 0; i < pot.bowls.size(); ++i) {
        const auto bowl = files::read_file(pot.bowls[i], kMostSessionBytes);
        if (!bowl) return bowl.error();
        const std::string name = fmt::format("bowl-{}.onggi", i + 1);
        if (auto written = files::write_file_atomically(folder->inside() / name, *bowl); !written)
            return written.error();
    }
    using enum exporter::ExportKind;
    const exporter::PotStory story = dated_story(std::move(pot.story), *pot.history, today);
    {
        // Frees the picture's pixels and the solid before the GLB's pictures and solid are made.
        const asset::Image portrait = straight_picture(std::move(pot.portrait));
        const auto plain = asset::encode_png(portrait);
        if (!plain) return plain.error();
        if (auto written = write("pot.png", asset::picture_about(*plain, story.about)); !written)
            return written.error();
        const auto print = exporter::pot_file(*pot.clay, clay::Firing::kGlaze, story);
        if (auto written = write("pot.3mf", exporter::encode_pot(print, k3mf, &portrait)); !written)
            return written.error();
        if (auto written = write("pot.stl", exporter::encode_pot(print, kStl)); !written)
            return written.error();
    }
    const auto model = glazed_model(*pot.clay, *pot.glaze, pot.marks.get(), story);
    if (auto written = write("pot.glb", exporter::encode_pot(model, kGlb)); !written) return written.error();
    if (for_phones_rooms_) {
        if (auto written = write("pot.usdz", exporter::encode_pot(model, kUsdz)); !written)
            return written.error();
    }
    if (auto done = folder->commit(); !done) return done.error();
    // Only now: a pot that cannot be kept deletes no other. Without memory the old ones wait for the next.
    static_cast<void>(within_memory("gallery", [&]() -> Result<void> {
        make_room(place, today);
        return {};
    }));
    return number;
}

}  // namespace onggi::app
