// Byte order of a pixel within its 32-bit word. Any thread.
#pragma once

namespace onggi::render {

// Alpha is the highest byte; the lowest is red or blue.
enum class ByteOrder { kRedFirst, kBlueFirst };

}  // namespace onggi::render
