// Textured pots: still sound solids, small enough for a phone, with the right pictures.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

#include "game/clay/studio/pot.h"
#include "game/exporter/pot_faces.h"
#include "game/exporter/studio_export.h"
#include "game/finish/glaze.h"
#include "game/look/pot_pictures.h"
#include "game/wheel/clay_look.h"
#include "tests/support/mesh_check.h"
#include "tests/support/studio_samples.h"

namespace onggi {
namespace {

using support::StudioSample;

const std::vector<StudioSample>& samples() {
    static const std::vector<StudioSample> all = support::all_studio_samples();
    return all;
}

const StudioSample& sample(std::string_view name) {
    return *std::find_if(samples().begin(), samples().end(),
                         [&](const auto& pot) { return pot.name == name; });
}

double scale_of(const StudioSample& pot) {
    return clay::shrunk_scale(pot.clay.lump().body, pot.stage);
}

std::vector<std::byte> dressed(const StudioSample& pot) {
    auto bytes = look::dressed_glb(
        pot.clay, pot.stage, look::lathe_look(wheel::clay_material(pot.clay.lump().body, pot.stage), "clay"));
    EXPECT_TRUE(bytes) << pot.name << ": " << (bytes ? "" : bytes.error().message);
    return bytes ? *bytes : std::vector<std::byte>{};
}

std::size_t gzipped(const std::vector<std::byte>& bytes) {
    uLongf size = compressBound(bytes.size());
    std::vector<Bytef> packed(size);
    compress2(packed.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
    return size;
}

TEST(DressedPot, IsASoundSolidOfTheClaysVolumeSmallEnoughForAPhone) {
    for (const StudioSample& pot : samples()) {
        const auto bytes = dressed(pot);
        const auto file = support::read_glb(bytes);
        ASSERT_TRUE(file) << pot.name << ": " << file.error().message;
        const double metres = 1e-3 * scale_of(pot);
        support::ExpectedPot expected;
        expected.volume_m3 = pot.clay.volume_mm3() * metres * metres * metres;
        expected.volume_tolerance = 1e-6;
        expected.height_m = pot.clay.height_mm() * metres;
        const auto outer = pot.clay.outer_mm();
        expected.max_radius_m = *std::max_element(outer.begin(), outer.end()) * metres;
        // 48 corners at the coarsest: 0.14 per cent outside the circle.
        expected.radius_tolerance_m = pot.calm ? 2e-3 * expected.max_radius_m : 0.6e-3;
        expected.off_axis_m = pot.off_axis_mm * metres;
        expected.euler = pot.euler;
        expected.parts = pot.parts;
        if (pot.stage == clay::Firing::kGlaze) expected.min_normal_agreement = 0.0;  // a low step is smooth
        if (!pot.calm) expected.min_normal_agreement = -1.0;
        EXPECT_EQ(support::find_faults(file->mesh, expected), std::vector<std::string>{}) << pot.name;
        EXPECT_LE(file->mesh.indices.size() / 3, exporter::kMaxSharedTriangles) << pot.name;
        EXPECT_LE(gzipped(bytes), 1'000'000U) << pot.name;
        const bool shines = pot.stage == clay::Firing::kWet || pot.stage == clay::Firing::kGlaze;
        EXPECT_EQ(file->json.at("materials").at(0).contains("extensions"), shines) << pot.name;
    }
}

// By its scene's text: the GLB's vertices, triangles and extent.
TEST(DressedPot, IsTheSameMeshForIPhones) {
    for (const char* name : {"studio_cylinder_glazed", "studio_vase_bisque", "studio_lump"}) {
        const StudioSample& pot = sample(name);
        const auto file = look::dressed_pot(
            pot.clay, pot.stage,
            look::lathe_look(wheel::clay_material(pot.clay.lump().body, pot.stage), "clay"));
        const auto usdz = exporter::encode_pot(file, exporter::ExportKind::kUsdz);
        ASSERT_TRUE(usdz) << name << ": " << usdz.error().message;
        const std::string text(reinterpret_cast<const char*>(usdz->data()), usdz->size());
        // The list behind that word, up to its closing bracket.
        const auto numbers_of = [&](const std::string& word) {
            const std::size_t begin = text.find(word + " = [") + word.size() + 4;
            std::string list = text.substr(begin, text.find(']', begin) - begin);
            std::replace_if(
                list.begin(), list.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
            std::istringstream in(list);
            return std::vector<double>(std::istream_iterator<double>(in), {});
        };
        const asset::Mesh& mesh = file->content.mesh;
        const auto glb = support::read_glb(dressed(pot));
        ASSERT_TRUE(glb);
        EXPECT_EQ(numbers_of("points").size(), 3 * glb->mesh.positions_m.size()) << name;
        EXPECT_EQ(numbers_of("normals").size(), 3 * mesh.normals.size()) << name;
        EXPECT_EQ(numbers_of("primvars:st").size(), 2 * mesh.uvs.size()) << name;
        EXPECT_EQ(numbers_of("faceVertexCounts"), std::vector<double>(mesh.triangle_count(), 3.0)) << name;
        const auto indices = numbers_of("faceVertexIndices");
        EXPECT_TRUE(
            std::equal(indices.begin(), indices.end(), glb->mesh.indices.begin(), glb->mesh.indices.end()))
            << name;
        const auto extent = numbers_of("extent");
        ASSERT_EQ(extent.size(), 6U);
        constexpr double kMicrometre = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(extent[static_cast<std::size_t>(axis)], glb->stated_min_m[axis], kMicrometre) << name;
            EXPECT_NEAR(extent[static_cast<std::size_t>(axis) + 3], glb->stated_max_m[axis], kMicrometre)
                << name;
        }
    }
}

TEST(GlazedPot, IsAtMostAMegabyteAndAThirdOfItOnTheWire) {
    // The glaze with the most to compress: a brushed slip.
    const finish::GlazeMaterial& brushed = *finish::find_glaze("buncheong");
    for (const StudioSample& pot : samples()) {
        if (!pot.calm) continue;
        const auto bytes =
            look::dressed_glb(pot.clay, clay::Firing::kGlaze,
                              look::glaze_look(brushed, static_cast<float>(pot.clay.height_mm())));
        ASSERT_TRUE(bytes) << pot.name;
        EXPECT_LE(bytes->size(), 1'000'000U) << pot.name;
        EXPECT_LE(gzipped(*bytes), 350'000U) << pot.name;
    }
}

// Clients draw rows that are close together, or normals that part at an edge, as rings of a hair's width.
TEST(GlazedPot, HasRoundEdgesAndNoRowsOfAHairsWidth) {
    for (const StudioSample& pot : samples()) {
        // A lump ends in a disc too small for a rounding.
        if (!pot.calm || pot.euler != 2 || pot.name == "studio_lump") continue;
        const auto solid = exporter::viewed_solid(pot.clay, clay::Firing::kGlaze);
        ASSERT_TRUE(solid) << pot.name;
        std::map<std::array<float, 3>, vec3> normals;
        for (std::size_t i = 0; i < solid->mesh.positions_m.size(); ++i) {
            const vec3& at = solid->mesh.positions_m[i];
            const auto [known, is_new] = normals.try_emplace({at.x, at.y, at.z}, solid->mesh.normals[i]);
            constexpr float kParted = 0.3F;  // an edge of 20 degrees parts them by 0.35
            ASSERT_LT(glm::distance(known->second, solid->mesh.normals[i]), kParted)
                << pot.name << " " << at.y;
        }
        const double least_mm = std::min(exporter::kNearestGlazedRowsMm,
                                         exporter::thinnest_mm(exporter::rings_of(pot.clay.rings())) / 4.0 *
                                             clay::shrunk_scale(pot.clay.lump().body, clay::Firing::kGlaze));
        for (std::size_t i = 1; i < solid->picture_rows.size(); ++i) {
            const exporter::PictureRow& above = solid->picture_rows[i - 1];
            const exporter::PictureRow& below = solid->picture_rows[i];
            const double apart_mm = std::hypot(above.radius_mm - below.radius_mm, above.y_mm - below.y_mm);
            const bool is_same = apart_mm == 0.0;  // a disc and the wall that it closes
            ASSERT_TRUE(is_same || apart_mm >= least_mm - 1e-9) << pot.name << " " << above.y_mm;
        }
    }
}

TEST(DressedPot, GivesItsOutsideTwoThirdsOfThePictures) {
    for (const char* name : {"studio_cylinder", "studio_cylinder_glazed", "studio_vase_bisque"}) {
        const auto solid = exporter::viewed_solid(sample(name).clay, sample(name).stage);
        ASSERT_TRUE(solid);
        double top = 1.0;
        double bottom = 0.0;
        for (const exporter::PictureRow& row : solid->picture_rows) {
            if (row.inside || row.radius_mm == 0.0) continue;
            top = std::min(top, row.v);
            bottom = std::max(bottom, row.v);
        }
        EXPECT_NEAR(bottom - top, 2.0 / 3.0, 1e-2) << name;
    }
}

TEST(DressedPot, WearsPicturesThatGoWithItsAttributes) {
    const auto file = support::read_glb(dressed(sample("studio_dented")));
    ASSERT_TRUE(file);
    const nlohmann::json& attributes = file->json.at("meshes")[0]["primitives"][0]["attributes"];
    EXPECT_TRUE(attributes.contains("TANGENT"));
    EXPECT_TRUE(attributes.contains("TEXCOORD_0"));
    const nlohmann::json& material = file->json.at("materials")[0];
    EXPECT_TRUE(material.contains("normalTexture"));
    EXPECT_TRUE(material.contains("occlusionTexture"));
    for (const nlohmann::json& image : file->json.at("images"))
        EXPECT_EQ(image.at("mimeType"), "image/jpeg");
}

TEST(DressedPot, IsTheSameFileTwice) {
    EXPECT_EQ(dressed(samples().front()), dressed(samples().front()));
}

// Counts vertex normals that point away from one of their faces.
int against_their_faces(const asset::Mesh& mesh) {
    int count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const dvec3 a(mesh.positions_m[mesh.indices[i]]);
        const dvec3 area = glm::cross(dvec3(mesh.positions_m[mesh.indices[i + 1]]) - a,
                                      dvec3(mesh.positions_m[mesh.indices[i + 2]]) - a);
        for (std::size_t k = 0; k < 3; ++k)
            count += glm::dot(dvec3(mesh.normals[mesh.indices[i + k]]), area) <= 0.0;
    }
    return count;
}

// A wall with a band of narrow, deep dents that shift from row to row, as pressed by a rasp.
exporter::PotRings pressed_wall() {
    exporter::PotRings rings;
    constexpr int kRings = 400;
    rings.sectors = 64;
    for (int i = 0; i <= kRings; ++i)
        rings.edge_mm.push_back(0.25 * i);
    double volume = 0.0;
    for (int i = 0; i < kRings; ++i) {
        rings.outer_mm.push_back(40.0);
        rings.inner_mm.push_back(i < 40 ? 0.0 : 34.0);
        volume += M_PI * 0.25 * (1600.0 - rings.inner(i) * rings.inner(i));
        for (int sector = 0; sector < rings.sectors; ++sector) {
            const int at = (sector * 37 + (i / 2) * 101) % 23;
            rings.dents_mm.push_back(i >= 200 && i < 240 ? 0.5F * static_cast<float>(at - 11) : 0.0F);
        }
    }
    rings.volume_mm3 = volume;
    return rings;
}

TEST(DentedPot, HasNoNormalAgainstOneOfItsFaces) {
    for (const exporter::PotRings& rings :
         {exporter::rings_of(sample("studio_dented").clay.rings()), pressed_wall()}) {
        for (const bool unwraps : {false, true}) {
            const auto solid = exporter::build_pot_solid(rings, {.unwraps = unwraps});
            ASSERT_TRUE(solid) << solid.error().message;
            EXPECT_EQ(against_their_faces(solid->mesh), 0);
        }
    }
}

// The mean of a part of a picture, in eighths from the top.
dvec3 mean_of(const asset::Image& image, int from_row, int to_row) {
    dvec3 sum(0.0);
    for (int y = from_row; y < to_row; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto at = static_cast<std::size_t>(4 * (y * image.width + x));
            for (int channel = 0; channel < 3; ++channel)
                sum[channel] += image.rgba[at + static_cast<std::size_t>(channel)];
        }
    }
    return sum / (double(to_row - from_row) * image.width);
}

TEST(PotPictures, ShowAGlazeABareFootAndADarkInside) {
    clay::StudioClay pot({.mass_g = 500.0});
    pot.set_wall(40.0, 5.0, 10.0, 80.0, 400);
    const exporter::PotRings rings = exporter::rings_of(pot.rings());
    const auto solid =
        exporter::build_pot_solid(rings, {.most_triangles = exporter::kMaxSharedTriangles, .unwraps = true});
    ASSERT_TRUE(solid);
    const finish::GlazeMaterial& celadon = finish::glaze_at(0);
    const look::PotPictures pictures =
        look::bake(solid->picture_rows, rings, 1.0, look::glaze_look(celadon, 80.0F));
    // From the top: floor 35 mm, inside 70, rim 5: 2.28 texels a mm, to row 250; the outside to row 933;
    // foot.
    const dvec3 wall = mean_of(pictures.base_colour, 600, 800);
    const dvec3 foot = mean_of(pictures.base_colour, 940, 1020);
    EXPECT_GT(wall.y, wall.x + 3.0) << "celadon is green";
    EXPECT_GT(foot.x, foot.y + 10.0) << "its body is brown";
    EXPECT_GT(mean_of(pictures.coat, 600, 800).x, 200.0);
    EXPECT_EQ(mean_of(pictures.coat, 940, 1020).x, 0.0);
    EXPECT_GT(mean_of(pictures.surface, 300, 400).x, 2.0 * mean_of(pictures.surface, 40, 100).x) << "sky";
    EXPECT_NEAR(mean_of(pictures.normal, 600, 800).z, 255.0, 3.0);
    EXPECT_NEAR(mean_of(pictures.normal, 600, 800).x, 127.5, 2.0);
}

// Converts between a height on the outside (mm of the file) and a row of the pictures.
double height_at_row(const std::vector<exporter::PictureRow>& rows, double row) {
    const double v = (row + 0.5) / look::kPictureSide;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].v < v) continue;
        const double part = (v - rows[i - 1].v) / std::max(rows[i].v - rows[i - 1].v, 1e-12);
        return glm::mix(rows[i - 1].y_mm, rows[i].y_mm, part);
    }
    return 0.0;
}

