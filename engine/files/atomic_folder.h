// A folder of files that appears whole or not at all: filled beside its place, synced, renamed into it. Any
// one thread at a time but the haptic one; blocks.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace onggi::files {

// Until commit() nothing is at the destination; a destructor takes away what was written. What a killed
// program leaves beside is called NAME.part; clear_parts() takes it away at the next start.
class AtomicFolder {
  public:
    // System lacks: the folder around it cannot be made or written. Bad input: the destination is there.
    static Result<AtomicFolder> create(const std::filesystem::path& destination);

    AtomicFolder(AtomicFolder&& other) noexcept;
    AtomicFolder& operator=(AtomicFolder&&) = delete;
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;
    ~AtomicFolder();

    // Where its files are to be written, with write_file_atomically or their like, which sync them.
    [[nodiscard]] const std::filesystem::path& inside() const { return part_; }
    Result<void> commit();

  private:
    AtomicFolder(std::filesystem::path destination, std::filesystem::path part);

    std::filesystem::path destination_;
    std::filesystem::path part_;  // empty once committed
};

// Takes a folder away with all that is in it: out of its place first and at once, so that a power cut in
// between leaves NAME.part and never half a folder; but file by file on overlayfs, where a folder of the lower layer
// cannot be renamed. System lacks: it cannot be; one that is not there is bad input.
Result<void> take_away_folder(const std::filesystem::path& folder);

// Takes away every NAME.part folder in `around`, and with `deep` in its folders, and what an AtomicFile of a
// process that is no more has left there: by their names, so that a thousand others cost no question each.
void clear_parts(const std::filesystem::path& around, bool deep = false);

}  // namespace onggi::files
