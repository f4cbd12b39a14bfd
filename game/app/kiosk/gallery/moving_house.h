// A gallery as one archive, for a museum that moves to another machine: pots with their sessions, statistics,
// pages that phones can still open, with their notes. Format: game/app/FORMATS.md. One thread at a time;
// blocks. The caller has the gallery's lock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "engine/core/result.h"
#include "engine/files/archive.h"
#include "game/kiosk/config.h"

namespace onggi::app {

struct Moved {
    std::size_t pots = 0;
    std::size_t pots_there = 0;  // the same pots, left alone
    std::size_t pages = 0;
    std::size_t days = 0;  // of statistics
};

// Called with the number of files done, and of all.
using Reached = std::function<void(std::uint64_t, std::uint64_t)>;

// Writes the archive; the gallery stays unchanged. Bad input: a pot whose session is damaged or of a later
// program, because an import would refuse it.
[[nodiscard]] Result<Moved> export_gallery(const kiosk::Config& config,
                                           const std::filesystem::path& destination, const Reached& reached);

// Brings in what the archive holds, whole or not at all. It is unpacked and checked in the gallery's folder
// `import.part`; from the moment at which that is renamed to `import`, finish_import() completes it, here or
// at the next start. A pot is the same as another if day and session are; a different pot of the same number
// gets the next free number. Statistics of a day that are there already are left alone. Bad input: no archive
// of a gallery, one of a later version, damage, a file that does not belong there, more pots than
// `config.most_pots`. System lacks: no room (`config.least_free_mb` stay free), no permission.
[[nodiscard]] Result<Moved> import_gallery(files::ArchiveReader archive, const kiosk::Config& config,
                                           std::int64_t now_s, const Reached& reached);

// Completes an import that was killed after it was checked. Call it before the gallery is used.
[[nodiscard]] Result<void> finish_import(const kiosk::Config& config);

}  // namespace onggi::app
