#include "engine/ui/atlas.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::ui {
namespace {

std::shared_ptr<const Painting> painting(int width, int height) {
    Painting made;
    made.width = width;
    made.height = height;
    made.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    return std::make_shared<const Painting>(std::move(made));
}

TEST(Atlas, KeepsAPlaceForAsLongAsItLasts) {
    Atlas atlas(256);
    const auto first = atlas.place(1, painting(50, 20));
    ASSERT_TRUE(first);
    EXPECT_EQ(atlas.place(1, painting(50, 20)), first);
    EXPECT_EQ(atlas.take_uploads().size(), 1U);
    EXPECT_TRUE(atlas.take_uploads().empty());
}

TEST(Atlas, NeverLaysTwoOverEachOther) {
    Atlas atlas(512);
    std::vector<Rect> places;
    const std::uint64_t generation = atlas.generation();
    for (std::uint64_t key = 0; key < 200; ++key) {
        const auto place =
            atlas.place(key, painting(8 + static_cast<int>(key % 23), 6 + static_cast<int>(key % 17)));
        ASSERT_TRUE(place);
        if (atlas.generation() != generation) break;
        for (const Rect& other : places) {
            const Rect shared = overlap(*place, other);
            ASSERT_EQ(shared.width * shared.height, 0.0F);
        }
        places.push_back(*place);
    }
    EXPECT_GT(places.size(), 150U);
}

TEST(Atlas, EmptiesTheOlderHalfWhenBothAreFull) {
    Atlas atlas(256);
    for (std::uint64_t key = 0; key < 5; ++key)
        ASSERT_TRUE(atlas.place(key, painting(250, 60)));
    EXPECT_EQ(atlas.generation(), 2U) << "the fifth begins the first half again";
    ASSERT_TRUE(atlas.place(2, painting(250, 60)));
    ASSERT_TRUE(atlas.place(3, painting(250, 60)));
    EXPECT_EQ(atlas.generation(), 2U) << "those of the other half are still there";
    ASSERT_TRUE(atlas.place(0, painting(250, 60)));
    EXPECT_EQ(atlas.take_uploads().size(), 4U) << "what was overwritten before it was copied is not copied";
}

TEST(Atlas, ReplacesAPaintingWhereItLies) {
    Atlas atlas(256);
    const auto first = atlas.replace(1, painting(50, 20));
    ASSERT_TRUE(first);
    static_cast<void>(atlas.take_uploads());
    const auto newer = painting(50, 20);
    EXPECT_EQ(atlas.replace(1, newer), first);
    const auto uploads = atlas.take_uploads();
    ASSERT_EQ(uploads.size(), 1U);
    EXPECT_EQ(uploads.front().painting, newer);
    EXPECT_EQ(static_cast<float>(uploads.front().x), first->x);
}

TEST(Atlas, DropsUnusedPaintings) {
    Atlas atlas(256);
    const auto first = atlas.place(1, painting(50, 20));
    const auto second = atlas.place(2, painting(30, 20));
    ASSERT_TRUE(first && second);
    static_cast<void>(atlas.take_uploads());
    atlas.begin_asking();
    EXPECT_EQ(atlas.place(2, painting(30, 20)), second);
    atlas.forget_unasked();
    const std::vector<Atlas::Upload> uploads = atlas.take_uploads();
    ASSERT_EQ(uploads.size(), 1U) << "over the unused one";
    EXPECT_EQ(static_cast<float>(uploads[0].x), first->x);
    EXPECT_EQ(static_cast<float>(uploads[0].y), first->y);
    EXPECT_EQ(uploads[0].painting->rgba, std::vector<std::uint8_t>(4, 0)) << "one clear pixel";
    EXPECT_EQ(atlas.place(2, painting(30, 20)), second);
    EXPECT_TRUE(atlas.take_uploads().empty());
    EXPECT_TRUE(atlas.place(1, painting(50, 20)));
    EXPECT_EQ(atlas.take_uploads().size(), 1U) << "added again";
}

TEST(Atlas, RefusesAPictureLargerThanAHalf) {
    Atlas atlas(256);
    EXPECT_FALSE(atlas.place(1, painting(257, 10)));
    EXPECT_FALSE(atlas.place(2, painting(10, 129)));
    EXPECT_TRUE(atlas.place(3, painting(256, 128)));
}

}  // namespace
}  // namespace onggi::ui
