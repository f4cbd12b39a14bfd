// A film as MP4 (ISO/IEC 14496-14) with one track of H.264 video (Rec. ITU-T H.264, 4:2:0), picture by
// picture: what phones keep among their videos and messengers play. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/asset/about.h"
#include "engine/asset/image.h"
#include "engine/core/result.h"

namespace onggi::asset {

struct Mp4FilmDesc {
    int width = 480;  // pixels, of every picture; the last column and row of an odd size are left out
    int height = 360;
    int picture_ms = 80;  // duration of each picture, 1 to 1000
    // 1 to 51, of the coarsest pictures; a step of 2 changes the bytes by a tenth. Keys are finer.
    int quantiser = 26;
};

// Encodes pictures in order and stores only the encoded data. The first picture can be decoded alone and the
// duration is exact, so that a player starts again without a gap. The same pictures give the same bytes on
// one machine.
class Mp4Film {
  public:
    // kBadInput: a size that H.264 has no level for, a duration or a quantiser outside its bounds.
    [[nodiscard]] static Result<Mp4Film> create(const Mp4FilmDesc& desc);
    Mp4Film(Mp4Film&&) noexcept;
    Mp4Film& operator=(Mp4Film&&) noexcept;
    Mp4Film(const Mp4Film&) = delete;
    Mp4Film& operator=(const Mp4Film&) = delete;
    ~Mp4Film();

    // kBadInput: a picture of another size. kFailed: the encoder refused it; nothing can be added afterwards.
    Result<void> add(const Image& image);
    // Returns the whole file, its index before its pictures, so that playing starts before all of it has
    // arrived. kBadInput: no picture was added.
    Result<std::vector<std::byte>> finish();

  private:
    struct Encoder;
    explicit Mp4Film(std::unique_ptr<Encoder> encoder);
    std::unique_ptr<Encoder> encoder_;
};

// A film of this writer with what it says about itself: title, description, rights, date and tool where
// players look for them, and everything in an XMP packet (ISO 16684-3). kBadInput: another file.
[[nodiscard]] Result<std::vector<std::byte>> mp4_with_about(std::span<const std::byte> mp4,
                                                            const About& about);

}  // namespace onggi::asset
