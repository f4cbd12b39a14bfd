#include "game/app/kiosk/keeping/kiosk_share.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <utility>

#include "engine/render/beauty.h"
#include "engine/ui/painter.h"
#include "engine/ui/sketch.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/sharing/listen_place.h"
#include "game/finish/glaze.h"
#include "game/finish/glaze_surface.h"
#include "game/finish/mark_colour.h"
#include "game/screens/pots/pot_picture.h"
#include "game/screens/pots/pot_shading.h"
#include "game/sharing/share_link.h"

namespace onggi::app {
namespace {

std::vector<sharing::OutlinePoint> outline_of(const std::vector<vec2>& points) {
    std::vector<sharing::OutlinePoint> outline;
    for (const vec2& point : points)
        outline.push_back({double{point.x}, double{point.y}});
    return outline;
}

// The page counts directions from the right, the eye is a quarter turn before that.
void put_off_round(sharing::SharedPot& shared, const pot::Section& shape) {
    if (!shape.off_round) return;
    const pot::OffRound& map = *shape.off_round;
    const float right = shape.front_turns() + 0.25F;
    const vec2 way(std::cos(kTurnF * right), std::sin(kTurnF * right));
    const auto part_of = [](std::size_t row, std::size_t rows) {
        return static_cast<float>(row) / static_cast<float>(std::max<std::size_t>(rows - 1, 1));
    };
    for (std::size_t i = 0; i < map.centre_mm.size(); ++i) {
        const vec2& centre = map.centre_mm[i];
        shared.axis.push_back({double{part_of(i, map.centre_mm.size()) * shape.height_mm()},
                               double{centre.x * way.x + centre.y * way.y},
                               double{centre.x * way.y - centre.y * way.x}});
    }
    const std::size_t rows = map.dents_mm.size() / pot::OffRound::kCorners;
    for (std::size_t i = 0; i < rows; ++i) {
        std::vector<double>& row = shared.dents_mm.emplace_back();
        for (int k = 0; k < pot::OffRound::kCorners; ++k)
            row.push_back(double{
                map.dent_at(part_of(i, rows), right + static_cast<float>(k) / pot::OffRound::kCorners)});
    }
}

sharing::PotWords words_of(const kiosk::Language& language, const finish::GlazeMaterial& glaze,
                           const screens::Exhibit* relative, bool own_digits) {
    sharing::PotWords words{.glaze = language.shown(glaze.name_key)};
    if (relative == nullptr) return words;
    const std::string height = fmt::format("{:.0f}", relative->height_mm);
    words.nearest_name = language.shown(relative->name_key);
    for (const std::string& part :
         {language.shown(relative->date_key), language.shown(relative->museum_key),
          language.number(height, own_digits) + "\u00a0" + language.shown("unit.mm")}) {
        if (!part.empty()) words.nearest_line += (words.nearest_line.empty() ? "" : "\n") + part;
    }
    return words;
}

// A text without a language is the default's.
asset::Wordings wordings_of(const kiosk::HouseText& text, const std::string& first) {
    asset::Wordings wordings;
    for (const auto& [code, words] : text) {
        const bool is_first = code.empty() || code == first;
        wordings.insert(is_first ? wordings.begin() : wordings.end(), {code.empty() ? first : code, words});
    }
    return wordings;
}

// Within a title English, French and Spanish write common nouns small.
std::string within_title(const kiosk::Language& language, std::string name) {
    constexpr std::array<std::string_view, 3> kSmall{"en", "fr", "es"};
    if (std::find(kSmall.begin(), kSmall.end(), language.primary_code()) != kSmall.end() && !name.empty() &&
        name.front() >= 'A' && name.front() <= 'Z')
        name.front() = static_cast<char>(name.front() - 'A' + 'a');
    return name;
}

void add_wordings(asset::About& about, const screens::FiredPot& pot, const finish::GlazeMaterial& glaze,
                  const kiosk::Language& language, bool own_digits) {
    const bool is_after = pot.relative && pot.is_after_relative;
    const std::string& name = is_after ? language.shown(pot.relative->name_key) : language.shown("file.pot");
    const kiosk::Punctuation& signs = language.punctuation();
    about.title.push_back(
        {language.code(),
         fmt::format("{}{}{}", name, signs.comma, within_title(language, language.spoken(glaze.name_key)))});
    std::string made =
        language.shown("file.made", language.number(fmt::format("{:.0f}", pot.height_mm), own_digits));
    if (pot.relative) {
        const sharing::PotWords words = words_of(language, glaze, pot.relative.get(), own_digits);
        std::string line = words.nearest_name + '\n' + words.nearest_line;
        for (std::size_t end = line.find('\n'); end != std::string::npos; end = line.find('\n', end))
            line.replace(end, 1, signs.comma);
        made +=
            fmt::format("{}{}{}{}{}", signs.stop == "." ? " " : "",
                        language.shown(is_after ? "your.after" : "your.near"), signs.colon, line, signs.stop);
    }
    about.description.push_back({language.code(), std::move(made)});
}

std::string decoration_of(const finish::DrawnWith& drawn) {
    constexpr std::array<std::string_view, decoration::kPigmentCount> kNames{"", "white slip", "black slip",
                                                                             "iron", "cobalt"};
    std::string list;
    for (std::size_t i = 1; i < kNames.size(); ++i)
        if (drawn.pigment[i] > 0) list += fmt::format("{}{}", list.empty() ? "" : ", ", kNames[i]);
    if (drawn.inlaid) list += list.empty() ? "inlay" : ", inlaid";
    if (drawn.wiped > 0) list += list.empty() ? "finger wipes" : ", finger wipes";
    return list;
}

}  // namespace

exporter::PotStory pot_story(const screens::FiredPot& pot, int glaze, const KioskSettings& settings) {
    const kiosk::Config& config = settings.config;
    const finish::GlazeMaterial& material = finish::glaze_at(glaze);
    exporter::PotStory story;
    asset::About& about = story.about;
    const std::string& first = config.languages.first;
    for (const bool is_first : {true, false}) {
        for (const kiosk::Language& language : *settings.languages)
            if ((language.code() == first) == is_first)
                add_wordings(about, pot, material, language, config.languages.own_digits);
    }
    about.rights = wordings_of(config.sharing.licence, first);
    about.publisher = wordings_of(config.sharing.publisher, first);
    about.tool = exporter::program_name();
    story.extras = {{"title", asset::first_of(about.title)},
                    {"made", asset::first_of(about.description)},
                    {"glaze", std::string(material.id)}};
    const auto add = [&](const char* name, std::string text) {
        if (!text.empty()) story.extras.emplace_back(name, std::move(text));
    };
    add("decoration", decoration_of(pot.drawn_with));
    if (pot.relative) {
        add(pot.is_after_relative ? "after_pot" : "nearest_pot", pot.relative->record);
        add(pot.is_after_relative ? "after_pot_source" : "nearest_pot_source", pot.relative->source);
        about.relation = pot.relative->record;
        if (!pot.relative->source.empty()) about.relation += fmt::format(" ({})", pot.relative->source);
    }
    add("licence", asset::first_of(about.rights));
    add("publisher", asset::first_of(about.publisher));
    return story;
}

std::string credit_of(const KioskSettings& settings) {
    const kiosk::Config& config = settings.config;
    return asset::About{.rights = wordings_of(config.sharing.licence, config.languages.first),
                        .publisher = wordings_of(config.sharing.publisher, config.languages.first)}
        .copyright();
}

sharing::SharedPot shared_pot(const screens::FiredPot& pot, int glaze, const KioskSettings& settings,
                              int language) {
    constexpr double kMlPerLitre = 1000.0;
    const finish::GlazeMaterial& material = finish::glaze_at(glaze);
    sharing::SharedPot shared;
    shared.outside = outline_of(pot.shape.outside);
    shared.inside = outline_of(pot.shape.inside);
    put_off_round(shared, pot.shape);
    shared.reach_mm = double{pot.shape.radius_mm()};
    shared.colour_linear = {double{material.colour.x}, double{material.colour.y}, double{material.colour.z}};
    shared.gloss = double{material.clear_coat} * (1.0 - double{material.coat_roughness});
    shared.height_mm = pot.height_mm;
    shared.width_mm = pot.width_mm;
    shared.mass_g = pot.weight_g;
    shared.capacity_ml = pot.capacity_l * kMlPerLitre;
    if (pot.relative) shared.nearest_outside = outline_of(pot.relative->shape.outside);
    for (const kiosk::Language& one : *settings.languages) {
        shared.words.push_back(
            words_of(one, material, pot.relative.get(), settings.config.languages.own_digits));
    }
    shared.first_language = static_cast<std::size_t>(language < 0 ? 0 : language);
    return shared;
}

asset::Image share_poster(const pot::Section& shape, int glaze, int side_px) {
    // As in assets/sharing/pot.js: the camera's elevation, the margins above and beside the pot, the board
    // below.
    constexpr float kElevationRad = 0.16F;
    constexpr float kAbove = 1.06F;
    constexpr float kBeside = 1.16F;
    constexpr float kBoard = 0.039F;
    const auto side = static_cast<float>(side_px);
    const float across = shape.radius_mm() * std::sin(kElevationRad);
    const float tall_mm = 0.5F * shape.height_mm() * std::cos(kElevationRad) + across;
    const float half_mm = std::max({tall_mm * kAbove / (1.0F - kBoard), shape.radius_mm() * kBeside, 1.0F});
    const float scale = 0.5F * side / half_mm;
    screens::PotPicture pot = screens::paint_pot(shape, finish::glaze_at(glaze), scale, kElevationRad, 0.0,
                                                 screens::kLeavingSamples);
    const vec2 foot(0.5F * side, side * (1.0F - kBoard) - across * scale);
    ui::Picture picture;
    picture.hash = shape.hash();
    picture.rect = {foot.x - pot.foot_px.x, foot.y - pot.foot_px.y, static_cast<float>(pot.painting.width),
                    static_cast<float>(pot.painting.height)};
    picture.painting = std::make_shared<const ui::Painting>(std::move(pot.painting));
    ui::Sketch sketch;
    sketch.size = vec2(side);
    sketch.add(picture);
    return straight_picture(ui::Painter().paint(sketch));
}

asset::Image share_surface(const pot::Section& shape, int glaze) {
    constexpr int kColumns = 512;
    constexpr int kRows = 256;
    // The page counts from the right, its first view of the pot; both count counter-clockwise seen from
    // above.
    constexpr float kRight = 0.5F * kPiF;
    const finish::GlazeMaterial& material = finish::glaze_at(glaze);
    const std::vector<vec2>& wall = shape.outside;
    if (wall.size() < 2) return {};
    std::vector<float> along{0.0F};
    for (std::size_t i = 1; i < wall.size(); ++i)
        along.push_back(along.back() + glm::distance(wall[i - 1], wall[i]));
    const screens::DrawnOn drawn_on(shape);
    asset::Image image{.width = kColumns, .height = kRows, .rgba = {}};
    image.rgba.reserve(std::size_t{4} * kColumns * kRows);
    for (int row = 0; row < kRows; ++row) {
        const float wanted = along.back() * (1.0F - (static_cast<float>(row) + 0.5F) / kRows);
        const auto next = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(std::upper_bound(along.begin(), along.end(), wanted) - along.begin(),
                                       1, static_cast<std::ptrdiff_t>(wall.size()) - 1));
        const float part = (wanted - along[next - 1]) / std::max(along[next] - along[next - 1], 1e-6F);
        finish::GlazePlace at{.height_mm = glm::mix(wall[next - 1].y, wall[next].y, part)};
        for (int column = 0; column < kColumns; ++column) {
            at.angle = kRight + kTurnF * (static_cast<float>(column) + 0.5F) / kColumns;
            vec3 colour = finish::glaze_colour(material, shape.height_mm(), at);
            if (drawn_on.texture() != nullptr) {
                const auto& texel = drawn_on.at(at.angle, at.height_mm / shape.height_mm());
                colour = finish::marked(colour, finish::mark_colour(material.marks, texel));
            }
            for (int channel = 0; channel < 3; ++channel)
                image.rgba.push_back(render::srgb_byte(colour[channel]));
            image.rgba.push_back(255);
        }
    }
    return image;
}

sharing::OutboxOptions outbox_options(const KioskSettings& settings) {
    const auto& wanted = settings.config.sharing;
    return {.folder = wanted.outbox,
            .most_pots = static_cast<std::size_t>(wanted.most_pots),
            .most_bytes = static_cast<std::uint64_t>(wanted.most_mb * kiosk::kBytesPerMb),
            .languages = settings.languages,
            .own_digits = settings.config.languages.own_digits,
            .public_url = wanted.public_url};
}

Result<std::string> share_base_url(const kiosk::Config& config) {
    if (!config.sharing.public_url.empty()) return config.sharing.public_url;
    const auto address = address_of(config.sharing.listen);
    if (!address) return address.error();
    return sharing::base_url(*address, config.sharing.port);
}

sharing::ShareTime share_time_now(const kiosk::Config& config) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm local{};
    localtime_r(&now, &local);
    return sharing::share_time(config, now, local.tm_gmtoff);
}

}  // namespace onggi::app
