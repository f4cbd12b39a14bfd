// See mp4_film.h. The only user of OpenH264. Any thread.
#include "engine/asset/mp4_film.h"

#include <fmt/format.h>
#include <wels/codec_api.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/asset/utf8.h"
#include "engine/asset/webp_picture.h"

namespace onggi::asset {
namespace {

using Bytes = std::vector<std::byte>;

// Some ten seconds at 12.5 pictures per second; a player that jumps decodes at most as many. Whole groups.
constexpr unsigned kPicturesPerKey = 128;
// Pictures are predicted in groups of eight, and finer the more others follow from them: a tenth fewer bytes.
constexpr int kTemporalLayers = 4;
constexpr int kMostQuantiser = 51;
// What stands still is copied from the key: a fine one costs 40 kB, and saves more in the pictures after it.
constexpr int kKeyQuantiser = 8;
// The encoder takes smaller sizes and then no picture
// (findings/openh264-encodes-an-odd-size-one-pixel-smaller.sh).
constexpr std::uint32_t kLeastSide = 16;
constexpr int kLongestMs = 1000;
constexpr std::uint32_t kMsPerS = 1000;
// Of libwebp's colours: primaries and curve of sRGB, the matrix of BT.601 (Rec. ITU-T H.264, table E-3 to
// E-5).
constexpr std::uint32_t kPrimaries = 1;
constexpr std::uint32_t kCurve = 13;
constexpr std::uint32_t kMatrix = 6;

// Numbers of an MP4 are big-endian.
void append(Bytes& to, std::uint32_t number, int bytes) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        to.push_back(static_cast<std::byte>(number >> static_cast<unsigned>(shift) & 0xFFU));
}

Bytes words(std::initializer_list<std::uint32_t> numbers) {
    Bytes bytes;
    for (const std::uint32_t number : numbers)
        append(bytes, number, 4);
    return bytes;
}

Bytes bytes_of(std::string_view text) {
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

Bytes box(std::string_view type, std::initializer_list<Bytes> parts) {
    std::size_t size = 8;
    for (const Bytes& part : parts)
        size += part.size();
    Bytes whole = words({static_cast<std::uint32_t>(size)});
    whole.reserve(size);
    for (const char letter : type)
        whole.push_back(static_cast<std::byte>(letter));
    for (const Bytes& part : parts)
        whole.insert(whole.end(), part.begin(), part.end());
    return whole;
}

struct Track {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t picture_ms = 0;
    Bytes sps{};  // without start code
    Bytes pps{};
    Bytes pictures{};                    // each NAL unit after its length
    std::vector<std::uint32_t> sizes{};  // of pictures, in bytes
    std::vector<std::uint32_t> keys{};   // numbers of pictures that can be decoded alone, counted from 1

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(sizes.size()); }
    [[nodiscard]] std::uint32_t duration_ms() const { return count() * picture_ms; }
};

// ISO/IEC 14496-15, 5.3.3.1: the decoder's configuration.
Bytes configuration(const Track& track) {
    constexpr std::uint32_t kVersion = 1;
    constexpr std::uint32_t kLengthsOfFourBytes = 0xFF;
    Bytes bytes;
    append(bytes, kVersion, 1);
    bytes.insert(bytes.end(), track.sps.begin() + 1, track.sps.begin() + 4);  // profile and level
    append(bytes, kLengthsOfFourBytes, 1);
    for (const auto& [count, set] : {std::pair(0xE1U, &track.sps), {1U, &track.pps}}) {
        append(bytes, count, 1);
        append(bytes, static_cast<std::uint32_t>(set->size()), 2);
        bytes.insert(bytes.end(), set->begin(), set->end());
    }
    append(bytes, 0xFDF8F800U, 4);  // of the high profile: 4:2:0, 8 bits, 8 bits, no further set
    return box("avcC", {bytes});
}

// ISO/IEC 14496-12, 12.1.3: one kind of picture.
Bytes kind_of_picture(const Track& track) {
    constexpr std::uint32_t k72Dpi = 0x00480000;
    Bytes entry = words({0, 1, 0, 0, 0, 0, track.width << 16U | track.height, k72Dpi, k72Dpi, 0, 0x00010000,
                         0, 0, 0, 0, 0, 0, 0, 0x00000018});
    append(entry, 0xFFFF, 2);
    Bytes colours = bytes_of("nclx");
    for (const std::uint32_t number : {kPrimaries, kCurve, kMatrix})
        append(colours, number, 2);
    append(colours, 0, 1);  // luma 16 to 235
    return box("stsd", {words({0, 1}), box("avc1", {entry, configuration(track), box("colr", {colours})})});
}

// The index. `first_byte`: place of the first picture in the file.
Bytes index_of(const Track& track, std::uint32_t first_byte) {
    constexpr std::uint32_t kOne = 0x00010000;
    constexpr std::uint32_t kShown = 3;
    constexpr std::uint32_t kNoLanguage = 0x55C40000;
    const Bytes matrix = words({kOne, 0, 0, 0, kOne, 0, 0, 0, 0x40000000});
    const std::uint32_t lasts_ms = track.duration_ms();
    Bytes sizes = words({0, 0, track.count()});
    for (const std::uint32_t size : track.sizes)
        append(sizes, size, 4);
    Bytes keys = words({0, static_cast<std::uint32_t>(track.keys.size())});
    for (const std::uint32_t key : track.keys)
        append(keys, key, 4);
    const Bytes table =
        box("stbl", {kind_of_picture(track), box("stts", {words({0, 1, track.count(), track.picture_ms})}),
                     box("stss", {keys}), box("stsc", {words({0, 1, 1, track.count(), 1})}),
                     box("stsz", {sizes}), box("stco", {words({0, 1, first_byte})})});
    const Bytes media =
        box("mdia",
            {box("mdhd", {words({0, 0, 0, kMsPerS, lasts_ms, kNoLanguage})}),
             box("hdlr", {words({0, 0}), bytes_of("vide"), words({0, 0, 0}), Bytes(1)}),
             box("minf", {box("vmhd", {words({1, 0, 0})}),
                          box("dinf", {box("dref", {words({0, 1}), box("url ", {words({1})})})}), table})});
    return box("moov", {box("mvhd", {words({0, 0, 0, kMsPerS, lasts_ms, kOne, 0x01000000, 0, 0}), matrix,
                                     words({0, 0, 0, 0, 0, 0, 2})}),
                        box("trak", {box("tkhd", {words({kShown, 0, 0, 1, 0, lasts_ms, 0, 0, 0, 0}), matrix,
                                                  words({track.width << 16U, track.height << 16U})}),
                                     media})});
}

Bytes file_of(const Track& track) {
    const Bytes kind = box("ftyp", {bytes_of("isom"), words({512}), bytes_of("isomiso2avc1mp41")});
    const std::size_t before = kind.size() + index_of(track, 0).size() + 8;
    Bytes file = kind;
    for (const Bytes& part :
         {index_of(track, static_cast<std::uint32_t>(before)), box("mdat", {track.pictures})})
        file.insert(file.end(), part.begin(), part.end());
    return file;
}

struct Place {
    std::size_t first = 0;  // of the header
    std::size_t end = 0;
};

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + 4; ++i)
        number = number << 8U | std::to_integer<std::uint32_t>(bytes[i]);
    return number;
}

