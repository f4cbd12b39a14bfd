// The photographs of a background on their way to where a backend keeps them. Main thread.
#pragma once

#include <array>
#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"

namespace onggi::render {

// Whether photographs are the values of that transfer as they are.
[[nodiscard]] constexpr bool keeps_photographs(Transfer transfer) {
    return transfer == Transfer::kExactSrgb;
}
// What each byte of a photograph, exact sRGB, is with the transfer of the picture.
[[nodiscard]] std::array<std::uint8_t, 256> transfer_table(Transfer transfer);

// Both photographs, which stay until the background's let_go(). Errors: they cannot be read, are not of the
// background's size, or its relief is not whole.
[[nodiscard]] Result<const PhotographPair*> whole_pair(const Background& background);

}  // namespace onggi::render
