// An entity is a name, not an object: an index into the registry's tables and the generation that tells a
// new entity from a destroyed one that had the same index. Main thread.
#pragma once

#include <cstdint>
#include <limits>

namespace onggi::ecs {

// As it is made, without a registry, it is alive in none.
struct Entity {
    static constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t index = kNoIndex;
    std::uint32_t generation = 0;

    friend bool operator==(Entity, Entity) = default;
};

}  // namespace onggi::ecs
