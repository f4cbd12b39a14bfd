// Compression for the web: gzip (RFC 1952). Any thread but the haptic one; allocates. Some 60 ms per
// megabyte.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/result.h"

namespace onggi::files {

// The same input gives the same output: no time and no name is stored. Error: system lacks, if memory is
// short.
[[nodiscard]] Result<std::vector<std::byte>> gzip(std::span<const std::byte> bytes);

}  // namespace onggi::files
