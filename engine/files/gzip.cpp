#include "engine/files/gzip.h"

#include <zlib.h>

#include <limits>

namespace onggi::files {

Result<std::vector<std::byte>> gzip(std::span<const std::byte> bytes) {
    constexpr int kWindowBits = 15 + 16;  // the largest window, and gzip's frame instead of zlib's
    constexpr int kMemoryLevel = 9;
    if (bytes.size() > std::numeric_limits<uInt>::max() / 2) return failed("gzip: too large to pack at once");
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindowBits, kMemoryLevel,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        return system_lacks("gzip: not enough memory");
    std::vector<std::byte> packed(deflateBound(&stream, static_cast<uLong>(bytes.size())));
    // zlib reads through a pointer that is not const, and does not write there.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));  // NOLINT
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    const int done = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (done != Z_STREAM_END) return failed("gzip: the bytes could not be packed");
    return packed;
}

}  // namespace onggi::files
