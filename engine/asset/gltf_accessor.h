// Numbers out of a glTF accessor, checked against the bytes that are really there. Used inside engine/asset
// only. Any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"

namespace tinygltf {
class Model;
}

namespace onggi::asset {

// Elements of `accessor`, each `width` numbers (1 to 4), one after another. Integers are taken as they are,
// or as 0 to 1 where the accessor is normalised. Error texts have no file name yet.
Result<std::vector<float>> read_floats(const tinygltf::Model& model, int accessor, int width,
                                       std::size_t max_count);

// Unsigned scalars of 8, 16 or 32 bits.
Result<std::vector<std::uint32_t>> read_indices(const tinygltf::Model& model, int accessor,
                                                std::size_t max_count);

// How many numbers an element has; 0 where there is no such accessor.
int accessor_width(const tinygltf::Model& model, int accessor);

}  // namespace onggi::asset
