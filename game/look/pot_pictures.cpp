#include "game/look/pot_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/asset/mesh_order.h"
#include "engine/math/eight_bits.h"
#include "engine/math/light.h"
#include "engine/render/beauty.h"
#include "engine/render/shapes/detail_texture.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "game/exporter/studio_export.h"
#include "game/finish/glaze_surface.h"
#include "game/finish/mark_colour.h"
#include "shaders/lathe.h"

namespace onggi::look {
namespace {

constexpr int kLastTexel = render::kDetailTexels - 1;

// The streak texture, 0 to 1.
std::vector<vec4> streak_texels() {
    const std::vector<std::uint8_t>& bytes = render::detail_texture();
    std::vector<vec4> texels(bytes.size() / 4);
    for (std::size_t at = 0; at < bytes.size(); ++at)
        texels[at / 4][static_cast<int>(at % 4)] = static_cast<float>(bytes[at]) / 255.0F;
    return texels;
}

// A place on one axis of that texture: two neighbouring texels, and how far it is from the first to the
// second.
struct Between {
    std::size_t first;
    std::size_t second;
    float fraction;
};
Between between_texels(float turns) {
    const float at = turns * render::kDetailTexels - 0.5F;
    const auto first = static_cast<int>(std::floor(at));
    return {static_cast<std::size_t>(first & kLastTexel), static_cast<std::size_t>((first + 1) & kLastTexel),
            at - static_cast<float>(first)};
}

float angle_of_column(int x) {
    return kTurnF * (static_cast<float>(x) + 0.5F) / kPictureSide;
}

constexpr int kSubRows = 4;      // samples per row of texels: streaks are finer than a row
constexpr float kSpanMm = 0.8F;  // length of the outline averaged for a normal

asset::Image blank() {
    asset::Image image{.width = kPictureSide, .height = kPictureSide, .rgba = {}};
    image.rgba.resize(std::size_t{4} * kPictureSide * kPictureSide, 255);
    return image;
}

void put_texel(asset::Image& image, std::size_t texel, const vec3& value) {
    for (int channel = 0; channel < 3; ++channel)
        image.rgba[4 * texel + static_cast<std::size_t>(channel)] = eight_bits(value[channel]);
}

// The outline as in the wheel's picture, with every groove.
class Outline {
  public:
    Outline(const exporter::PotRings& rings, double shrinkage) {
        const auto scaled = [&](double length_mm) { return static_cast<float>(length_mm * shrinkage); };
        for (int i = 0; i < rings.count(); ++i) {
            outer_.push_back(scaled(rings.outer_mm[exporter::PotRings::at(i)]));
            inner_.push_back(scaled(rings.inner(i)));
            top_.push_back(scaled(rings.edge_mm[exporter::PotRings::at(i) + 1]));
        }
        const bool is_hollow = !rings.inner_mm.empty();
        render::build_profile(
            {.radii_mm = outer_,
             .inner_mm = is_hollow ? std::span<const float>(inner_) : std::span<const float>(),
             .top_mm = top_},
            profile_);
        render::sample_profile(profile_, samples_);
    }

    [[nodiscard]] float height_mm() const { return profile_.height_mm; }
    // Arc length along the outline of a place on a wall.
    [[nodiscard]] float along(float y_mm, bool inside) const {
        const auto first =
            profile_.points.begin() + static_cast<std::ptrdiff_t>(inside ? profile_.inside : 0);
        const auto last =
            profile_.points.begin() + static_cast<std::ptrdiff_t>(inside ? profile_.floor : profile_.edge);
        if (first == last) return 0.0F;
        const auto above = std::partition_point(first, last, [&](const render::ProfilePoint& point) {
            return inside ? point.y_mm > y_mm : point.y_mm < y_mm;
        });
        if (above == first) return first->along_mm;
        if (above == last) return (last - 1)->along_mm;
        const render::ProfilePoint& before = *(above - 1);
        const float rise = above->y_mm - before.y_mm;
        const float fraction = rise == 0.0F ? 0.0F : (y_mm - before.y_mm) / rise;
        return before.along_mm + fraction * (above->along_mm - before.along_mm);
    }
    [[nodiscard]] vec2 normal(float along_mm) const {
        return render::profile_normal(profile_, along_mm, kSpanMm);
    }
    // Ambient visibility, with the darkening of the wheel's picture.
    [[nodiscard]] float open(const exporter::PictureRow& at) const {
        const vec2 normal(at.normal);
        const auto radius_mm = static_cast<float>(at.radius_mm);
        const auto y_mm = static_cast<float>(at.y_mm);
        if (!at.inside) {
            const float seen = normal.y < -0.9F ? 0.5F : render::open_outside(samples_, radius_mm, y_mm);
            return shaders::lathe_open(seen, y_mm, normal.y, 0.0F);
        }
        constexpr float kOffTheWallMm = 0.4F;
        return render::open_inside(samples_, std::max(radius_mm - kOffTheWallMm, 0.0F), y_mm + 0.1F, normal);
    }

