// Inside engine/files only: where an output file really goes, and whether it can. Any thread; blocks.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

#include "engine/core/result.h"

namespace onggi::files {

struct OutputPlace {
    std::filesystem::path file;      // absolute, a symbolic link at its end followed
    std::filesystem::path folder;    // its folder
    std::optional<mode_t> old_mode;  // permissions of the file that stands there already
};

// Looks, touches nothing. Refuses as check_output_place does.
[[nodiscard]] Result<OutputPlace> find_output_place(const std::filesystem::path& destination);

}  // namespace onggi::files
