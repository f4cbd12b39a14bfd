// The day's shelf on the disk: one folder per day, one folder per pot, five files in each. A pot is written
// completely or not at all. No personal data is stored. One thread at a time, but not the haptic one; blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/ui/painting.h"
#include "game/clay/studio/studio_clay.h"
#include "game/decoration/canvas.h"
#include "game/exporter/export.h"
#include "game/finish/glaze.h"
#include "game/haptic/history.h"
#include "game/kiosk/config.h"

namespace onggi::app {

// A pot to keep. The history is that of the cut-off clay; if one of its ticks was lost, the session contains
// only the final clay.
struct PotToKeep {
    const haptic::History* history = nullptr;
    const clay::StudioClay* clay = nullptr;
    const finish::GlazeMaterial* glaze = nullptr;
    ui::Painting portrait;                             // for the PNG
    std::shared_ptr<const decoration::Marks> marks{};  // its decoration, or null
    std::vector<std::filesystem::path> bowls{};        // sessions of a jar's two bowls, or empty
    exporter::PotStory story{};  // written into the files, with the day and the session's hash
};

struct KeptPot {
    std::filesystem::path folder;
    std::string name;  // "2026-11-21/pot-014"
};

// Like Gallery::pots() and free_mb(), for a folder that another program is using.
[[nodiscard]] std::vector<KeptPot> kept_pots(const std::filesystem::path& folder,
                                             std::string* trouble = nullptr);
[[nodiscard]] double free_mb_at(const std::filesystem::path& folder);

// The number in "pot-014", or 0 for any other name; the number of the next pot in that day's folder.
[[nodiscard]] int pot_number(std::string_view name);
[[nodiscard]] int next_pot_number(const std::filesystem::path& day);

class Gallery {
  public:
    // `today` is the folder of the day, "2026-11-21". Reads no pot, so that its duration does not depend on
    // their number.
    explicit Gallery(const kiosk::Config& config);

    // Deletes partial pots of a killed program. Call it once, before the first pot is kept.
    void clear_parts() const;

    // Writes pot.onggi, pot.glb, pot.stl, pot.3mf and pot.png, behind https also pot.usdz, for a jar of two
    // bowls also bowl-1.onggi and bowl-2.onggi. Returns the pot's number of the day, from 1. System lacks:
    // less free space than the configuration reserves, or no permission; then nothing is written.
    Result<int> keep(PotToKeep pot, const std::string& today);
    // Newest first. If the folder cannot be listed completely, returns the listed pots and sets `trouble` to
    // one line; otherwise leaves it unchanged.
    [[nodiscard]] std::vector<KeptPot> pots(std::string* trouble = nullptr) const {
        return kept_pots(folder_, trouble);
    }
    Result<void> remove(const KeptPot& pot);
    [[nodiscard]] double free_mb() const { return free_mb_at(folder_); }
    // System lacks: less free space than the configuration reserves beside `more_mb`.
    [[nodiscard]] Result<void> expect_free(double more_mb = 0.0) const;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    void make_room(const std::filesystem::path& newcomer, const std::string& today);

    std::filesystem::path folder_;
    int most_pots_;
    double least_free_mb_;
    bool for_phones_rooms_;  // pages are behind https, which iPhones ask for to show a pot in their room
};

// The pot as in pot.glb: glaze-fired with its glaze. Errors as look::dressed_pot().
[[nodiscard]] Result<exporter::PotFile> glazed_model(const clay::StudioClay& clay,
                                                     const finish::GlazeMaterial& glaze,
                                                     const decoration::Marks* marks = nullptr,
                                                     exporter::PotStory story = {});

// Converts a painting from premultiplied to straight alpha, as files have it.
[[nodiscard]] asset::Image straight_picture(ui::Painting painting);

// today(): the local day of the machine's clock, "2026-11-21". day_of(): that of a second since 1970.
[[nodiscard]] std::string today();
[[nodiscard]] std::string day_of(std::int64_t s);

}  // namespace onggi::app