  private:
    std::vector<float> outer_;
    std::vector<float> inner_;
    std::vector<float> top_;
    render::LatheProfile profile_;
    render::LatheSamples samples_;
};

// Interpolates between the rows of the pictures.
class RowsByPlace {
  public:
    explicit RowsByPlace(const std::vector<exporter::PictureRow>& rows) : rows_(rows) {}

    // Precondition: v does not decrease from call to call.
    exporter::PictureRow at(double v) {
        while (next_ + 1 < rows_.size() && rows_[next_].v < v)
            ++next_;
        const exporter::PictureRow& below = rows_[next_];
        const exporter::PictureRow& above = rows_[next_ == 0 ? 0 : next_ - 1];
        const double run = below.v - above.v;
        const double fraction = run > 0.0 ? std::clamp((v - above.v) / run, 0.0, 1.0) : 1.0;
        const dvec2 normal = glm::mix(above.normal, below.normal, fraction);
        return {.v = v,
                .radius_mm = glm::mix(above.radius_mm, below.radius_mm, fraction),
                .y_mm = glm::mix(above.y_mm, below.y_mm, fraction),
                .normal = glm::length(normal) > 0.0 ? glm::normalize(normal) : below.normal,
                .inside = fraction < 0.5 ? above.inside : below.inside};
    }

