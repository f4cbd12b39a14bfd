#include "engine/render/shapes/lathe_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/shapes/frame_build.h"
#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

struct Built {
    explicit Built(const Lathe& lathe) {
        build_profile(lathe, profile);
        samples = samples_of(profile);
        chosen = choose_rows(profile, profile.points.size(), {.max_rows = 128});
        fill_rows(lathe, profile, samples, chosen, rows);
        fill_vertices(
            {.lathe = lathe, .profile = profile, .samples = samples, .chosen = chosen, .rows = rows},
            {.towards_light = glm::normalize(vec3(-1.0F, 1.0F, 0.5F))}, even_sectors(lathe, kSectors),
            vertices);
    }
    [[nodiscard]] const shaders::VertexData& at(std::size_t row, int sector) const {
        return vertices[row * (kSectors + 1) + static_cast<std::size_t>(sector)];
    }
    // The volume: one sixth of the sum of the faces' triple products; the base closes the solid.
    [[nodiscard]] double volume_mm3() const {
        double six = 0.0;
        const auto add = [&](const vec4& a, const vec4& b, const vec4& c) {
            six += glm::dot(dvec3(a), glm::cross(dvec3(b), dvec3(c)));
        };
        for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
            for (int s = 0; s < kSectors; ++s) {
                add(at(row, s).place, at(row + 1, s).place, at(row, s + 1).place);
                add(at(row, s + 1).place, at(row + 1, s).place, at(row + 1, s + 1).place);
            }
        }
        return six / 6.0;  // the base lies at y = 0 and through the origin: it adds nothing
    }
    LatheProfile profile;
    LatheSamples samples;
    LatheRows chosen;
    std::vector<shaders::RowData> rows;
    std::vector<shaders::VertexData> vertices;
};

struct LatheVertices : testing::Test {
    const Cylinder pot;
};

TEST_F(LatheVertices, EncloseTheClayWithOutwardFaces) {
    const Built built(pot.lathe(0.0F));
    const double expected = 3.14159265358979 * (50.0 * 50.0 * 100.0 - 45.0 * 45.0 * 90.0);
    // The polygon straddles the circle, so its area is a little larger than the inscribed one's.
    EXPECT_NEAR(built.volume_mm3() / expected, 1.0, 0.01);
}

TEST_F(LatheVertices, CloseEveryRowToTheBit) {
    const Built built(pot.lathe());
    for (std::size_t row = 0; row < built.rows.size(); ++row)
        EXPECT_EQ(built.at(row, 0).place, built.at(row, kSectors).place) << row;
}

TEST_F(LatheVertices, DentWhereTheMapSaysAndTurnItWithTheWheel) {
    // Between sectors 15 and 16 of 64 counter-clockwise from +X lies -Z.
    std::vector<float> dents(8 * kDentSectors, 0.0F);
    for (std::size_t row = 0; row < 8; ++row)
        dents[row * kDentSectors + 15] = dents[row * kDentSectors + 16] = -3.0F;
    Lathe lathe = pot.lathe();
    lathe.dents_mm = dents;
    const auto deepest = [](const Built& built) {
        vec2 found(0.0F);
        float least = 1e9F;
        for (int s = 0; s < kSectors; ++s) {
            const vec4& place = built.at(2, s).place;
            const float r = std::hypot(place.x, place.z);
            if (r < least) {
                least = r;
                found = {place.x, place.z};
            }
        }
        return found;
    };
    const vec2 still = deepest(Built(lathe));
    EXPECT_NEAR(still.x, 0.0F, 0.5F);
    EXPECT_NEAR(still.y, -47.0F, 0.2F);
    lathe.turn = {0.0F, 1.0F};  // a quarter counter-clockwise: from -Z to -X
    const vec2 turned = deepest(Built(lathe));
    EXPECT_NEAR(turned.x, -47.0F, 0.2F);
    EXPECT_NEAR(turned.y, 0.0F, 0.5F);
}

TEST_F(LatheVertices, MoveBothFacesOfADentedWallAlike) {
    std::vector<float> dents(4 * kDentSectors, 1.5F);
    Lathe lathe = pot.lathe();
    lathe.dents_mm = dents;
    const Built round(pot.lathe());
    const Built moved(lathe);
    for (const std::size_t row : {std::size_t{1}, moved.chosen.inside + 1}) {
        const vec4& before = round.at(row, 7).place;
        const vec4& after = moved.at(row, 7).place;
        EXPECT_NEAR(std::hypot(after.x, after.z) - std::hypot(before.x, before.z), 1.5F, 1e-3F);
    }
    EXPECT_FLOAT_EQ(largest_offset_mm(lathe), 1.5F);
}

TEST_F(LatheVertices, LeanTheWayOutwardsAcrossADent) {
    std::vector<float> dents(4 * kDentSectors);
    for (std::size_t i = 0; i < dents.size(); ++i)
        dents[i] = 2.0F * std::sin(kTurnF * (static_cast<float>(i % kDentSectors) + 0.5F) / kDentSectors);
    Lathe lathe = pot.lathe();
    lathe.dents_mm = dents;
    const Built built(lathe);
    // r = 50 + 2 sin(phi), phi counter-clockwise. At phi = 0 (+X) the wall grows towards -Z, so it leans to
    // +Z.
    const vec4& lean = built.at(2, 0).lean;
    EXPECT_NEAR(lean.z, std::sin(std::atan(2.0F / 50.0F)), 5e-3F);
    EXPECT_NEAR(std::hypot(lean.x, lean.z), 1.0F, 1e-4F);
}

TEST_F(LatheVertices, CarryAPotOffItsCentreRoundTheAxis) {
    const std::vector<vec2> centres(pot.outer.size(), vec2(6.0F, 0.0F));
    Lathe lathe = pot.lathe();
    lathe.centre_mm = centres;
    const auto middle = [](const Built& built) {
        return 0.5F * (vec3(built.at(2, 0).place) + vec3(built.at(2, kSectors / 2).place));
    };
    EXPECT_NEAR(middle(Built(lathe)).x, 6.0F, 1e-3F);
    lathe.turn = {0.0F, 1.0F};  // counter-clockwise from above: +X goes to -Z
    const vec3 turned = middle(Built(lathe));
    EXPECT_NEAR(turned.x, 0.0F, 1e-3F);
    EXPECT_NEAR(turned.z, -6.0F, 1e-3F);
    EXPECT_FLOAT_EQ(largest_offset_mm(lathe), 6.0F);
}

TEST_F(LatheVertices, CutOpenKeepOnlyThePartBehindTheSection) {
    Lathe lathe = pot.lathe();
    lathe.cut = LatheCut{.towards_rad = 0.3F};
    const vec2 facing(std::sin(0.3F), std::cos(0.3F));
    const Built built(lathe);
    for (const shaders::VertexData& vertex : built.vertices)
        EXPECT_LT(vertex.place.x * facing.x + vertex.place.z * facing.y, 1e-2F);
}

}  // namespace
}  // namespace onggi::render
