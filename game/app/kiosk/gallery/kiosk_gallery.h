// The day's shelf on the disk: a folder a day, a folder a pot, five files in each. A pot is there whole or
// not at all. Nothing about the person is stored. Any one thread at a time but the haptic one; blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/ui/painting.h"
#include "game/clay/studio/studio_clay.h"
#include "game/decoration/canvas.h"
#include "game/finish/glaze.h"
#include "game/haptic/history.h"
#include "game/kiosk/config.h"

namespace onggi::app {

// What a pot is kept as. The history is of the clay that was cut off; where a tick of it was lost, the
// session holds the clay alone.
struct PotToKeep {
    const haptic::History* history = nullptr;
    const clay::StudioClay* clay = nullptr;
    const finish::GlazeMaterial* glaze = nullptr;
    ui::Painting portrait;                             // for the PNG
    std::shared_ptr<const decoration::Marks> marks{};  // that were drawn on it; null: none
    std::vector<std::filesystem::path> bowls{};        // sessions of the two that were joined; or none
};

struct KeptPot {
    std::filesystem::path folder;
    std::string name;  // "2026-11-21/pot-014"
};

// What Gallery::pots() and free_mb() say, of a folder that somebody else keeps pots in meanwhile.
[[nodiscard]] std::vector<KeptPot> kept_pots(const std::filesystem::path& folder,
                                             std::string* trouble = nullptr);
[[nodiscard]] double free_mb_at(const std::filesystem::path& folder);

class Gallery {
  public:
    // `today`: the folder of the day, "2026-11-21".
    // However many pots there are, none is looked at.
    explicit Gallery(const kiosk::Config& config);

    // Takes away what a killed program left half. Once, before the first pot is kept.
    void clear_parts() const;

    // Writes pot.onggi, pot.glb, pot.stl, pot.3mf and pot.png, of a jar of two bowls also bowl-1.onggi and
    // bowl-2.onggi; gives the pot's number of the day, from 1.
    // System lacks: less of the disk is free than the configuration leaves alone, no permission; then nothing
    // is there.
    Result<int> keep(PotToKeep pot, const std::string& today);
    // Newest first. Where the disk does not tell of them all, those it tells of, and `trouble` gets one line;
    // else it stays as it is.
    [[nodiscard]] std::vector<KeptPot> pots(std::string* trouble = nullptr) const {
        return kept_pots(folder_, trouble);
    }
    Result<void> remove(const KeptPot& pot);
    [[nodiscard]] double free_mb() const { return free_mb_at(folder_); }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    void make_room(const std::filesystem::path& newcomer, const std::string& today);

    std::filesystem::path folder_;
    int most_pots_;
    double least_free_mb_;
};

// The pot as pot.glb has it: glaze-fired, wearing its glaze. Errors as look::dressed_glb() has them.
[[nodiscard]] Result<std::vector<std::byte>> glazed_model(const clay::StudioClay& clay,
                                                          const finish::GlazeMaterial& glaze,
                                                          const decoration::Marks* marks = nullptr);

// A painting, whose colours are dimmed by what is seen through them, as files have them.
[[nodiscard]] asset::Image straight_picture(ui::Painting painting);

// Of the machine's clock, where it stands: "2026-11-21". day_of(): of that second since 1970.
[[nodiscard]] std::string today();
[[nodiscard]] std::string day_of(std::int64_t s);

}  // namespace onggi::app
