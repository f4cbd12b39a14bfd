// A table that grows by a line at a time, for years. Any one thread at a time but the haptic one; blocks.
#pragma once

#include <filesystem>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::files {

// Adds a line to the file, which begins with `first_line` where it is new; neither has its line end. A line
// that a killed program or a full disk left half stays a line of its own, or goes where it is the first, so
// that it costs no other. When an error is given nothing of the line is there. Not synced: a power cut may
// cost the last lines.
Result<void> append_line(const std::filesystem::path& file, std::string_view first_line,
                         std::string_view line);

}  // namespace onggi::files