  private:
    const std::vector<exporter::PictureRow>& rows_;
    std::size_t next_ = 0;
};

// A row of the pictures: its place, and the fine normal relative to the mesh's.
struct BakedRow {
    exporter::PictureRow row;
    float along_mm = 0.0F;
    vec2 fine{0.0F};  // the outline's own normal
};

BakedRow baked_row(const exporter::PictureRow& row, const Outline& outline) {
    constexpr double kMostUpright = 0.9;
    BakedRow baked{.row = row,
                   .along_mm = outline.along(static_cast<float>(row.y_mm), row.inside),
                   .fine = vec2(row.normal)};
    // Floors, feet and flat rims use the mesh's normal.
    if (std::fabs(row.normal.y) > kMostUpright) {
        baked.along_mm += static_cast<float>(row.inside ? -row.radius_mm : row.radius_mm);
        return baked;
    }
    const vec2 own = outline.normal(baked.along_mm);
    // Beside a ledge the outline's averaged normal turns into the ledge; the mesh has that edge itself. The
    // change is gradual, because a step between texels shows as a ring.
    constexpr float kOtherFace = 0.94F;
    constexpr float kSameFace = 0.99F;
    const float trust =
        std::clamp((glm::dot(own, baked.fine) - kOtherFace) / (kSameFace - kOtherFace), 0.0F, 1.0F);
    baked.fine = glm::normalize(glm::mix(baked.fine, own, trust));
    return baked;
}

// Tangent space at that row from the mesh's normal (r, y) and the pictures' up direction. The result is the
// outline's normal, with the leans added.
vec3 in_tangent_space(const BakedRow& baked, float lean_round, float lean_up) {
    const vec2 out(baked.row.normal);
    const vec2 along(-out.y, out.x);
    const vec2 shown = baked.fine + vec2(0.0F, lean_up);
    return glm::normalize(vec3(lean_round, glm::dot(shown, along), std::max(glm::dot(shown, out), 0.1F)));
}

}  // namespace

PotLook lathe_look(const render::LatheMaterial& material, std::string name) {
    const vec3 body = glm::mix(material.albedo, wet_albedo(material.albedo), material.wetness);
    const float roughness =
        shaders::lathe_roughness(material.roughness, render::wet_roughness(material), material.wetness);
    // Two copies of the texture go round, clockwise seen from above, as in lathe.vert.
    std::vector<Between> columns;
    for (int x = 0; x < kPictureSide; ++x)
        columns.push_back(between_texels(-angle_of_column(x) * std::numbers::inv_pi_v<float>));
    const auto at = [=, texels = streak_texels(), columns = std::move(columns)](const Place& row,
                                                                                std::span<Surface> round) {
        const Between up = between_texels(row.along_mm / shaders::kStreakMm);
        const vec4* const top = texels.data() + up.first * render::kDetailTexels;
        const vec4* const low = texels.data() + up.second * render::kDetailTexels;
        for (std::size_t x = 0; x < round.size(); ++x) {
            const auto [left, right, fraction] = columns[x];
            const vec4 mark = glm::mix(glm::mix(top[left], top[right], fraction),
                                       glm::mix(low[left], low[right], fraction), up.fraction);
            round[x] = {.colour = body * shaders::lathe_tone(material.streaks, mark.x),
                        .roughness = roughness,
                        .coat = shaders::lathe_film(material.film, mark.w, material.coat),
                        .lean_round = -shaders::lathe_lean(material.streaks, mark.y),
                        .lean_up = shaders::lathe_lean(material.streaks, mark.z)};
        }
    };
    return {.name = std::move(name), .coat_roughness = render::film_roughness(material), .at = at};
}

PotLook glaze_look(const finish::GlazeMaterial& glaze, float height_mm) {
    const auto at = [=](const Place& row, std::span<Surface> round) {
        for (std::size_t x = 0; x < round.size(); ++x) {
            const finish::GlazePlace here{.height_mm = row.height_mm,
                                          .angle = angle_of_column(static_cast<int>(x)),
                                          .inside = row.inside};
            constexpr float kBareRoughness = 0.85F;
            const bool is_bare = finish::is_bare(glaze, here);
            round[x] = {.colour = finish::glaze_colour(glaze, height_mm, here),
                        .roughness = is_bare ? kBareRoughness : glaze.roughness,
                        .coat = is_bare ? 0.0F : glaze.clear_coat,
                        .lean_up = finish::kFingerLean * finish::finger_ring(here)};
        }
    };
    return {.name = std::string(glaze.id), .coat_roughness = glaze.coat_roughness, .at = at};
}

PotLook marked_look(PotLook look, const decoration::Marks& marks, const finish::MarkPalette& palette,
                    float height_mm) {
    const auto texture = std::make_shared<const decoration::Texture>(decoration::texture_of(marks));
    const auto at = [=, wall = marks.wall, plain = std::move(look.at)](const Place& place,
                                                                       std::span<Surface> round) {
        plain(place, round);
        if (place.inside) return;
        const int row = decoration::row_at(place.height_mm / height_mm);
        for (std::size_t x = 0; x < round.size(); ++x) {
            Surface& surface = round[x];
            const float angle = angle_of_column(static_cast<int>(x));
            const int column = decoration::column_at(0.5F * angle * std::numbers::inv_pi_v<float>);
            surface.colour =
                finish::marked(surface.colour, finish::mark_colour(palette, texture->at(column, row)));
            const vec2 lean = finish::relief_lean(*texture, wall, column, row);
            surface.lean_round += lean.x;
            surface.lean_up += lean.y;
        }
    };
    return {.name = std::move(look.name), .coat_roughness = look.coat_roughness, .at = at};
}

PotPictures bake(const std::vector<exporter::PictureRow>& rows, const exporter::PotRings& rings,
                 double shrinkage, const PotLook& look) {
    PotPictures pictures{.base_colour = blank(), .normal = blank(), .surface = blank(), .coat = blank()};
    const Outline outline(rings, shrinkage);
    RowsByPlace places(rows);
    std::array<std::vector<Surface>, kSubRows> rounds;
    for (std::vector<Surface>& round : rounds)
        round.resize(kPictureSide);
    for (int y = 0; y < kPictureSide; ++y) {
        std::array<BakedRow, kSubRows> sub;
        for (int i = 0; i < kSubRows; ++i) {
            const double v = (y + (i + 0.5) / kSubRows) / kPictureSide;
            BakedRow& baked = sub[static_cast<std::size_t>(i)];
            baked = baked_row(places.at(v), outline);
            look.at({.height_mm = static_cast<float>(baked.row.y_mm),
                     .along_mm = baked.along_mm,
                     .inside = baked.row.inside},
                    rounds[static_cast<std::size_t>(i)]);
        }
        const float open = outline.open(sub[kSubRows / 2].row);
        for (std::size_t x = 0; x < kPictureSide; ++x) {
            Surface mean{.colour = vec3(0.0F), .roughness = 0.0F, .coat = 0.0F};
            vec3 normal(0.0F);
            for (std::size_t i = 0; i < kSubRows; ++i) {
                const BakedRow& baked = sub[i];
                const Surface& found = rounds[i][x];
                mean.colour += found.colour / static_cast<float>(kSubRows);
                mean.roughness += found.roughness / static_cast<float>(kSubRows);
                mean.coat += found.coat / static_cast<float>(kSubRows);
                normal += in_tangent_space(baked, found.lean_round, found.lean_up);
            }
            const std::size_t texel = static_cast<std::size_t>(y) * kPictureSide + x;
            for (int channel = 0; channel < 3; ++channel)
                pictures.base_colour.rgba[4 * texel + static_cast<std::size_t>(channel)] =
                    render::srgb_byte(mean.colour[channel]);
            put_texel(pictures.normal, texel, 0.5F + 0.5F * glm::normalize(normal));
            put_texel(pictures.surface, texel, vec3(open, mean.roughness, 0.0F));
            put_texel(pictures.coat, texel, vec3(mean.coat));
            pictures.is_coated = pictures.is_coated || mean.coat > 0.0F;
        }
    }
    return pictures;
}

Result<exporter::PotFile> dressed_pot(const clay::StudioClay& clay, clay::Firing stage, const PotLook& look,
                                      exporter::PotStory story) {
    const exporter::PotRings rings = exporter::rings_of(clay.rings());
    const double shrinkage = clay::shrunk_scale(clay.lump().body, stage);
    auto pot = exporter::viewed_solid(clay, stage);
    if (!pot) return pot.error();
    const PotPictures pictures = bake(pot->picture_rows, rings, shrinkage, look);
    asset::Material material{
        .name = look.name, .base_colour_linear = dvec3(1.0), .roughness = 1.0, .metallic = 1.0};
    // Higher quality where the eye is sensitive: colour, then shape.
    constexpr int kColourQuality = 88;
    constexpr int kNormalQuality = 85;
    constexpr int kSurfaceQuality = 75;
    const auto put = [](std::vector<std::byte>& into, const asset::Image& image,
                        int quality) -> Result<void> {
        auto bytes = asset::encode_jpeg(image, quality);
        if (!bytes) return bytes.error();
        into = std::move(bytes).value();
        return {};
    };
    asset::Textures& textures = material.textures;
    Result<void> done = put(textures.base_colour, pictures.base_colour, kColourQuality);
    if (done) done = put(textures.normal, pictures.normal, kNormalQuality);
    if (done) done = put(textures.surface, pictures.surface, kSurfaceQuality);
    if (done && pictures.is_coated) {
        material.clearcoat = {.factor = 1.0, .roughness = double{look.coat_roughness}};
        done = put(textures.clearcoat, pictures.coat, kSurfaceQuality);
    }
    if (!done) return done.error();
    asset::order_for_drawing(pot->mesh);
    return exporter::PotFile{.content = exporter::pot_content(
                                 "Pot, " + exporter::pot_name(clay.lump().body, stage), std::move(pot->mesh),
                                 std::move(material), exporter::pot_extras(clay, stage), std::move(story))};
}

Result<std::vector<std::byte>> dressed_glb(const clay::StudioClay& clay, clay::Firing stage,
                                           const PotLook& look, exporter::PotStory story) {
    return exporter::encode_pot(dressed_pot(clay, stage, look, std::move(story)), exporter::ExportKind::kGlb);
}

}  // namespace onggi::look
