// A folder of files that appears whole or not at all: filled beside the destination, synced, renamed. Any one
// thread at a time but the haptic one; blocks.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace onggi::files {

// Until commit() nothing is at the destination; the destructor removes what was written. A killed program
// leaves NAME.part, which clear_parts() removes at the next start.
class AtomicFolder {
  public:
    // System lacks: the parent folder cannot be created or written. Bad input: the destination exists.
    static Result<AtomicFolder> create(const std::filesystem::path& destination);

    AtomicFolder(AtomicFolder&& other) noexcept;
    AtomicFolder& operator=(AtomicFolder&&) = delete;
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;
    ~AtomicFolder();

    // The folder to write files into, with write_file_atomically or similar functions that sync.
    [[nodiscard]] const std::filesystem::path& inside() const { return part_; }
    Result<void> commit();

  private:
    AtomicFolder(std::filesystem::path destination, std::filesystem::path part);

    std::filesystem::path destination_;
    std::filesystem::path part_;  // empty once committed
};

// Removes a folder with its content. It is first renamed to NAME.part, so that a power cut never leaves half
// a folder; on overlayfs, which cannot rename a folder of its lower layer, it is removed file by file.
// Errors: system lacks if it cannot be removed; bad input if it does not exist.
Result<void> take_away_folder(const std::filesystem::path& folder);

// Renames a file or a folder of files to `destination`, in a folder that is created if missing; on another
// file system by a copy that appears whole. A file there is replaced. Errors as AtomicFolder::create() and
// commit(); then `from` stays.
Result<void> move_into_place(const std::filesystem::path& from, const std::filesystem::path& destination);

// Removes every NAME.part folder in `around` (with `deep` also in its folders), and the temporary AtomicFile
// files of dead processes. It decides by names alone, so that other files cost no system call each.
void clear_parts(const std::filesystem::path& around, bool deep = false);

}  // namespace onggi::files
