#include "game/record/session_format.h"

#include <zlib.h>

#include "engine/core/hash.h"
#include "game/record/layout.h"

namespace onggi::record {

std::uint32_t force_check(const dvec3& force_n) noexcept {
    StateHash hash;
    hash.add(force_n.x);
    hash.add(force_n.y);
    hash.add(force_n.z);
    // The low half: StateHash has already folded the high half into it; folding again would cancel that.
    return static_cast<std::uint32_t>(hash.value());
}

std::uint32_t checksum(std::span<const std::byte> bytes) noexcept {
    const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
    return static_cast<std::uint32_t>(crc32_z(0, data, bytes.size()));
}

}  // namespace onggi::record
