// The visitor's pot as the outbox takes it, and the outbox as the settings want it. Any one thread but the
// haptic one.
#pragma once

#include <string>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/screens/page/view.h"
#include "game/sharing/outbox.h"
#include "game/sharing/shared_pot.h"

namespace onggi::app {

// Outline, measures, look and words; the files are the caller's to add. The glaze as finish::glaze_at()
// counts, `language` as the settings do.
[[nodiscard]] sharing::SharedPot shared_pot(const screens::FiredPot& pot, int glaze,
                                            const KioskSettings& settings, int language);

// The pot alone, square and see-through around it, standing as the page's script draws it, so that one takes
// the other's place unseen.
[[nodiscard]] asset::Image share_poster(const pot::Section& shape, int glaze, int side_px);

// The glaze as the page wraps it round the outside, see sharing::SharedPot::surface; empty where there is
// no outside.
[[nodiscard]] asset::Image share_surface(const pot::Section& shape, int glaze);

[[nodiscard]] sharing::OutboxOptions outbox_options(const KioskSettings& settings);

// What stands before the code in an address: the settings' public_url, or where `onggi share` listens. Bad
// input, system lacks: as address_of().
[[nodiscard]] Result<std::string> share_base_url(const kiosk::Config& config);

// Of a pot that is shared now, by the machine's clock and where it stands.
[[nodiscard]] sharing::ShareTime share_time_now(const kiosk::Config& config);

}  // namespace onggi::app
