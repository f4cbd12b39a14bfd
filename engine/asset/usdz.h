// Writes USDZ, which iPhones show in a room (AR Quick Look): a ZIP file of USD text and pictures, stored,
// with every file at a multiple of 64 bytes (Usdz File Format Specification 1.3, Pixar). Any thread; returns
// bytes.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/core/result.h"

namespace onggi::asset {

// The same content as encode_glb(): metres, +Y up, one mesh, one UsdPreviewSurface with the material's
// pictures. What the file says about itself and the extras' texts and numbers are the layer's
// customLayerData. The same content gives the same bytes. Errors as encode_glb().
Result<std::vector<std::byte>> encode_usdz(const GltfContent& content);

}  // namespace onggi::asset
