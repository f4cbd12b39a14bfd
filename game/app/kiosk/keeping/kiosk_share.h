// Converts the visitor's pot for the outbox, and the settings to the outbox's address and times. Any one
// thread but the haptic one.
#pragma once

#include <string>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/exporter/export.h"
#include "game/screens/page/view.h"
#include "game/sharing/outbox.h"
#include "game/sharing/shared_pot.h"

namespace onggi::app {

// Outline, measures, look and words; the caller adds the files. `glaze` is an index of finish::glaze_at(),
// `language` of the settings.
[[nodiscard]] sharing::SharedPot shared_pot(const screens::FiredPot& pot, int glaze,
                                            const KioskSettings& settings, int language);

// What the pot's files say: name, making, glaze, decoration, the museum's pot beside it with its source, and
// the house's licence and name; in the settings' languages, the house's first. Nothing depends on the
// visitor's language.
[[nodiscard]] exporter::PotStory pot_story(const screens::FiredPot& pot, int glaze,
                                           const KioskSettings& settings);

// The house and its licence in one line, in the house's first language; empty if neither is set.
[[nodiscard]] std::string credit_of(const KioskSettings& settings);

// The pot alone in a square picture with a transparent background, placed as by the page's script, so that
// the script can replace it seamlessly.
[[nodiscard]] asset::Image share_poster(const pot::Section& shape, int glaze, int side_px);

// The glaze as a texture of the outside, see sharing::SharedPot::surface; empty for a pot without an outside.
[[nodiscard]] asset::Image share_surface(const pot::Section& shape, int glaze);

[[nodiscard]] sharing::OutboxOptions outbox_options(const KioskSettings& settings);

// The address up to the code: the settings' public_url, or where `onggi share` listens. Bad input, system
// lacks: as address_of().
[[nodiscard]] Result<std::string> share_base_url(const kiosk::Config& config);

// The times of a pot that is shared now, by the machine's clock and time zone.
[[nodiscard]] sharing::ShareTime share_time_now(const kiosk::Config& config);

}  // namespace onggi::app