TEST(DressedPot, ShowsItsDecorationWithinTwoMillimetresOfTheStrokes) {
    using decoration::stroke_point;
    const StudioSample& pot = sample("studio_cylinder_glazed");
    const exporter::PotRings rings = exporter::rings_of(pot.clay.rings());
    std::vector<vec2> outline;
    for (int i = 0; i < rings.count(); ++i) {
        const std::size_t ring = exporter::PotRings::at(i);
        outline.push_back({static_cast<float>(rings.outer_mm[ring]),
                           static_cast<float>(i == 0 ? 0.0 : rings.edge_mm[ring + 1])});
    }
    const double wet_mm = double{outline.back().y};
    decoration::Stroke band{.technique = decoration::Technique::kIron, .width = 400};
    for (int i = 0; i <= 64; ++i)
        band.points.push_back(stroke_point(i / 64.0, 0.6 * wet_mm).value());
    decoration::Stroke line{
        .technique = decoration::Technique::kInlay,
        .slip = decoration::Slip::kBlack,
        .width = 300,
        .points = {stroke_point(0.3, 0.2 * wet_mm).value(), stroke_point(0.3, 0.5 * wet_mm).value()}};
    const auto canvas = decoration::Canvas::of(decoration::wall_of(outline), {band, line});
    ASSERT_TRUE(canvas);
    const double scale = scale_of(pot);
    const auto height_mm = static_cast<float>(wet_mm * scale);
    const finish::GlazeMaterial& white = *finish::find_glaze("porcelain");
    const auto solid = exporter::viewed_solid(pot.clay, pot.stage);
    ASSERT_TRUE(solid);
    const look::PotPictures worn = look::bake(
        solid->picture_rows, rings, scale,
        look::marked_look(look::glaze_look(white, height_mm), canvas->marks(), white.marks, height_mm));
    const auto is_dark = [&](int column, int row) {
        return worn.base_colour.rgba[static_cast<std::size_t>(4 * (row * look::kPictureSide + column))] < 160;
    };
    for (int column = 0; column < look::kPictureSide; column += 16) {
        double sum_mm = 0.0;
        int rows = 0;
        for (int row = 0; row < look::kPictureSide; ++row) {
            const double y_mm = height_at_row(solid->picture_rows, row);
            if (!is_dark(column, row) || y_mm < 0.55 * wet_mm * scale) continue;
            sum_mm += y_mm;
            ++rows;
        }
        ASSERT_GT(rows, 0) << column;
        ASSERT_NEAR(sum_mm / rows, 0.6 * wet_mm * scale, 2.0) << column;
    }
    double turns = 0.0;
    int places = 0;
    for (int row = 0; row < look::kPictureSide; ++row) {
        const double y_mm = height_at_row(solid->picture_rows, row) / scale;
        if (y_mm < 0.25 * wet_mm || y_mm > 0.45 * wet_mm) continue;
        for (int column = 0; column < look::kPictureSide; ++column) {
            if (!is_dark(column, row)) continue;
            turns += (column + 0.5) / look::kPictureSide;
            ++places;
        }
    }
    ASSERT_GT(places, 0);
    EXPECT_NEAR(turns / places * double{canvas->wall().round_mm[180]},
                0.3 * double{canvas->wall().round_mm[180]}, 2.0);
}

}  // namespace
}  // namespace onggi
