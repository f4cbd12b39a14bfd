#include "engine/files/atomic_folder.h"

#include <fmt/format.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/core/list_folder.h"
#include "engine/core/quote.h"
#include "engine/files/atomic_file.h"
#include "engine/files/file_errors.h"
#include "engine/files/read_file.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

Error lost(const fs::path& place, std::string_view doing, const std::error_code& error) {
    return system_lacks(
        fmt::format("{}: expected {}, found {}", shown_path(place.string()), doing, error.message()));
}

fs::path folder_around(const fs::path& place) {
    return place.has_parent_path() ? place.parent_path() : fs::path(".");
}

Result<void> synced(const fs::path& folder) {
    if (const int error = sync_folder(folder); error != 0)
        return lost(folder, "to sync the folder", {error, std::generic_category()});
    return {};
}

// With all folders below.
Result<void> synced_deep(const fs::path& folder) {
    for (const fs::path& entry : list_folder(folder).entries) {
        std::error_code ignored;
        if (!fs::is_directory(fs::symlink_status(entry, ignored))) continue;
        if (auto done = synced_deep(entry); !done) return done;
    }
    return synced(folder);
}

// Whether the name is that of a dead process's temporary AtomicFile, ".onggi-PROCESS-N.part".
bool is_of_a_dead_process(std::string_view name) {
    constexpr std::string_view kPrefix = ".onggi-";
    if (!name.starts_with(kPrefix)) return false;
    const std::string_view digits = name.substr(kPrefix.size());
    pid_t process = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), process);
    return read.ec == std::errc() && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

AtomicFolder::AtomicFolder(fs::path destination, fs::path part)
    : destination_(std::move(destination)),
      part_(std::move(part)) {}

AtomicFolder::AtomicFolder(AtomicFolder&& other) noexcept
    : destination_(std::move(other.destination_)),
      part_(std::exchange(other.part_, {})) {}

AtomicFolder::~AtomicFolder() {
    std::error_code ignored;
    if (!part_.empty()) fs::remove_all(part_, ignored);
}

Result<AtomicFolder> AtomicFolder::create(const fs::path& destination) {
    std::error_code error;
    if (fs::exists(destination, error)) {
        return bad_input(
            fmt::format("{}: expected no folder yet, found one", shown_path(destination.string())));
    }
    fs::path part = destination;
    part += ".part";
    fs::remove_all(part, error);
    if (!fs::create_directories(part, error)) return lost(part, "to make a folder", error);
    return AtomicFolder(destination, std::move(part));
}

Result<void> AtomicFolder::commit() {
    if (auto done = synced_deep(part_); !done) return done;
    // Before the renaming, after which nothing may fail for want of memory.
    const fs::path around = folder_around(destination_);
    std::error_code error;
    fs::rename(part_, destination_, error);
    if (error) return lost(destination_, "to rename a folder into place", error);
    part_.clear();
    return synced(around);
}

Result<void> take_away_folder(const fs::path& folder) {
    fs::path part = folder;
    part += ".part";
    std::error_code error;
    fs::remove_all(part, error);  // left by a killed program
    fs::rename(folder, part, error);
    if (error == std::errc::no_such_file_or_directory)
        return bad_input(fmt::format("{}: expected a folder, found none", shown_path(folder.string())));
    // overlayfs renames no folder of a lower layer: there the files go one by one.
    if (error == std::errc::cross_device_link) fs::remove_all(folder, error);
    if (!error) fs::remove_all(part, error);
    if (error) return lost(folder, "to remove it", error);
    return {};
}

namespace {

Result<void> copy_into_place(const fs::path& from, const fs::path& destination) {
    std::error_code error;
    if (!fs::is_directory(from, error)) {
        const auto bytes = read_file(from, std::numeric_limits<std::size_t>::max() / 2);
        return bytes ? write_file_atomically(destination, *bytes) : Result<void>(bytes.error());
    }
    auto folder = AtomicFolder::create(destination);
    if (!folder) return folder.error();
    for (const fs::path& file : list_folder(from).entries)
        if (auto copied = copy_into_place(file, folder->inside() / file.filename()); !copied) return copied;
    return folder->commit();
}

}  // namespace

Result<void> move_into_place(const fs::path& from, const fs::path& destination) {
    const fs::path folder = folder_around(destination);
    std::error_code error;
    if (fs::create_directories(folder, error)) {
        if (auto done = synced(folder_around(folder)); !done) return done;
    }
    fs::rename(from, destination, error);
    if (!error) return synced(folder);
    if (error != std::errc::cross_device_link) return lost(destination, "to rename it into place", error);
    if (auto copied = copy_into_place(from, destination); !copied) return copied;
    fs::remove_all(from, error);
    return {};
}

void clear_parts(const fs::path& around, bool deep) {
    std::error_code ignored;
    const auto is_folder = [&](const fs::path& entry) {
        return fs::is_directory(fs::symlink_status(entry, ignored));
    };
    for (const fs::path& entry : list_folder(around).entries) {
        if (entry.extension() == ".part") {
            if (is_folder(entry)) {
                fs::remove_all(entry, ignored);
            } else if (is_of_a_dead_process(entry.filename().native())) {
                fs::remove(entry, ignored);
            }
        } else if (deep && is_folder(entry)) {
            clear_parts(entry);
        }
    }
}

}  // namespace onggi::files
