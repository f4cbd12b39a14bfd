// Reading a whole file that somebody named on the command line. Any thread but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::files {

// The bytes of a regular file of at most `most_bytes`. Refused, each with one line naming the file: a file
// that is missing, is a folder, pipe, socket or device, or is larger (bad input); one that may not be read or
// cannot be (system lacks, failed). A pipe is refused without waiting for its writer.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path, std::size_t most_bytes);

// The first `most_bytes` bytes of it, or all where there are fewer: enough to see what kind of file it is
// before reading a gigabyte of the wrong kind. Refuses as read_file does, but no file for its size.
[[nodiscard]] Result<std::string> read_file_start(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace onggi::files
