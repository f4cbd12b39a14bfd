// Bytes as the web takes them packed: gzip (RFC 1952). Any thread but the haptic one; allocates. Some 60 ms a
// megabyte.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/result.h"

namespace onggi::files {

// The same bytes give the same file: no time and no name is stored. System lacks: not enough memory.
[[nodiscard]] Result<std::vector<std::byte>> gzip(std::span<const std::byte> bytes);

}  // namespace onggi::files
