#include "game/decoration/stroke.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/refusal.h"
#include "tests/unit/decoration/sample_walls.h"

namespace onggi::decoration {
namespace {

Recorded sample() {
    std::mt19937 random(11);
    Recorded recorded{.texture_hash = 0x1234567890abcdefULL};
    for (int i = 0; i < 20; ++i)
        recorded.strokes.push_back(random_stroke(random));
    return recorded;
}

std::string refusal(std::vector<std::byte> bytes) {
    return test::refusal(recorded_from(bytes, "pot.onggi"));
}

void overwrite(std::vector<std::byte>& bytes, std::size_t at, std::uint16_t number) {
    bytes[at] = static_cast<std::byte>(number & 255U);
    bytes[at + 1] = static_cast<std::byte>(number >> 8U);
}

constexpr std::size_t kFirstStroke = 12;

TEST(Strokes, ReadBackAsTheyWereWritten) {
    const auto read = recorded_from(bytes_of(sample()), "pot.onggi");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, sample());
    EXPECT_EQ(recorded_from(bytes_of({}), "pot.onggi").value(), Recorded());
}

TEST(Strokes, PointsAreRoundedToTheRecordedFormatAndWrapped) {
    EXPECT_EQ(point(1.25, 10.0).turn, 16384);
    EXPECT_EQ(point(-0.25, 10.0).turn, 49152);
    EXPECT_EQ(point(0.9999999, 10.0).turn, 0);
    EXPECT_EQ(point(0.5, 10.0).height, 640);
}

TEST(Strokes, RejectsPointsThatAreNoNumbersOrNowhere) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    for (const double bad : {kNone, kEndless, -kEndless}) {
        EXPECT_FALSE(stroke_point(bad, 10.0));
        EXPECT_FALSE(stroke_point(0.5, bad));
        EXPECT_FALSE(stroke_point(0.5, 10.0, bad));
    }
    EXPECT_FALSE(stroke_point(0.5, -0.1));
    EXPECT_EQ(stroke_point(0.5, 2000.0).error().message,
              "stroke: expected a height of 0 to 1023.984375 mm, found 2000");
}

TEST(Strokes, RejectsBytesThatEndEarlyWhereverTheyEnd) {
    const std::vector<std::byte> whole = bytes_of(sample());
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(recorded_from(std::span(whole).first(size), "pot.onggi")) << size;
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_NE(refusal(longer).find("expected the end, found 1 bytes more"), std::string::npos);
}

TEST(Strokes, RejectsAMillionStrokesBeforeReadingAny) {
    std::vector<std::byte> bytes = bytes_of({});
    overwrite(bytes, 2, 65535);
    EXPECT_EQ(refusal(bytes), "pot.onggi: decoration byte 2: expected at most 512 strokes, found 65535");
}

TEST(Strokes, RejectsNumbersOutOfTheirBounds) {
    const Recorded one{.strokes = {{.technique = Technique::kIron, .points = {point(0.5, 20)}}}};
    const std::vector<std::byte> good = bytes_of(one);
    const auto with = [&](std::size_t at, std::uint8_t number) {
        std::vector<std::byte> bytes = good;
        bytes[at] = static_cast<std::byte>(number);
        return refusal(bytes);
    };
    EXPECT_EQ(with(0, 9), "pot.onggi: decoration byte 0: expected version 1, found 9");
    EXPECT_EQ(with(kFirstStroke, 0),
              "pot.onggi: decoration byte 12: stroke 1: expected a technique of 1 to 7, found 0");
    EXPECT_NE(with(kFirstStroke, 8), "accepted");
    EXPECT_NE(with(kFirstStroke + 1, 2), "accepted");    // slip
    EXPECT_NE(with(kFirstStroke + 2, 1), "accepted");    // a motif without the technique
    EXPECT_NE(with(kFirstStroke + 3, 2), "accepted");    // repeats
    EXPECT_NE(with(kFirstStroke + 5, 255), "accepted");  // width
    std::vector<std::byte> many = good;
    overwrite(many, kFirstStroke + 6, 5000);
    EXPECT_NE(refusal(many).find("expected at most 4096 points"), std::string::npos);
}

TEST(Strokes, RejectsMorePointsInAllThanMayBeRecorded) {
    Recorded recorded;
    Stroke stroke{.technique = Technique::kIron};
    stroke.points.assign(kMostPointsOfStroke, point(0.1, 30));
    recorded.strokes.assign(kMostPoints / kMostPointsOfStroke, stroke);
    EXPECT_TRUE(recorded_from(bytes_of(recorded), "pot.onggi"));
    recorded.strokes.push_back(stroke);
    EXPECT_NE(refusal(bytes_of(recorded)).find("65536 in all"), std::string::npos);
}

}  // namespace
}  // namespace onggi::decoration
