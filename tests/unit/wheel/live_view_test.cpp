#include "game/wheel/live_view.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "game/wheel/still.h"

namespace onggi::wheel {
namespace {

TEST(LiveView, DrawsFramesIntoMemoryWithoutADisplay) {
    auto view = LiveView::open({.width = 320, .height = 240, .headless = true, .validation = true});
    ASSERT_TRUE(view) << view.error().message;
    pot::Pot pot{.outer_mm = std::vector<float>(500, 60.0F), .height_mm = 200.0};
    asset::Image before;
    for (int frame = 0; frame < 3; ++frame) {
        const auto drawn = (*view)->draw({.pot = &pot});
        ASSERT_TRUE(drawn) << drawn.error().message;
        EXPECT_TRUE(*drawn);
        auto image = (*view)->read_back();
        ASSERT_TRUE(image);
        EXPECT_EQ(image->width, 320);
        EXPECT_EQ(image->rgba.size(), 320U * 240U * 4U);
        EXPECT_NE(image->rgba, before.rgba) << "frame " << frame << " shows what the one before it showed";
        before = std::move(*image);
        for (float& radius : pot.outer_mm)
            radius -= 5.0F;
    }
}

// There a moving camera costs four frames' time.
TEST(LiveView, KeepsItsCameraStillOnAProcessor) {
    auto view = LiveView::open({.width = 320, .height = 180, .headless = true, .validation = true});
    ASSERT_TRUE(view) << view.error().message;
    const pot::Pot pot{.outer_mm = std::vector<float>(500, 60.0F), .height_mm = 200.0};
    (*view)->sway(true);
    for (int frame = 0; frame < 8; ++frame) {
        ASSERT_TRUE((*view)->draw({.pot = &pot}, 0.5));
        if (frame >= 4) {
            EXPECT_FALSE((*view)->frame_stats().still_life_drawn) << frame;
        }
    }
}

TEST(LiveView, TakesPotsOfAnyNumberOfElementsOneAfterAnother) {
    auto view = LiveView::open({.width = 160, .height = 120, .headless = true, .validation = true});
    ASSERT_TRUE(view) << view.error().message;
    for (const std::size_t count : {100U, 200000U, 1U, 2000U, 0U}) {
        const pot::Pot pot{.outer_mm = std::vector<float>(count, 50.0F), .height_mm = 200.0};
        const auto drawn = (*view)->draw({.pot = &pot});
        ASSERT_TRUE(drawn) << count << ": " << drawn.error().message;
        ASSERT_TRUE((*view)->read_back());
    }
}

TEST(LiveView, ShowsTheSamePictureAfterAnotherAndBack) {
    auto view = LiveView::open({.width = 320, .height = 240, .headless = true});
    ASSERT_TRUE(view) << view.error().message;
    const pot::Pot lump{.outer_mm = std::vector<float>(2000, 60.0F), .height_mm = 200.0};
    const pot::Pot thin{.outer_mm = std::vector<float>(2000, 20.0F), .height_mm = 200.0};
    const auto picture = [&](const pot::Pot& pot) {
        EXPECT_TRUE((*view)->draw({.tool = {.position_mm = {90.0, 100.0, 0.0}}, .pot = &pot}));
        return (*view)->read_back().value().rgba;
    };
    // Where the shade hardly changes it is kept; drawing both pots removes earlier values.
    for (const pot::Pot* shown : {&lump, &thin})
        static_cast<void>(picture(*shown));
    const auto first = picture(lump);
    EXPECT_NE(picture(thin), first);
    EXPECT_EQ(picture(lump), first) << "something of the frame between was left over";
}

TEST(LiveView, ReportsAMissingDisplay) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const auto view = LiveView::open({});
    ASSERT_FALSE(view);
    EXPECT_EQ(view.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(view.error().message.find("display"), std::string::npos);
    EXPECT_EQ(view.error().message.find('\n'), std::string::npos);
}

TEST(Still, RefusesSizesThatNoPictureHas) {
    const pot::Pot pot{.outer_mm = std::vector<float>(100, 60.0F), .height_mm = 200.0};
    for (const auto& [width, height] : {std::pair{0, 720}, {1280, 15}, {8193, 720}, {-5, -5}}) {
        const auto image = render_still({.pot = &pot}, width, height);
        ASSERT_FALSE(image);
        EXPECT_EQ(image.error().kind, ErrorKind::kBadInput);
    }
}

}  // namespace
}  // namespace onggi::wheel
