// See archive.h. The only file that includes libarchive.
#include "engine/files/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/within_memory.h"
#include "engine/files/file_errors.h"
#include "engine/files/read_file.h"

namespace onggi::files {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{64} << 10U;
constexpr mode_t kFileMode = 0644;

std::string said_by(archive* handle) {
    const char* words = archive_error_string(handle);
    return words != nullptr ? shown_path(words) : std::string("no reason");
}

}  // namespace

void FreeArchive::operator()(archive* held) const noexcept {
    archive_free(held);
}

ArchiveWriter::ArchiveWriter(std::unique_ptr<Sink> sink, ArchiveHandle handle)
    : sink_(std::move(sink)),
      handle_(std::move(handle)) {}

Result<ArchiveWriter> ArchiveWriter::create(const std::filesystem::path& destination) {
    auto file = AtomicFile::create(destination);
    if (!file) return file.error();
    ArchiveHandle handle(archive_write_new());
    if (!handle) refuse_memory();
    ArchiveWriter writer(std::make_unique<Sink>(Sink{std::move(*file)}), std::move(handle));
    const auto take = [](archive* /*handle*/, void* sink, const void* bytes, std::size_t count) {
        auto& into = *static_cast<Sink*>(sink);
        const auto written = into.file.write(std::span(static_cast<const std::byte*>(bytes), count));
        if (!written) into.trouble = written.error();
        return written ? static_cast<la_ssize_t>(count) : la_ssize_t{-1};
    };
    archive* const into = writer.handle_.get();
    archive_write_set_format_zip(into);
    // The fastest level: it packs meshes as well as the best one within some percent.
    if (archive_write_set_options(into, "zip:compression-level=1") != ARCHIVE_OK ||
        archive_write_set_bytes_in_last_block(into, 1) != ARCHIVE_OK ||
        archive_write_open2(into, writer.sink_.get(), nullptr, take, nullptr, nullptr) != ARCHIVE_OK)
        return writer.lost();
    return writer;
}

Error ArchiveWriter::lost() const {
    if (sink_->trouble) return *sink_->trouble;
    return failed(
        fmt::format("{}: cannot write: {}", shown(sink_->file.destination()), said_by(handle_.get())));
}

Result<void> ArchiveWriter::add(const std::string& name, std::string_view bytes) {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                              &archive_entry_free);
    if (!entry) refuse_memory();
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), kFileMode);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    if (archive_write_header(handle_.get(), entry.get()) != ARCHIVE_OK) return lost();
    while (!bytes.empty()) {
        const la_ssize_t written =
            archive_write_data(handle_.get(), bytes.data(), std::min(bytes.size(), kBlockBytes));
        if (written <= 0) return lost();
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return archive_write_finish_entry(handle_.get()) == ARCHIVE_OK ? Result<void>{} : lost();
}

Result<void> ArchiveWriter::commit() {
    if (archive_write_close(handle_.get()) != ARCHIVE_OK) return lost();
    return sink_->file.commit();
}

ArchiveReader::ArchiveReader(std::filesystem::path file, ArchiveHandle handle)
    : file_(std::move(file)),
      handle_(std::move(handle)) {}

Result<ArchiveReader> ArchiveReader::open(const std::filesystem::path& file) {
    // The one line for a missing file, a folder, a pipe.
    if (const auto start = read_file_start(file, 1); !start) return start.error();
    ArchiveReader reader(file, ArchiveHandle(archive_read_new()));
    if (!reader.handle_) refuse_memory();
    // Reads by the directory at the file's end: one that was cut has none.
    archive_read_support_format_zip_seekable(reader.handle_.get());
    if (archive_read_open_filename(reader.handle_.get(), file.c_str(), kBlockBytes) != ARCHIVE_OK)
        return bad_input(
            fmt::format("{}: expected a whole ZIP file, found another kind of file, or a part", shown(file)));
    return reader;
}

Error ArchiveReader::damage() const {
    const std::string where = name_.empty() ? shown(file_) : shown(file_) + ", " + shown_path(name_);
    return bad_input(
        fmt::format("{}: expected an undamaged archive, found: {}", where, said_by(handle_.get())));
}

Result<std::optional<std::string>> ArchiveReader::next() {
    for (;;) {
        archive_entry* entry = nullptr;
        const int answer = archive_read_next_header(handle_.get(), &entry);
        if (answer == ARCHIVE_EOF) return std::optional<std::string>();
        if (answer != ARCHIVE_OK) return damage();
        const char* name = archive_entry_pathname(entry);
        if (name == nullptr)
            return bad_input(fmt::format("{}: expected names that are text, found another", shown(file_)));
        name_ = name;
        const mode_t kind = archive_entry_filetype(entry);
        if (kind == AE_IFREG) return std::optional(name_);
        if (kind != AE_IFDIR) {
            const std::string_view found = kind == AE_IFLNK ? "a link" : kind_of_file(kind);
            return bad_input(fmt::format("{}, {}: expected a plain file, found {}", shown(file_),
                                         shown_path(name_), found));
        }
    }
}

Result<std::string> ArchiveReader::read(std::size_t most_bytes) {
    std::string bytes;
    for (;;) {
        const std::size_t filled = bytes.size();
        bytes.resize(std::min(filled + std::max(filled, kBlockBytes), most_bytes + 1));
        const la_ssize_t got = archive_read_data(handle_.get(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0) return damage();
        bytes.resize(filled + static_cast<std::size_t>(got));
        if (bytes.size() > most_bytes) {
            return bad_input(fmt::format("{}, {}: expected at most {} bytes, found more", shown(file_),
                                         shown_path(name_), most_bytes));
        }
        if (got == 0) return bytes;
    }
}

}  // namespace onggi::files
