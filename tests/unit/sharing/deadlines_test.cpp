#include "game/app/sharing/share_server.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::app {
namespace {

std::vector<int> cut_at(Deadlines& deadlines, double now_s) {
    std::vector<int> cut;
    deadlines.sweep(now_s, [&](int socket) { cut.push_back(socket); });
    return cut;
}

Deadlines::Handle add(Deadlines& deadlines, int socket, double now_s, std::uint8_t address = 1,
                      std::vector<int>* cut = nullptr) {
    return deadlines.add(socket, sharing::key_of_ipv4({10, 0, 0, address}), now_s, [&](int other) {
        if (cut != nullptr) cut->push_back(other);
    });
}

TEST(Deadlines, CloseAConnectionWithoutARequest) {
    Deadlines deadlines({.head_s = 10.0, .answer_s = 20.0, .bytes_per_s = 1000.0});
    static_cast<void>(add(deadlines, 3, 0.0));
    const auto other = add(deadlines, 4, 5.0);
    EXPECT_TRUE(cut_at(deadlines, 9.9).empty());
    EXPECT_EQ(cut_at(deadlines, 10.0), std::vector<int>{3});
    EXPECT_TRUE(cut_at(deadlines, 11.0).empty()) << "once";
    deadlines.remove(other);
    EXPECT_TRUE(cut_at(deadlines, 100.0).empty());
    EXPECT_EQ(deadlines.size(), 1U);
}

TEST(Deadlines, GiveARefusedClientTwoSecondsToClose) {
    Deadlines deadlines;
    const auto refused = add(deadlines, 3, 0.0);
    deadlines.refuses(refused, 5.0);
    EXPECT_TRUE(cut_at(deadlines, 6.9).empty());
    EXPECT_EQ(cut_at(deadlines, 7.0), std::vector<int>{3});
}

TEST(Deadlines, GiveAnAnswerTheTimeThatItsSizeTakes) {
    Deadlines deadlines({.head_s = 10.0, .answer_s = 20.0, .bytes_per_s = 1000.0});
    const auto slow = add(deadlines, 3, 0.0);
    deadlines.answers(slow, 1.0, 5000);
    EXPECT_TRUE(cut_at(deadlines, 25.9).empty());
    deadlines.has_answered(slow, 25.9);
    EXPECT_TRUE(cut_at(deadlines, 35.8).empty()) << "it may ask again";
    deadlines.answers(slow, 35.8, 0);
    EXPECT_EQ(cut_at(deadlines, 55.8), std::vector<int>{3});
}

TEST(Deadlines, AreShorterInACrowd) {
    Deadlines deadlines({.head_s = 10.0, .crowded_head_s = 1.0, .crowd = 3});
    static_cast<void>(add(deadlines, 3, 0.0));
    const auto served = add(deadlines, 4, 0.0);
    deadlines.answers(served, 0.5, 1000);
    EXPECT_TRUE(cut_at(deadlines, 5.0).empty());
    static_cast<void>(add(deadlines, 5, 5.0));
    EXPECT_EQ(cut_at(deadlines, 5.5), std::vector<int>{3}) << "the silent one is in the way of others";
    EXPECT_EQ(cut_at(deadlines, 6.0), std::vector<int>{5}) << "whose answer is on its way is not";
}

TEST(Deadlines, GiveTheOldestOpenHeadsPlaceToANewcomer) {
    Deadlines deadlines({.most_an_address = 3, .most = 5});
    std::vector<int> cut;
    const auto asked = add(deadlines, 3, 0.0, 1, &cut);
    deadlines.answers(asked, 0.1, 1000);
    for (int socket = 4; socket <= 6; ++socket)
        static_cast<void>(add(deadlines, socket, 0.1 * socket, 1, &cut));
    EXPECT_TRUE(cut.empty()) << "whose answer is on its way does not count";
    static_cast<void>(add(deadlines, 7, 0.7, 2, &cut));
    EXPECT_TRUE(cut.empty()) << "another address";
    static_cast<void>(add(deadlines, 8, 0.8, 1, &cut));
    EXPECT_EQ(cut, std::vector<int>{4});
    static_cast<void>(add(deadlines, 9, 0.9, 2, &cut));
    EXPECT_EQ(cut, std::vector<int>{4});
    static_cast<void>(add(deadlines, 10, 1.0, 3, &cut));
    EXPECT_EQ(cut, (std::vector<int>{4, 5})) << "of all addresses";
}

TEST(Deadlines, GiveTheOldestSlowReadersPlaceToANewcomer) {
    Deadlines deadlines({.most_an_address = 3, .slow_answer_s = 5.0});
    std::vector<int> cut;
    for (int socket = 3; socket <= 5; ++socket)
        deadlines.answers(add(deadlines, socket, 0.0, 1, &cut), 0.1 * socket, 1'000'000);
    static_cast<void>(add(deadlines, 6, 5.2, 1, &cut));
    EXPECT_TRUE(cut.empty()) << "not slow yet";
    static_cast<void>(add(deadlines, 7, 5.4, 2, &cut));
    EXPECT_TRUE(cut.empty()) << "another address";
    static_cast<void>(add(deadlines, 8, 5.5, 1, &cut));
    EXPECT_EQ(cut, std::vector<int>{3});
    static_cast<void>(add(deadlines, 9, 6.0, 1, &cut));
    EXPECT_EQ(cut, std::vector<int>{3}) << "there is room now";
    deadlines.end_a_slow_answer(5.3, [&](int socket) { cut.push_back(socket); });
    EXPECT_EQ(cut, std::vector<int>{3}) << "none is slow";
    deadlines.end_a_slow_answer(6.0, [&](int socket) { cut.push_back(socket); });
    EXPECT_EQ(cut, (std::vector<int>{3, 4}));
}

}  // namespace
}  // namespace onggi::app
