// The shelf's table: its order, and a refusal that names the line.
#include "game/heritage/shelf.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/finish/glaze.h"
#include "tests/support/refusal.h"
#include "tests/unit/heritage/bundled.h"

namespace onggi::heritage {
namespace {

std::vector<Target> cup_and_jar() {
    Target cup;
    cup.id = "cup";
    Target jar;
    jar.id = "jar";
    return {cup, jar};
}

Result<std::vector<ShelfRow>> shelf_of(std::string_view rows) {
    return parse_shelf(fmt::format("{}\n{}", kShelfHeader, rows), "shelf.csv", cup_and_jar());
}

constexpr std::string_view kCup = "cup,compared,pot.cup,,Our own,iron\n";

TEST(Shelf, KeepsTheOrderOfItsTable) {
    const auto shelf = shelf_of(fmt::format("jar,shelf,pot.moon,mus.nmk,date.x,ido\n{}", kCup));
    ASSERT_TRUE(shelf) << shelf.error().message;
    ASSERT_EQ(shelf->size(), 2U);
    const ShelfRow& jar = shelf->front();
    EXPECT_EQ(jar.id, "jar");
    EXPECT_TRUE(jar.is_on_shelf);
    EXPECT_EQ(jar.museum, "mus.nmk");
    EXPECT_EQ(jar.glaze, finish::kIdoGlaze);
    const ShelfRow* const cup = find_row(*shelf, "cup");
    ASSERT_NE(cup, nullptr);
    EXPECT_FALSE(cup->is_on_shelf);
    EXPECT_EQ(cup->name, "pot.cup");
    EXPECT_EQ(cup->date, "Our own");
    EXPECT_EQ(cup->glaze, static_cast<int>(finish::Glaze::kIron));
    EXPECT_EQ(find_row(*shelf, "vase"), nullptr);
}

TEST(Shelf, RejectsWrongRowsByTheirLine) {
    const auto refusal = [](std::string_view rows) { return test::refusal(shelf_of(rows)); };
    EXPECT_EQ(refusal("vase,shelf,A,,then,iron\n"),
              "shelf.csv:2: expected a pot of the table of targets, found 'vase'");
    EXPECT_EQ(refusal(fmt::format("{0}{0}", kCup)), "shelf.csv:3: expected each pot once, found 'cup' again");
    EXPECT_EQ(refusal("cup,hidden,A,,then,iron\n"),
              "shelf.csv:2: shown: expected shelf or compared, found 'hidden'");
    EXPECT_EQ(refusal("cup,shelf,,,then,iron\n"), "shelf.csv:2: name and date: expected both");
    EXPECT_EQ(refusal("cup,shelf,A,,,iron\n"), "shelf.csv:2: name and date: expected both");
    EXPECT_EQ(refusal("cup,shelf,A,,then,3\n"),
              "shelf.csv:2: glaze: expected one of celadon, porcelain, buncheong, iron, ash, bare, ido; "
              "found '3'");
    EXPECT_EQ(refusal("cup,shelf,A,,then,iron,more\n"), "shelf.csv:2: expected 6 columns, found 7");
}

TEST(Shelf, HasARowForEveryPotThatIsShipped) {
    const auto targets = bundled();
    const auto shelf = load_shelf(test::in_checkout("assets/heritage"), targets);
    ASSERT_TRUE(shelf) << shelf.error().message;
    for (const Target& target : targets)
        EXPECT_NE(find_row(*shelf, target.id), nullptr) << target.id;
}

}  // namespace
}  // namespace onggi::heritage
