// Appends lines to a table that grows for years. Any one thread at a time but the haptic one; blocks.
#pragma once

#include <filesystem>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::files {

// Appends a line to the file; a new file starts with `first_line`. Both are passed without a line end. A
// partial line that a killed program or a full disk left stays a separate line (a partial first line is
// replaced), so that it spoils no other. On an error nothing is appended. Not synced: a power cut may lose
// the last lines.
Result<void> append_line(const std::filesystem::path& file, std::string_view first_line,
                         std::string_view line);

}  // namespace onggi::files