// The first box of that type in [within.first, within.end); nothing if there is none or a box is damaged.
std::optional<Place> find_box(std::span<const std::byte> bytes, Place within, std::string_view type) {
    while (within.first + 8 <= within.end) {
        const std::size_t size = number_at(bytes, within.first);
        if (size < 8 || size > within.end - within.first) return std::nullopt;
        if (std::equal(type.begin(), type.end(),
                       bytes.begin() + static_cast<std::ptrdiff_t>(within.first) + 4,
                       [](char letter, std::byte byte) { return static_cast<std::byte>(letter) == byte; }))
            return Place{within.first, within.first + size};
        within.first += size;
    }
    return std::nullopt;
}

// Where players look: the metadata that iTunes made usual, in the default language.
Bytes player_texts(const About& about) {
    constexpr std::uint32_t kUtf8 = 1;
    Bytes list;
    for (const auto& [type, text] : {std::pair("\xA9nam", first_of(about.title)),
                                     {"desc", first_of(about.description)},
                                     {"cprt", about.copyright()},
                                     {"\xA9"
                                      "day",
                                      about.date},
                                     {"\xA9too", about.tool}}) {
        if (text.empty()) continue;
        const Bytes item = box(type, {box("data", {words({kUtf8, 0}), bytes_of(valid_utf8(text))})});
        list.insert(list.end(), item.begin(), item.end());
    }
    const Bytes handler = box("hdlr", {words({0, 0}), bytes_of("mdirappl"), words({0, 0}), Bytes(1)});
    return box("udta", {box("meta", {words({0}), handler, box("ilst", {list})})});
}

struct EncoderEnd {
    void operator()(ISVCEncoder* encoder) const {
        encoder->Uninitialize();
        WelsDestroySVCEncoder(encoder);
    }
};

