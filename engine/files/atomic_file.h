// Output files that appear whole or not at all: written beside their place, synced, renamed into it.
// Any one thread at a time but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::files {

// Whether a file could be written at `destination`, without touching anything. To be asked before long work.
// Bad input: no such folder, or what stands there is no regular file (a folder, a device, a pipe).
// System lacks: permission denied, a file system that cannot be written.
[[nodiscard]] Result<void> check_output_place(const std::filesystem::path& destination);

// Whether a file system has refused to sync a folder since the start: a power cut may lose the name of the newest file
// there. Any thread.
[[nodiscard]] bool folder_sync_was_refused() noexcept;

// Where the bytes wait until commit().
enum class Beside {
    kNameless,  // in a file without a name where the file system can: a killed program leaves nothing behind
    kNamed,     // in NAME.part, which survives the program's death: for recordings, readable up to their end
};

// One output file in the making. Bytes are buffered; every call that can fail is checked, to the close and
// the folder's own sync. Until commit() an older file at the destination stays as it is; a destructor,
// discard() or a failure of any call takes away what was written. A full disk is "system lacks".
class AtomicFile {
  public:
    [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& destination,
                                                   Beside beside = Beside::kNameless);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    Result<void> write(std::span<const std::byte> bytes);
    Result<void> write(std::string_view text);
    // Hands what is buffered to the kernel, so that it outlives the program (not the machine).
    Result<void> flush();
    // Flushes and syncs; after it commit() needs no more space for the bytes. Several files of which all or
    // none should appear are all prepared before the first is committed.
    Result<void> prepare();
    // Prepares, and renames into place. Nothing can be written afterwards.
    Result<void> commit();
    void discard() noexcept;
    // Ends the writing and leaves what was prepared in NAME.part, as a killed program would. For
    // Beside::kNamed.
    void leave() noexcept;

    // Where the file will be: the destination, with a symbolic link at its end followed.
    [[nodiscard]] const std::filesystem::path& destination() const { return destination_; }
    // The name of the file beside, empty while it has none.
    [[nodiscard]] const std::filesystem::path& beside() const { return beside_; }

  private:
    AtomicFile() = default;
    Error lost(int error_number, std::string_view doing);
    Result<void> write_through(std::span<const std::byte> bytes);

    std::filesystem::path shown_;        // as the user wrote it, for messages
    std::filesystem::path destination_;  // absolute
    std::filesystem::path beside_;       // name of the temporary file, empty while it has none
    int descriptor_ = -1;
    bool prepared_ = false;
    std::vector<std::byte> buffer_;
};

// All of it in one call.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& destination,
                                                 std::span<const std::byte> bytes);
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& destination,
                                                 std::string_view text);

}  // namespace onggi::files
