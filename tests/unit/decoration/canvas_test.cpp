#include "game/decoration/canvas.h"

#include <gtest/gtest.h>

#include "tests/unit/decoration/sample_walls.h"

namespace onggi::decoration {
namespace {

Canvas canvas_of(const Strokes& strokes) {
    auto canvas = Canvas::of(sample_wall(), strokes);
    EXPECT_TRUE(canvas) << canvas.error().message;
    return std::move(canvas).value();
}

// The band of a column that a pigment covers by at least half: its centre, mm above the foot, and its width
// along the wall.
struct Band {
    double middle_mm = 0.0;
    double width_mm = 0.0;
    int rows = 0;
};
Band band_in(const Canvas& canvas, int column, Pigment pigment) {
    Band band;
    int first = -1;
    int last = -1;
    for (int row = 0; row < kRows; ++row) {
        const Texel& texel = canvas.texture().at(column, row);
        if (texel.pigment != pigment || texel.amount < 100) continue;
        if (first < 0) first = row;
        last = row;
        ++band.rows;
    }
    const Wall& wall = canvas.wall();
    if (first < 0) return band;
    band.middle_mm = 0.5 * (first + last + 1) / kRows * wall.height_mm;
    band.width_mm =
        wall.along_mm[static_cast<std::size_t>(last)] - wall.along_mm[static_cast<std::size_t>(first)];
    return band;
}

Stroke band_at(Technique technique, double height_mm, std::uint16_t width) {
    Stroke stroke{.technique = technique, .width = width};
    for (int i = 0; i <= 64; ++i)
        stroke.points.push_back(point(i / 64.0, height_mm));
    return stroke;
}

TEST(Canvas, AStrokeThatGrowsComesToTheBytesOfOneLaidAtOnce) {
    std::mt19937 random(7);
    Canvas grown(sample_wall());
    Strokes all;
    for (int i = 0; i < 40; ++i) {
        const Stroke stroke = random_stroke(random);
        all.push_back(stroke);
        if (stroke.technique == Technique::kMotif || stroke.technique == Technique::kClear) {
            ASSERT_TRUE(grown.begin(stroke));
            continue;
        }
        Stroke begun = stroke;
        begun.points.clear();
        ASSERT_TRUE(grown.begin(begun));
        for (const StrokePoint& next : stroke.points)
            ASSERT_TRUE(grown.add(next));
    }
    EXPECT_EQ(grown.strokes(), all);
    EXPECT_EQ(grown.texture().hash(), canvas_of(all).texture().hash());
}

// For any compiler, optimisation and vector width.
TEST(Canvas, TheSameStrokesGiveTheSameBytesEverywhere) {
    std::mt19937 random(24);
    Strokes all;
    for (int i = 0; i < 30; ++i)
        all.push_back(random_stroke(random));
    EXPECT_EQ(canvas_of(all).texture().hash(), 3991257873048509042ULL);
}

TEST(Canvas, UndoingFiveHundredStrokesGoesBackOverTheSameBytesToTheBlankWall) {
    std::mt19937 random(2026);
    Canvas canvas(sample_wall());
    std::vector<std::uint64_t> hashes{canvas.texture().hash()};
    for (int i = 0; i < 500; ++i) {
        ASSERT_TRUE(canvas.begin(random_stroke(random)));
        hashes.push_back(canvas.texture().hash());
    }
    EXPECT_NE(hashes.back(), hashes.front());
    while (!canvas.is_plain()) {
        ASSERT_EQ(canvas.texture().hash(), hashes[canvas.strokes().size()]) << canvas.strokes().size();
        ASSERT_TRUE(canvas.undo());
    }
    EXPECT_EQ(canvas.texture(), Texture());
    EXPECT_FALSE(canvas.undo());
}

TEST(Canvas, AStrokeAfterAnUndoIsDrawnOnTheRemainingStrokes) {
    const Stroke first = band_at(Technique::kIron, 60, 500);
    const Stroke second = band_at(Technique::kCobalt, 62, 500);
    const Stroke third = band_at(Technique::kFinger, 64, 2400);
    Canvas canvas = canvas_of({first, second});
    ASSERT_TRUE(canvas.undo());
    EXPECT_FALSE(canvas.add(point(0.1, 60)));  // that stroke is over
    ASSERT_TRUE(canvas.begin(third));
    EXPECT_EQ(canvas.texture(), canvas_of({first, third}).texture());
}

TEST(Canvas, ABandLiesWhereItWasDrawnAllRoundAndAcrossTheSeam) {
    const Canvas canvas = canvas_of({band_at(Technique::kIron, 90, 600)});
    for (int column = 0; column < kColumns; ++column) {
        const Band band = band_in(canvas, column, Pigment::kIron);
        ASSERT_NEAR(band.middle_mm, 90.0, 0.5) << column;
        ASSERT_NEAR(band.width_mm, 6.0, 1.0) << column;
    }
}

TEST(Canvas, ABrushIsAsWideOnTheShoulderAsOnTheBelly) {
    const Canvas canvas = canvas_of({band_at(Technique::kInlay, 148, 400)});
    EXPECT_NEAR(band_in(canvas, 300, Pigment::kWhiteSlip).width_mm, 4.0, 0.8);
    const int rows = band_in(canvas, 300, Pigment::kWhiteSlip).rows;
    EXPECT_LT(static_cast<float>(rows) * sample_wall().height_mm / kRows, 3.9F);
}

TEST(Canvas, FootAndRimStayBlank) {
    std::mt19937 random(3);
    Canvas canvas(sample_wall());
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(canvas.begin(random_stroke(random)));
    const int margin = static_cast<int>(kMarginMm / 160.0F * kRows);
    for (int column = 0; column < kColumns; ++column) {
        for (int row = 0; row < margin; ++row) {
            ASSERT_EQ(canvas.texture().at(column, row), Texel());
            ASSERT_EQ(canvas.texture().at(column, kRows - 1 - row), Texel());
        }
    }
}

TEST(Canvas, FingersGoThroughTheCoatThatIsLaidForThem) {
    const Canvas canvas = canvas_of({band_at(Technique::kFinger, 90, 2400)});
    const int row = row_at(90.0F / 160.0F);
    for (int column = 0; column < kColumns; column += 50) {
        EXPECT_EQ(canvas.texture().at(column, row).coat, Texel::kWiped);
        EXPECT_EQ(canvas.texture().at(column, row_at(94.4F / 160.0F)).coat, 255) << "between two fingers";
        EXPECT_LT(canvas.texture().at(column, row).relief, Texel::kLevel);
        EXPECT_EQ(canvas.texture().at(column, row_at(0.4F)).coat, 255);
        EXPECT_EQ(canvas.texture().at(column, row_at(0.05F)).coat, 0);
    }
}

TEST(Canvas, TheGrainOfABrushClosesBehindThePot) {
    Strokes bands;
    for (int height = 10; height < 150; height += 10)
        bands.push_back(band_at(Technique::kBrushedSlip, height, 2000));
    const Canvas canvas = canvas_of(bands);
    const auto jump = [&](int column) {
        double sum = 0.0;
        for (int row = 40; row < kRows - 40; ++row)
            sum += std::abs(canvas.texture().at(column, row).amount -
                            canvas.texture().at((column + 1) % kColumns, row).amount);
        return sum;
    };
    double most = 0.0;
    for (int column = 0; column < kColumns - 1; ++column)
        most = std::max(most, jump(column));
    EXPECT_LE(jump(kColumns - 1), most);
}

TEST(Canvas, AMotifAllRoundStandsAsOftenAsItSaysAndIsUpright) {
    const Stroke cranes{.technique = Technique::kMotif,
                        .motif = Motif::kCrane,
                        .repeats = 5,
                        .width = 4800,
                        .points = {point(0.13, 90)}};
    const Canvas canvas = canvas_of({cranes});
    const int step = kColumns / 5;
    int painted = 0;
    int alike = 0;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < step; ++column) {
            const bool is_here = canvas.texture().at(column, row).amount > 127;
            const bool is_there = canvas.texture().at(column + step, row).amount > 127;
            painted += is_here ? 1 : 0;
            alike += is_here && is_there ? 1 : 0;
        }
    }
    EXPECT_GT(painted, 2000);
    EXPECT_GT(alike, painted * 9 / 10);
}

