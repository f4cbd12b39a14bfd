#include "game/wheel/section_labels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "game/clay/studio/studio_clay.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {
namespace {

// The clay's own columns as the picture reads them.
pot::Pot pot_of(const clay::StudioClay& clay) {
    pot::Pot pot{.height_mm = clay.height_mm(), .floor_mm = clay.floor_mm()};
    for (int i = 0; i < clay.ring_count(); ++i) {
        const auto ring = static_cast<std::size_t>(i);
        pot.outer_mm.push_back(static_cast<float>(clay.outer_mm()[ring]));
        pot.inner_mm.push_back(static_cast<float>(clay.inner_mm()[ring]));
        pot.top_mm.push_back(
            static_cast<float>(clay.centre_height_mm(i) + 0.5 * clay.rings().height_mm[ring]));
    }
    return pot;
}

// A wall of 110 mm on a floor of 12, thinner and thinner to 4.5 mm at the rim, with a belly and a neck.
clay::StudioClay jar() {
    clay::StudioClay clay;
    clay.set_wall(45.0, 8.0, 12.0, 122.0, 1000);
    std::vector<double> outer(clay.outer_mm().begin(), clay.outer_mm().end());
    std::vector<double> inner(clay.inner_mm().begin(), clay.inner_mm().end());
    for (std::size_t i = 0; i < outer.size(); ++i) {
        if (!(inner[i] > 0.0)) continue;
        const double fraction = (clay.centre_height_mm(static_cast<int>(i)) - 12.0) / 110.0;
        const double bulge = fraction < 0.5 ? fraction * (0.5 - fraction) * 16.0 * 20.0
                                            : -(fraction - 0.5) * (1.0 - fraction) * 16.0 * 12.0;
        outer[i] = 45.0 + bulge;
        inner[i] = outer[i] - (8.0 - 3.5 * fraction);
    }
    clay.set_profile(outer, inner);
    return clay;
}

std::vector<std::string> written(const ui::Sketch& sketch) {
    std::vector<std::string> words;
    for (const ui::SketchItem& item : sketch.items) {
        if (const auto* writing = std::get_if<ui::Writing>(&item)) words.push_back(writing->text.words);
    }
    return words;
}

std::vector<ui::Rect> tags(const ui::Sketch& sketch) {
    std::vector<ui::Rect> boxes;
    for (const ui::SketchItem& item : sketch.items) {
        if (const auto* box = std::get_if<ui::Box>(&item)) boxes.push_back(box->rect);
    }
    return boxes;
}

ui::Sketch labels_of(const pot::Pot& pot, int width, int height) {
    ui::Painter painter;
    WheelScene scene;
    return section_labels(pot, {1.0, 0.0}, scene.camera_now(width, height), width, height, painter);
}

TEST(SectionLabels, AreTheThicknessOfTheClayWhereTheyPoint) {
    const clay::StudioClay clay = jar();
    const pot::Pot shape = pot_of(clay);
    const std::vector<SectionMeasure> measures = section_measures(shape);
    ASSERT_GE(measures.size(), 5U);
    std::vector<std::string> expected;
    for (const SectionMeasure& measure : measures) {
        const double of_clay =
            measure.of_floor ? clay.floor_mm() : clay::wall_thickness_mm(clay.rings(), measure.height_mm);
        EXPECT_NEAR(measure.thickness_mm, of_clay, 1e-5) << measure.height_mm;
        expected.push_back(fmt::format("{:.1f} mm", of_clay));
    }
    EXPECT_EQ(written(labels_of(shape, 640, 480)), expected);
    EXPECT_GT(std::stod(expected.front()), 4.0);
    EXPECT_LT(std::stod(expected.front()), 5.0) << "below the rim";
}

TEST(SectionLabels, MeasureRimBellyNeckFootAndFloor) {
    const pot::Pot shape = pot_of(jar());
    const std::vector<SectionMeasure> measures = section_measures(shape);
    const auto measured_near = [&](double y_mm) {
        return std::any_of(measures.begin(), measures.end(), [&](const SectionMeasure& measure) {
            return !measure.of_floor && std::abs(measure.height_mm - y_mm) < 4.0;
        });
    };
    for (const double y_mm : {119.0, 12.0 + 0.75 * 110.0, 12.0 + 0.25 * 110.0, 17.0})
        EXPECT_TRUE(measured_near(y_mm)) << y_mm;
    EXPECT_TRUE(measures.back().of_floor);
    EXPECT_NEAR(measures.back().thickness_mm, 12.0, 0.2);
    EXPECT_TRUE(std::is_sorted(measures.begin(), measures.end(),
                               [](const auto& a, const auto& b) { return a.height_mm > b.height_mm; }));
}

TEST(SectionLabels, FindTheThinnestPlace) {
    clay::StudioClay clay;
    clay.set_wall(45.0, 8.0, 12.0, 120.0, 1000);
    std::vector<double> outer(clay.outer_mm().begin(), clay.outer_mm().end());
    const std::vector<double> inner(clay.inner_mm().begin(), clay.inner_mm().end());
    for (std::size_t i = 0; i < outer.size(); ++i) {
        if (std::abs(clay.centre_height_mm(static_cast<int>(i)) - 80.0) < 0.5) outer[i] -= 5.0;
    }
    clay.set_profile(outer, inner);
    const std::vector<std::string> words = written(labels_of(pot_of(clay), 640, 480));
    EXPECT_NE(std::find(words.begin(), words.end(), "3.0 mm"), words.end());
}

TEST(SectionLabels, StandApartInsideThePictureAtEverySize) {
    clay::StudioClay background;
    background.set_wall(120.0, 7.0, 9.0, 30.0, 400);
    for (const clay::StudioClay& clay : {jar(), background}) {
        const pot::Pot shape = pot_of(clay);
        for (const auto& [width, height] :
             {std::array{480, 360}, std::array{640, 480}, std::array{405, 720}, std::array{1920, 1080}}) {
            const std::vector<ui::Rect> boxes = tags(labels_of(shape, width, height));
            ASSERT_GE(boxes.size(), 3U);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                EXPECT_GE(boxes[i].x, 0.0F);
                EXPECT_GE(boxes[i].y, 0.0F);
                EXPECT_LE(boxes[i].right(), static_cast<float>(width));
                EXPECT_LE(boxes[i].bottom(), static_cast<float>(height));
                for (std::size_t j = 0; j < i; ++j) {
                    const ui::Rect both = ui::overlap(boxes[i], boxes[j]);
                    EXPECT_EQ(both.width * both.height, 0.0F) << width << "x" << height;
                }
            }
        }
    }
}

TEST(SectionLabels, AreNotDrawnOnSolidClayOrWhereTheyAreIllegible) {
    EXPECT_TRUE(
        labels_of({.outer_mm = std::vector<float>(200, 60.0F), .height_mm = 200.0}, 640, 480).items.empty());
    EXPECT_TRUE(labels_of(pot_of(clay::StudioClay()), 640, 480).items.empty());
    EXPECT_TRUE(labels_of(pot_of(jar()), 64, 48).items.empty());
}

TEST(SectionLabels, AreLaidOverThePictureAndHideNoMoreThanTheyCover) {
    asset::Image picture{.width = 2, .height = 1, .rgba = {10, 20, 30, 255, 10, 20, 30, 255}};
    lay_over(picture, {.width = 2, .height = 1, .rgba = {0, 0, 0, 0, 100, 0, 50, 128}});
    EXPECT_EQ(picture.rgba, (std::vector<std::uint8_t>{10, 20, 30, 255, 105, 10, 65, 255}));
}

}  // namespace
}  // namespace onggi::wheel
