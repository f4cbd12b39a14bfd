// Output files that appear whole or not at all: written beside the destination, synced, renamed. Any one
// thread at a time but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::files {

// Checks that a file can be written at `destination`, without changing anything. Call it before long work.
// Bad input: no such folder, or the destination is not a regular file (a folder, a device, a pipe). System
// lacks: permission denied, a file system that cannot be written.
[[nodiscard]] Result<void> check_output_place(const std::filesystem::path& destination);

// Whether a file system has refused to sync a folder since the start: a power cut may lose the name of the
// newest file there. Any thread.
[[nodiscard]] bool folder_sync_was_refused() noexcept;

// The temporary file until commit().
enum class Beside {
    kNameless,  // an unnamed file if the file system supports it: a killed program leaves nothing behind
    kNamed,     // NAME.part, which survives the program's death: for recordings, readable up to their end
};

// An output file being written. Bytes are buffered; every call that can fail is checked, including close and
// the folder's sync. Until commit() an older file at the destination is unchanged; the destructor, discard()
// or any failure removes the temporary file. A full disk is "system lacks".
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
    // Writes the buffer to the kernel, so that the bytes survive the program (but not a power cut).
    Result<void> flush();
    // Flushes and syncs; commit() then needs no more disk space. To write several files all or none, prepare
    // all before the first commit.
    Result<void> prepare();
    // Prepares, and renames to the destination. Nothing can be written afterwards.
    Result<void> commit();
    void discard() noexcept;
    // Stops writing and leaves the prepared bytes in NAME.part, as a killed program would. For
    // Beside::kNamed.
    void leave() noexcept;

    // The destination, with a final symbolic link followed.
    [[nodiscard]] const std::filesystem::path& destination() const { return destination_; }
    // The name of the temporary file; empty if it is unnamed.
    [[nodiscard]] const std::filesystem::path& beside() const { return beside_; }

  private:
    AtomicFile() = default;
    Error lost(int error_number, std::string_view doing);
    Result<void> write_through(std::span<const std::byte> bytes);

    std::filesystem::path shown_;        // as the user wrote it, for error messages
    std::filesystem::path destination_;  // absolute
    std::filesystem::path beside_;       // name of the temporary file; empty if it is unnamed
    int descriptor_ = -1;
    bool prepared_ = false;
    std::vector<std::byte> buffer_;
};

// Writes a whole file in one call.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& destination,
                                                 std::span<const std::byte> bytes);
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& destination,
                                                 std::string_view text);

}  // namespace onggi::files
