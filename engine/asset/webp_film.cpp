// See webp_film.h. Any thread.
#include "engine/asset/webp_film.h"

#include <fmt/format.h>
#include <webp/mux.h>

#include <cstring>
#include <utility>

#include "engine/asset/webp_picture.h"

namespace onggi::asset {
namespace {

// libwebp's effort for a smaller file: level 6 takes three times as long for 5 % less.
constexpr int kEffort = 4;
constexpr int kEffortWithoutLoss = 1;
constexpr double kBestQuality = 100.0;
constexpr int kLongestMs = 60'000;

using Mux = std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)>;

// libwebp makes a still without a duration of equal pictures, and of a film with a single frame, too
// (findings/libwebp-makes-a-still-without-a-duration-of-equal-pictures.sh): puts the picture in twice. Leaves
// a file that is a film as it is. False: no memory.
bool make_last(WebPData& file, int shown_ms) {
    constexpr int kCopies = 1;
    const Mux still(WebPMuxCreate(&file, kCopies), &WebPMuxDelete);
    std::uint32_t flags = 0;
    if (!still || WebPMuxGetFeatures(still.get(), &flags) != WEBP_MUX_OK) return false;
    if ((flags & ANIMATION_FLAG) != 0) return true;
    WebPMuxFrameInfo frame{};
    const Mux film(WebPMuxNew(), &WebPMuxDelete);
    const WebPMuxAnimParams once{.bgcolor = 0, .loop_count = 1};
    if (!film || WebPMuxGetFrame(still.get(), 1, &frame) != WEBP_MUX_OK) return false;
    frame.id = WEBP_CHUNK_ANMF;
    frame.dispose_method = WEBP_MUX_DISPOSE_NONE;
    frame.blend_method = WEBP_MUX_NO_BLEND;
    bool is_done = WebPMuxSetAnimationParams(film.get(), &once) == WEBP_MUX_OK;
    for (const int part_ms : {shown_ms / 2, shown_ms - shown_ms / 2}) {
        frame.duration = part_ms;
        is_done = is_done && WebPMuxPushFrame(film.get(), &frame, kCopies) == WEBP_MUX_OK;
    }
    WebPDataClear(&frame.bitstream);
    WebPDataClear(&file);
    return is_done && WebPMuxAssemble(film.get(), &file) == WEBP_MUX_OK;
}

}  // namespace

struct WebpFilm::Encoder {
    WebpFilmDesc desc;
    WebPConfig config{};
    WebPAnimEncoder* film = nullptr;
    int shown_ms = 0;  // duration of all pictures so far
    int pictures = 0;

    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { WebPAnimEncoderDelete(film); }

    [[nodiscard]] Error trouble(const char* doing) const {
        return failed(fmt::format("WebP: {}: {}", doing, WebPAnimEncoderGetError(film)));
    }
};

WebpFilm::WebpFilm(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
WebpFilm::WebpFilm(WebpFilm&&) noexcept = default;
WebpFilm& WebpFilm::operator=(WebpFilm&&) noexcept = default;
WebpFilm::~WebpFilm() = default;

Result<WebpFilm> WebpFilm::create(const WebpFilmDesc& desc) {
    if (desc.width < 1 || desc.width > kMaxImageSide || desc.height < 1 || desc.height > kMaxImageSide) {
        return bad_input(fmt::format("WebP: expected sides of 1 to {} pixels, found {} x {}", kMaxImageSide,
                                     desc.width, desc.height));
    }
    if (!(desc.quality >= 0.0 && desc.quality <= kBestQuality)) {
        return bad_input(fmt::format("WebP: expected a quality of 0 to 100, found {}", desc.quality));
    }
    auto encoder = std::make_unique<Encoder>();
    encoder->desc = desc;
    WebPAnimEncoderOptions options;
    if (WebPConfigInit(&encoder->config) == 0 || WebPAnimEncoderOptionsInit(&options) == 0)
        return failed("WebP: expected libwebp 1.2, found another");
    encoder->config.lossless = desc.quality == kBestQuality ? 1 : 0;
    encoder->config.quality = static_cast<float>(desc.quality);
    encoder->config.method = encoder->config.lossless == 1 ? kEffortWithoutLoss : kEffort;
    options.anim_params.loop_count = 1;
    encoder->film = WebPAnimEncoderNew(desc.width, desc.height, &options);
    if (encoder->film == nullptr) return failed("WebP: no memory for a film");
    return WebpFilm(std::move(encoder));
}

Result<void> WebpFilm::add(const Image& image, int shown_ms) {
    Encoder& encoder = *encoder_;
    const std::size_t bytes =
        4 * static_cast<std::size_t>(encoder.desc.width) * static_cast<std::size_t>(encoder.desc.height);
    if (image.width != encoder.desc.width || image.height != encoder.desc.height ||
        image.rgba.size() != bytes) {
        return bad_input(fmt::format("WebP: expected pictures of {} x {} pixels, found {} x {}",
                                     encoder.desc.width, encoder.desc.height, image.width, image.height));
    }
    if (shown_ms < 1 || shown_ms > kLongestMs)
        return bad_input(fmt::format("WebP: expected 1 to {} ms, found {}", kLongestMs, shown_ms));
    WebpPicture picture;
    if (!picture.take(image, WebpPicture::Colours::kArgb)) return failed("WebP: no memory for a picture");
    if (WebPAnimEncoderAdd(encoder.film, picture.get(), encoder.shown_ms, &encoder.config) == 0)
        return encoder.trouble("a picture could not be added");
    encoder.shown_ms += shown_ms;
    ++encoder.pictures;
    return {};
}

Result<std::vector<std::byte>> WebpFilm::finish() {
    Encoder& encoder = *encoder_;
    if (encoder.shown_ms == 0) return bad_input("WebP: expected a picture, found none");
    if (WebPAnimEncoderAdd(encoder.film, nullptr, encoder.shown_ms, nullptr) == 0)
        return encoder.trouble("the film could not be ended");
    WebPData data;
    WebPDataInit(&data);
    if (WebPAnimEncoderAssemble(encoder.film, &data) == 0)
        return encoder.trouble("the film could not be put together");
    if (encoder.pictures > 1 && !make_last(data, encoder.shown_ms)) {
        WebPDataClear(&data);
        return failed("WebP: no memory for a film");
    }
    std::vector<std::byte> file(data.size);
    std::memcpy(file.data(), data.bytes, data.size);
    WebPDataClear(&data);
    return file;
}

}  // namespace onggi::asset
