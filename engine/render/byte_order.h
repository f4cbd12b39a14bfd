// How a pixel's bytes lie in its word. Any thread.
#pragma once

namespace onggi::render {

// Alpha is the highest; the lowest is red or blue.
enum class ByteOrder { kRedFirst, kBlueFirst };

}  // namespace onggi::render
