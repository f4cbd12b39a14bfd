// Reads a whole file that a user named. Any thread but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::files {

// Reads a regular file of at most `most_bytes`. Errors name the file in one line: bad input if it is missing,
// is a folder, pipe, socket or device, or is larger; system lacks or failed if it cannot be read. A pipe is
// refused without waiting for its writer.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path, std::size_t most_bytes);

// Reads the first `most_bytes` bytes, or all if there are fewer: enough to recognise the kind of file before
// reading a gigabyte of the wrong kind. Errors as read_file(), but none for the size.
[[nodiscard]] Result<std::string> read_file_start(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace onggi::files
