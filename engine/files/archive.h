// Archives: many files in one ZIP file (PKWARE APPNOTE 6.3.9), which any desktop opens. Each file carries its
// CRC-32. Any one thread at a time but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/files/atomic_file.h"

struct archive;  // libarchive's

namespace onggi::files {

struct FreeArchive {
    void operator()(archive* held) const noexcept;
};
using ArchiveHandle = std::unique_ptr<archive, FreeArchive>;

// Appears whole or not at all, as every AtomicFile. The same files give the same bytes: no times are stored.
class ArchiveWriter {
  public:
    // Errors as AtomicFile::create().
    [[nodiscard]] static Result<ArchiveWriter> create(const std::filesystem::path& destination);

    // Adds a file, compressed. `name` is relative, with slashes: "pots/a.glb".
    Result<void> add(const std::string& name, std::string_view bytes);
    // Nothing can be added afterwards.
    Result<void> commit();

  private:
    struct Sink {
        AtomicFile file;
        std::optional<Error> trouble = {};
    };
    ArchiveWriter(std::unique_ptr<Sink> sink, ArchiveHandle handle);
    [[nodiscard]] Error lost() const;

    std::unique_ptr<Sink> sink_;  // outlives handle_, which writes into it
    ArchiveHandle handle_;
};

// Reads an archive that anyone may have made. A name is text that the caller judges before it becomes a path.
class ArchiveReader {
  public:
    // Bad input: no such file, not a ZIP file, or one without its end.
    [[nodiscard]] static Result<ArchiveReader> open(const std::filesystem::path& file);

    // Goes on to the next file and returns its name; empty at the end. Skips folders. Bad input: damage, a
    // link or anything else that is no plain file, a name that is no text.
    [[nodiscard]] Result<std::optional<std::string>> next();
    // The content of the present file, once, checked against its CRC-32. Bad input: damage, or more than
    // `most_bytes`; then no more than these are unpacked.
    [[nodiscard]] Result<std::string> read(std::size_t most_bytes);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  private:
    ArchiveReader(std::filesystem::path file, ArchiveHandle handle);
    [[nodiscard]] Error damage() const;

    std::filesystem::path file_;
    std::string name_;  // of the present file
    ArchiveHandle handle_;
};

}  // namespace onggi::files
