#include "engine/ui/draw_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace onggi::ui {
namespace {

TEST(DrawList, MultipliesColoursByTheirAlpha) {
    EXPECT_EQ(packed({1.0F, 0.5F, 0.0F, 0.5F}), 0x80004080U);
}

TEST(DrawList, JoinsShapesOfOnePipeline) {
    DrawList list;
    list.add_box({0, 0, 10, 10}, Colour{});
    list.add_box({10, 0, 10, 10}, Colour{});
    list.add_picture({0, 0}, {0, 0, 5, 5}, 1.0F);
    list.add_box({0, 0, 1, 1}, Colour{});
    ASSERT_EQ(list.runs().size(), 3U);
    EXPECT_EQ(list.runs()[0].index_count, 12U);
    EXPECT_TRUE(list.runs()[1].from_atlas);
}

TEST(DrawList, SkipsInvisibleShapes) {
    DrawList list;
    list.add_picture({0, 0}, {0, 0, 5, 5}, 0.0F);
    list.add_line(std::array{vec2(1.0F)}, 2.0F, Colour{});
    list.add_polygon(std::array{vec2(1.0F), vec2(2.0F)}, Colour{});
    EXPECT_TRUE(list.runs().empty());
}

TEST(DrawList, FadesALineAtBothEdges) {
    DrawList list;
    list.add_line(std::array{vec2(0.0F), vec2(10.0F, 0.0F)}, 4.0F, hex(0xffffff));
    ASSERT_EQ(list.vertices().size(), 8U);
    EXPECT_EQ(list.vertices()[0].position_px, vec2(0.0F, -3.0F));
    EXPECT_EQ(list.vertices()[0].rgba, 0U);
    EXPECT_EQ(list.vertices()[1].rgba, 0xffffffffU);
    EXPECT_EQ(list.vertices()[3].rgba, 0U);
}

TEST(DrawList, RoundsADiscAndFadesItsEdge) {
    DrawList list;
    list.add_disc({20.0F, 30.0F}, 8.0F, hex(0xffffff));
    float farthest_px = 0.0F;
    for (const Vertex& vertex : list.vertices()) {
        const float out_px = glm::length(vertex.position_px - vec2(20.0F, 30.0F));
        farthest_px = std::max(farthest_px, out_px);
        EXPECT_TRUE(out_px < 8.5F || vertex.rgba == 0U) << out_px;
    }
    EXPECT_GT(farthest_px, 9.0F);
    EXPECT_LT(farthest_px, 9.5F);
}

TEST(DrawList, HasAHashOfItsContents) {
    DrawList one;
    DrawList other;
    one.add_box({0, 0, 10, 10}, Colour{});
    other.add_box({0, 0, 10, 10}, Colour{});
    EXPECT_EQ(one.hash(), other.hash());
    other.clear();
    other.add_box({0, 0, 10, 11}, Colour{});
    EXPECT_NE(one.hash(), other.hash());
}

}  // namespace
}  // namespace onggi::ui