void describe(SEncParamExt& to, const Track& track, int quantiser) {
    const float per_s = static_cast<float>(kMsPerS) / static_cast<float>(track.picture_ms);
    to.iUsageType = CAMERA_VIDEO_REAL_TIME;
    to.iPicWidth = static_cast<int>(track.width);
    to.iPicHeight = static_cast<int>(track.height);
    to.fMaxFrameRate = per_s;
    to.iRCMode = RC_OFF_MODE;
    to.bEnableFrameSkip = false;
    to.uiIntraPeriod = kPicturesPerKey;
    to.iTemporalLayerNum = kTemporalLayers;
    to.iComplexityMode = HIGH_COMPLEXITY;
    to.iEntropyCodingModeFlag = 1;
    to.eSpsPpsIdStrategy = CONSTANT_ID;
    to.iMultipleThreadIdc = 1;
    // These guess what a camera saw.
    to.bEnableBackgroundDetection = to.bEnableSceneChangeDetect = to.bEnableAdaptiveQuant = false;
    SSpatialLayerConfig& layer = to.sSpatialLayers[0];
    layer.iVideoWidth = to.iPicWidth;
    layer.iVideoHeight = to.iPicHeight;
    layer.fFrameRate = per_s;
    layer.iDLayerQp = std::min(kKeyQuantiser, quantiser);
    layer.uiProfileIdc = PRO_HIGH;
    layer.sSliceArgument.uiSliceMode = SM_SINGLE_SLICE;
    layer.bVideoSignalTypePresent = layer.bColorDescriptionPresent = true;
    layer.uiVideoFormat = VF_UNDEF;
    layer.uiColorPrimaries = kPrimaries;
    layer.uiTransferCharacteristics = kCurve;
    layer.uiColorMatrix = kMatrix;
}

}  // namespace

struct Mp4Film::Encoder {
    Mp4FilmDesc desc;
    Track track;
    std::unique_ptr<ISVCEncoder, EncoderEnd> codec;

    // Tells the encoder how fine the next picture shall be. False if it refuses.
    [[nodiscard]] bool set_quantiser() {
        const unsigned after_key = track.count() % kPicturesPerKey;
        if (track.count() == 0 || after_key > 1) return true;
        SEncParamExt wanted;
        if (codec->GetOption(ENCODER_OPTION_SVC_ENCODE_PARAM_EXT, &wanted) != cmResultSuccess) return false;
        wanted.sSpatialLayers[0].iDLayerQp =
            after_key == 0 ? std::min(kKeyQuantiser, desc.quantiser) : desc.quantiser;
        return codec->SetOption(ENCODER_OPTION_SVC_ENCODE_PARAM_EXT, &wanted) == cmResultSuccess;
    }

    // Appends the encoder's NAL units, which follow start codes.
    void take(const SFrameBSInfo& encoded) {
        constexpr unsigned kSps = 7;
        constexpr unsigned kPps = 8;
        constexpr std::byte kType{0x1F};
        const std::size_t before = track.pictures.size();
        for (int layer = 0; layer < encoded.iLayerNum; ++layer) {
            const SLayerBSInfo& units = encoded.sLayerInfo[layer];
            const auto* from = reinterpret_cast<const std::byte*>(units.pBsBuf);
            for (int i = 0; i < units.iNalCount; from += units.pNalLengthInByte[i], ++i) {
                const auto* const end = from + units.pNalLengthInByte[i];
                const auto* const unit = std::find(from, end, std::byte{1}) + 1;
                if (unit >= end) continue;
                const auto type = std::to_integer<unsigned>(*unit & kType);
                if (type == kSps || type == kPps) {
                    (type == kSps ? track.sps : track.pps).assign(unit, end);
                    continue;
                }
                append(track.pictures, static_cast<std::uint32_t>(end - unit), 4);
                track.pictures.insert(track.pictures.end(), unit, end);
            }
        }
        track.sizes.push_back(static_cast<std::uint32_t>(track.pictures.size() - before));
        if (encoded.eFrameType == videoFrameTypeIDR) track.keys.push_back(track.count());
    }
};