TEST(Canvas, ReportsTheChangedPartOfTheTexture) {
    Canvas canvas(sample_wall());
    EXPECT_EQ(canvas.take_changed().row_count, kRows);
    EXPECT_TRUE(canvas.take_changed().empty());
    Stroke stroke{.technique = Technique::kIron, .width = 400, .points = {point(0.995, 80)}};
    ASSERT_TRUE(canvas.begin(stroke));
    static_cast<void>(canvas.take_changed());
    const Texture before = canvas.texture();
    ASSERT_TRUE(canvas.add(point(0.01, 84)));
    const TextureRect changed = canvas.take_changed();
    EXPECT_LT(changed.column_count, 80);
    EXPECT_LT(changed.row_count, 60);
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            if (before.at(column, row) == canvas.texture().at(column, row)) continue;
            const int off = (column - changed.column) & (kColumns - 1);
            ASSERT_LT(off, changed.column_count);
            ASSERT_GE(row, changed.row);
            ASSERT_LT(row, changed.row + changed.row_count);
        }
    }
}

TEST(Canvas, RejectsStrokesThatLieAboveThePot) {
    Canvas canvas(sample_wall());
    Stroke stroke{.technique = Technique::kIron, .points = {point(0.2, 161)}};
    EXPECT_EQ(canvas.begin(stroke).error().message, "stroke 1: expected a height of 0 to 160 mm, found 161");
    EXPECT_TRUE(canvas.is_plain());
    stroke.points = {point(0.2, 160)};
    ASSERT_TRUE(canvas.begin(stroke));
    EXPECT_FALSE(canvas.add(point(0.2, 170)));
}

TEST(Canvas, RejectsMoreStrokesAndPointsThanMayBeRecorded) {
    Canvas canvas(sample_wall());
    Stroke dot{.technique = Technique::kIron, .width = 100, .points = {point(0.2, 40)}};
    for (std::size_t i = 0; i < kMostStrokes; ++i)
        ASSERT_TRUE(canvas.begin(dot));
    const auto more = canvas.begin(dot);
    ASSERT_FALSE(more);
    EXPECT_EQ(more.error().message, "decoration: expected at most 512 strokes, found more");
    EXPECT_EQ(canvas.strokes().size(), kMostStrokes);
    Canvas other(sample_wall());
    ASSERT_TRUE(other.begin(dot));
    for (std::size_t i = 1; i < kMostPointsOfStroke; ++i)
        ASSERT_TRUE(other.add(dot.points[0]));
    EXPECT_FALSE(other.add(dot.points[0]));
}

}  // namespace
}  // namespace onggi::decoration
