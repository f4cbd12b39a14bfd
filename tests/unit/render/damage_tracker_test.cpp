#include "engine/render/cpu/host_frame.h"

#include <gtest/gtest.h>

#include <initializer_list>

#include "engine/render/shapes/tiles.h"

namespace onggi::render {
namespace {

constexpr std::size_t kTiles = 4;
using Tiles = std::vector<std::uint8_t>;

// A target that is drawn into frame by frame.
class HeldPictureTiles : public testing::Test {
  protected:
    void frame(const Tiles& moving = {}, const std::vector<std::uint64_t>& overlay = {}) {
        target_.take_work({.picture = picture_, .moving = moving, .overlay = overlay}, work_);
    }
    std::vector<std::uint64_t> picture_{11, 12, 13, 14};
    DamageTracker target_;
    TileWork work_;
};

TEST_F(HeldPictureTiles, AreCopiedOnlyWhereTheTargetShowsSomethingElse) {
    frame();
    EXPECT_EQ(work_.bare, Tiles(kTiles, 1));
    frame();
    EXPECT_EQ(work_.bare, Tiles(kTiles, 0));
    frame({0, 1, 0, 0});
    EXPECT_EQ(work_.bare, Tiles(kTiles, 0));
    frame();
    EXPECT_EQ(work_.bare, (Tiles{0, 1, 0, 0}));
    picture_[3] = 15;
    frame();
    EXPECT_EQ(work_.bare, (Tiles{0, 0, 0, 1}));
    target_.forget();
    frame();
    EXPECT_EQ(work_.bare, Tiles(kTiles, 1));
}

TEST_F(HeldPictureTiles, AreNotCopiedWhereSomethingMoves) {
    frame({0, 1, 1, 0});
    EXPECT_EQ(work_.bare, (Tiles{1, 0, 0, 1}));
    EXPECT_EQ(work_.moves, (Tiles{0, 1, 1, 0}));
    frame({0, 1, 1, 0}, {0, 7, 7, 0});
    EXPECT_EQ(work_.bare, Tiles(kTiles, 0));
    EXPECT_EQ(work_.moves_under, (Tiles{0, 1, 1, 0}));
    frame();
    EXPECT_EQ(work_.bare, (Tiles{0, 1, 1, 0}));
}

TEST_F(HeldPictureTiles, KeepAnUnchangedOverlay) {
    frame();
    frame({}, {0, 7, 8, 0});
    EXPECT_EQ(work_.laid_over, (Tiles{0, 1, 1, 0}));
    EXPECT_EQ(work_.bare, Tiles(kTiles, 0));
    frame({}, {0, 7, 8, 0});
    EXPECT_EQ(work_.laid_over, Tiles(kTiles, 0));
    // Another in its place, and then none.
    frame({}, {0, 7, 9, 0});
    EXPECT_EQ(work_.laid_over, (Tiles{0, 0, 1, 0}));
    frame();
    EXPECT_EQ(work_.bare, (Tiles{0, 1, 1, 0}));
    EXPECT_EQ(work_.laid_over, Tiles(kTiles, 0));
}

TEST_F(HeldPictureTiles, ComposeTheOverlayOverMovingTilesAndRestoreThemAfterwards) {
    frame({}, {0, 7, 8, 0});
    frame({0, 1, 0, 1}, {0, 7, 8, 0});
    EXPECT_EQ(work_.bare, Tiles(kTiles, 0));
    EXPECT_EQ(work_.laid_over, Tiles(kTiles, 0));
    EXPECT_EQ(work_.moves_under, (Tiles{0, 1, 0, 0}));
    EXPECT_EQ(work_.moves, (Tiles{0, 0, 0, 1}));
    frame({0, 1, 0, 1}, {0, 7, 8, 0});
    EXPECT_EQ(work_.moves_under, (Tiles{0, 1, 0, 0})) << "what moves is another in every frame";
    frame({}, {0, 7, 8, 0});
    EXPECT_EQ(work_.bare, (Tiles{0, 0, 0, 1}));
    EXPECT_EQ(work_.laid_over, (Tiles{0, 1, 0, 0}));
    EXPECT_EQ(work_.moves_under, Tiles(kTiles, 0));
}

TEST_F(HeldPictureTiles, OfOtherPicturesAreNeverTakenForThoseTheTargetHolds) {
    frame();
    picture_ = {21, 22, 23, 24};
    frame();
    EXPECT_EQ(work_.bare, Tiles(kTiles, 1));
    picture_.push_back(25);
    frame();
    EXPECT_EQ(work_.bare, Tiles(kTiles + 1, 1)) << "of another size";
}

vk::TargetImage image(std::uintptr_t handle, std::uint64_t frames_before) {
    vk::TargetImage target;
    target.image = reinterpret_cast<VkImage>(handle);
    target.frames_before = frames_before;
    return target;
}

TEST(HeldTargets, KeepEachTargetApartAndForgetOneThatAnotherHasDrawnInto) {
    const std::vector<std::uint64_t> picture{5};
    HeldTargets targets;
    TileWork work;
    const auto is_copied = [&](std::uintptr_t handle, std::uint64_t frames_before) {
        targets.held_by(image(handle, frames_before)).take_work({.picture = picture}, work);
        return work.bare[0] != 0;
    };
    EXPECT_TRUE(is_copied(1, 0));
    EXPECT_TRUE(is_copied(2, 0));
    EXPECT_FALSE(is_copied(1, 1));
    EXPECT_FALSE(is_copied(2, 1));
    EXPECT_TRUE(is_copied(1, 3)) << "another's frame came between";
    EXPECT_FALSE(is_copied(1, 4));
    EXPECT_TRUE(is_copied(1, 0)) << "a new image with the old one's handle";
    EXPECT_TRUE(is_copied(1, 0)) << "the same frame, built again";
    for (std::uintptr_t other = 10; other < 40; ++other)
        EXPECT_TRUE(is_copied(other, 0));
    EXPECT_TRUE(is_copied(2, 2)) << "too long ago";
}

}  // namespace
}  // namespace onggi::render