Mp4Film::Mp4Film(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
Mp4Film::Mp4Film(Mp4Film&&) noexcept = default;
Mp4Film& Mp4Film::operator=(Mp4Film&&) noexcept = default;
Mp4Film::~Mp4Film() = default;

Result<Mp4Film> Mp4Film::create(const Mp4FilmDesc& desc) {
    if (desc.picture_ms < 1 || desc.picture_ms > kLongestMs)
        return bad_input(fmt::format("MP4: expected 1 to {} ms, found {}", kLongestMs, desc.picture_ms));
    if (desc.quantiser < 1 || desc.quantiser > kMostQuantiser)
        return bad_input(
            fmt::format("MP4: expected a quantiser of 1 to {}, found {}", kMostQuantiser, desc.quantiser));
    auto encoder = std::make_unique<Encoder>();
    encoder->desc = desc;
    const auto even = [](int side) { return static_cast<std::uint32_t>(std::max(side, 0)) & ~1U; };
    encoder->track = {.width = even(desc.width),
                      .height = even(desc.height),
                      .picture_ms = static_cast<std::uint32_t>(desc.picture_ms)};
    ISVCEncoder* made = nullptr;
    if (WelsCreateSVCEncoder(&made) != 0) return failed("MP4: no memory for an encoder");
    encoder->codec.reset(made);
    int silent = WELS_LOG_QUIET;
    made->SetOption(ENCODER_OPTION_TRACE_LEVEL, &silent);
    SEncParamExt wanted;
    made->GetDefaultParams(&wanted);
    describe(wanted, encoder->track, desc.quantiser);
    if (std::min(encoder->track.width, encoder->track.height) < kLeastSide ||
        made->InitializeExt(&wanted) != cmResultSuccess) {
        return bad_input(
            fmt::format("MP4: expected a size for H.264, {0} x {0} to some 9 million pixels, found {1} x {2}",
                        kLeastSide, desc.width, desc.height));
    }
    return Mp4Film(std::move(encoder));
}

Result<void> Mp4Film::add(const Image& image) {
    Encoder& encoder = *encoder_;
    if (!is_whole(image) || image.width != encoder.desc.width || image.height != encoder.desc.height) {
        return bad_input(fmt::format("MP4: expected pictures of {} x {} pixels, found {} x {}",
                                     encoder.desc.width, encoder.desc.height, image.width, image.height));
    }
    WebpPicture planes;
    if (!planes.take(image, WebpPicture::Colours::kYuv420)) return failed("MP4: no memory for a picture");
    const WebPPicture& taken = *planes.get();
    SSourcePicture source{};
    source.iColorFormat = videoFormatI420;
    source.iPicWidth = static_cast<int>(encoder.track.width);
    source.iPicHeight = static_cast<int>(encoder.track.height);
    source.uiTimeStamp = encoder.track.duration_ms();
    source.iStride[0] = taken.y_stride;
    source.iStride[1] = source.iStride[2] = taken.uv_stride;
    source.pData[0] = taken.y;
    source.pData[1] = taken.u;
    source.pData[2] = taken.v;
    SFrameBSInfo encoded{};
    if (!encoder.set_quantiser() || encoder.codec->EncodeFrame(&source, &encoded) != cmResultSuccess ||
        (encoded.eFrameType != videoFrameTypeIDR && encoded.eFrameType != videoFrameTypeP &&
         encoded.eFrameType != videoFrameTypeI))
        return failed(fmt::format("MP4: picture {} could not be encoded", encoder.track.count() + 1));
    encoder.take(encoded);
    return {};
}

Result<std::vector<std::byte>> Mp4Film::finish() {
    const Track& track = encoder_->track;
    if (track.sizes.empty()) return bad_input("MP4: expected a picture, found none");
    return file_of(track);
}

Result<std::vector<std::byte>> mp4_with_about(std::span<const std::byte> mp4, const About& about) {
    constexpr std::array<std::uint32_t, 4> kXmp{0xBE7ACFCB, 0x97A942E8, 0x9C719994, 0x91E3AFAC};
    constexpr std::size_t kHeader = 8;
    const auto index = find_box(mp4, {0, mp4.size()}, "moov");
    std::optional<Place> place = index;
    for (const char* type : {"trak", "mdia", "minf", "stbl", "stco"})
        if (place) place = find_box(mp4, {place->first + kHeader, place->end}, type);
    // Version, count, the place of the pictures.
    if (!place || place->end - place->first != kHeader + 12)
        return bad_input(
            fmt::format("MP4: expected a whole film, found {} bytes of something else", mp4.size()));
    const Bytes texts = player_texts(about);
    Bytes told(mp4.begin(), mp4.end());
    const auto put = [&](std::size_t at, std::size_t number) {
        const Bytes bytes = words({static_cast<std::uint32_t>(number)});
        std::copy(bytes.begin(), bytes.end(), told.begin() + static_cast<std::ptrdiff_t>(at));
    };
    put(index->first, index->end - index->first + texts.size());
    put(place->end - 4, number_at(mp4, place->end - 4) + texts.size());
    told.insert(told.begin() + static_cast<std::ptrdiff_t>(index->end), texts.begin(), texts.end());
    const Bytes packet =
        box("uuid", {words({kXmp[0], kXmp[1], kXmp[2], kXmp[3]}), bytes_of(xmp_packet(about))});
    told.insert(told.end(), packet.begin(), packet.end());
    return told;
}

}  // namespace onggi::asset
