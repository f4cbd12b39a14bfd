#include "game/heritage/card.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/places.h"
#include "tests/support/refusal.h"

namespace onggi::heritage {
namespace {

constexpr const char* kHeader =
    "id,use_en,making_en,look_en,use_ko,making_ko,look_ko,use_known_by,making_known_by,look_known_by,"
    "source\n";
constexpr const char* kBowl =
    "bowl,For rice.,Thrown.,The foot.,밥그릇,물레로,굽,record,kind,general,museum 12\n";

std::vector<Target> a_bowl() {
    Target bowl;
    bowl.id = "bowl";
    return {bowl};
}

std::string refusal_of_cards(const std::string& table) {
    return test::refusal(parse_cards(table, "cards.csv", a_bowl()));
}

TEST(Cards, TellInALanguageOrElseInEnglish) {
    const auto cards = parse_cards(std::string(kHeader) + kBowl, "cards.csv", a_bowl());
    ASSERT_TRUE(cards) << cards.error().message;
    const Card& card = cards->at("bowl");
    EXPECT_EQ(card.in("en")[0], "For rice.");
    EXPECT_EQ(card.in("ko")[2], "굽");
    EXPECT_EQ(card.in("ar")[1], "Thrown.");
    EXPECT_EQ(card.known_by[0], KnownBy::kRecord);
    EXPECT_EQ(card.known_by[1], KnownBy::kKind);
    EXPECT_EQ(card.known_by[2], KnownBy::kGeneral);
    EXPECT_EQ(card.source, "museum 12");
}

TEST(Cards, FallBackWholeWhereOneLineIsMissing) {
    const auto cards = parse_cards(std::string(kHeader) + "bowl,A,B,C,가,,다,record,record,record,s\n",
                                   "cards.csv", a_bowl());
    ASSERT_TRUE(cards);
    EXPECT_EQ(cards->at("bowl").in("ko")[0], "A") << "no card in two languages";
}

TEST(Cards, SayWhereTheyAreWrongAndHow) {
    const std::string head = kHeader;
    EXPECT_EQ(refusal_of_cards("id,source\n"), "cards.csv:1: expected a column 'use_en', found none");
    EXPECT_EQ(refusal_of_cards("id,id,source\n"), "cards.csv:1: expected each column once, found 'id' twice");
    EXPECT_EQ(refusal_of_cards(head + "vase,A,B,C,,,,record,record,record,s\n"),
              "cards.csv:2: expected a pot of the table of targets, found 'vase'");
    EXPECT_EQ(refusal_of_cards(head + kBowl + kBowl),
              "cards.csv:3: expected each pot once, found 'bowl' again");
    EXPECT_EQ(refusal_of_cards(head + "bowl,A,B,C,,,,record,record,record,\n"),
              "cards.csv:2: source: expected where it is known from, found nothing");
    EXPECT_EQ(refusal_of_cards(head + "bowl,A,,C,,,,record,record,record,s\n"),
              "cards.csv:2: making_en: expected a sentence, found nothing");
    EXPECT_EQ(refusal_of_cards(head + "bowl,A,B,C,,,,sure,record,record,s\n"),
              "cards.csv:2: use_known_by: expected record, kind or general, found 'sure'");
    EXPECT_NE(refusal_of_cards(head + "bowl,A,B\n"), "accepted");
    EXPECT_NE(refusal_of_cards(head), "accepted");
}

TEST(Cards, ExistForEveryShippedPotInEveryLanguage) {
    const std::string folder = test::in_checkout("assets/heritage");
    const auto targets = load_targets(folder);
    ASSERT_TRUE(targets) << targets.error().message;
    const auto cards = load_cards(folder, *targets);
    ASSERT_TRUE(cards) << cards.error().message;
    for (const Target& target : *targets) {
        ASSERT_TRUE(cards->contains(target.id)) << target.id;
        const Card& card = cards->find(target.id)->second;
        for (const char* language : {"ko", "ar", "ja", "zh-Hans", "de", "fr", "es"})
            EXPECT_NE(card.in(language), card.in("en")) << target.id << " in " << language;
    }
}

}  // namespace
}  // namespace onggi::heritage
