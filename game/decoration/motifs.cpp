#include "game/decoration/motifs.h"

#include <array>

namespace onggi::decoration {
namespace {

using Points = std::vector<MotifPoint>;

// Flying to the left, as on Goryeo celadon: white, with black beak, legs and feather tips.
std::vector<MotifLine> crane() {
    constexpr Ink kWhite = Ink::kWhiteInlay;
    constexpr Ink kBlack = Ink::kBlackInlay;
    return {{kWhite, {{-38, 17, 2.0F}, {-33, 15, 2.2F}, {-29, 7, 2.2F}, {-22, -3, 3.2F}, {-12, -9, 5.5F}}},
            {kWhite, {{-13, -9, 5.5F}, {0, -12, 7.0F}, {12, -11, 6.5F}, {24, -13, 3.0F}}},
            {kWhite, {{-4, -8, 5.0F}, {-1, 14, 4.6F}, {2, 38, 1.6F}}},
            {kWhite, {{2, -8, 5.0F}, {8, 12, 4.4F}, {15, 31, 1.6F}}},
            {kWhite, {{7, -8, 5.0F}, {18, 6, 4.2F}, {29, 20, 1.6F}}},
            {kWhite, {{11, -9, 4.0F}, {25, 0, 3.6F}, {40, 9, 1.4F}}},
            {kBlack, {{0, 18, 0.7F}, {2, 33, 1.0F}}},
            {kBlack, {{8, 14, 0.7F}, {13, 27, 1.0F}}},
            {kBlack, {{18, 7, 0.7F}, {26, 17, 1.0F}}},
            {kBlack, {{-39, 18, 1.1F}, {-50, 20, 0.5F}}},
            {kBlack, {{-36.5F, 18.5F, 1.1F}, {-35, 19, 1.1F}}},
            {kBlack, {{20, -14, 2.6F}, {30, -16, 2.0F}, {38, -13, 0.8F}}},
            {kBlack, {{18, -16, 1.0F}, {28, -27, 0.9F}, {35, -37, 0.8F}}},
            {kBlack, {{22, -17, 1.0F}, {33, -26, 0.9F}, {41, -33, 0.8F}}}};
}

std::vector<MotifLine> cloud() {
    constexpr Ink kWhite = Ink::kWhiteInlay;
    return {{kWhite,
             {{-18, -8, 1.8F},
              {-32, -6, 1.8F},
              {-38, 6, 1.8F},
              {-30, 15, 1.8F},
              {-20, 12, 1.8F},
              {-20, 24, 1.8F},
              {-7, 31, 1.8F},
              {5, 26, 1.8F},
              {8, 16, 1.8F},
              {18, 20, 1.8F},
              {28, 13, 1.8F},
              {26, 2, 1.8F},
              {14, -2, 1.8F}}},
            {kWhite, {{-26, 4, 1.4F}, {-22, 9, 1.4F}, {-16, 6, 1.4F}, {-18, 0, 1.2F}}},
            {kWhite, {{-8, 16, 1.4F}, {-3, 21, 1.4F}, {3, 17, 1.4F}, {0, 11, 1.2F}}},
            {kWhite, {{14, 8, 1.4F}, {19, 12, 1.4F}, {23, 8, 1.2F}}},
            {kWhite, {{-20, -9, 2.0F}, {-2, -20, 2.2F}, {20, -22, 1.8F}, {46, -12, 0.8F}}},
            {kWhite, {{-6, -28, 1.6F}, {12, -32, 1.4F}, {30, -28, 0.7F}}}};
}

// Twelve petals about a middle, within a black ring.
std::vector<MotifLine> chrysanthemum() {
    // The twelve directions of a clock, without a sine call: 1/2 and sqrt(3)/2.
    constexpr float kFar = 0.8660254F;
    constexpr std::array<vec2, 12> kWays{vec2{0, 1},     {0.5F, kFar},  {kFar, 0.5F},  {1, 0},
                                         {kFar, -0.5F},  {0.5F, -kFar}, {0, -1},       {-0.5F, -kFar},
                                         {-kFar, -0.5F}, {-1, 0},       {-kFar, 0.5F}, {-0.5F, kFar}};
    std::vector<MotifLine> lines;
    MotifLine ring{Ink::kBlackInlay, {}};
    for (std::size_t i = 0; i <= kWays.size() + 1; ++i) {
        const vec2 way = kWays[i % kWays.size()];
        ring.points.push_back({46.0F * way.x, 46.0F * way.y, 1.1F});
    }
    lines.push_back(ring);
    for (const vec2& way : kWays) {
        lines.push_back({Ink::kWhiteInlay,
                         {{13.0F * way.x, 13.0F * way.y, 1.8F},
                          {27.0F * way.x, 27.0F * way.y, 4.2F},
                          {36.0F * way.x, 36.0F * way.y, 2.6F}}});
    }
    lines.push_back({Ink::kBlackInlay, {{-3, 0, 5.2F}, {3, 0, 5.2F}}});
    lines.push_back({Ink::kWhiteInlay, {{-2, 0, 2.4F}, {2, 0, 2.4F}}});
    return lines;
}

// Swimming to the left, in quick brush strokes, as on buncheong from Mount Gyeryong.
std::vector<MotifLine> fish() {
    constexpr Ink kIron = Ink::kIron;
    return {{kIron, {{-42, 0, 1.2F}, {-26, 13, 2.2F}, {-4, 18, 2.4F}, {16, 11, 1.8F}, {27, 3, 1.6F}}},
            {kIron, {{-42, 0, 1.2F}, {-28, -12, 2.0F}, {-6, -17, 2.2F}, {14, -11, 1.8F}, {27, -2, 1.6F}}},
            {kIron, {{26, 2, 1.6F}, {36, 13, 2.2F}, {45, 21, 1.0F}}},
            {kIron, {{26, -1, 1.6F}, {37, -10, 2.2F}, {46, -17, 1.0F}}},
            {kIron, {{45, 20, 0.8F}, {38, 2, 1.0F}, {46, -16, 0.8F}}},
            {kIron, {{-31, 4, 1.9F}, {-29, 4, 1.9F}}},
            {kIron, {{-22, 11, 1.2F}, {-17, 0, 1.4F}, {-22, -10, 1.0F}}},
            {kIron, {{-14, 18, 1.4F}, {-5, 29, 1.8F}, {9, 27, 1.2F}, {14, 14, 1.0F}}},
            {kIron, {{-8, -17, 1.4F}, {-1, -26, 1.5F}, {7, -24, 0.8F}}},
            {kIron, {{-9, 9, 0.9F}, {-5, 1, 1.1F}, {-9, -8, 0.8F}}},
            {kIron, {{0, 10, 0.9F}, {4, 1, 1.1F}, {0, -9, 0.8F}}},
            {kIron, {{9, 8, 0.9F}, {13, 1, 1.1F}, {9, -7, 0.8F}}},
            {kIron, {{18, 5, 0.8F}, {20, 1, 1.0F}, {18, -4, 0.7F}}}};
}

// A tuft of orchid grass.
std::vector<MotifLine> grass() {
    constexpr Ink kIron = Ink::kIron;
    return {{kIron, {{-2, -48, 1.2F}, {-6, -18, 2.6F}, {-16, 14, 2.2F}, {-35, 34, 0.6F}}},
            {kIron, {{0, -48, 1.2F}, {0, -10, 2.6F}, {4, 24, 2.0F}, {14, 48, 0.5F}}},
            {kIron, {{2, -48, 1.2F}, {10, -22, 2.4F}, {26, -2, 2.0F}, {46, 4, 0.5F}}},
            {kIron, {{-3, -48, 1.0F}, {-16, -28, 2.2F}, {-32, -18, 1.6F}, {-46, -22, 0.5F}}},
            {kIron, {{1, -48, 1.0F}, {8, -12, 1.8F}, {20, 20, 1.4F}, {34, 30, 0.5F}}},
            {kIron, {{-1, -46, 0.9F}, {-7, 0, 1.3F}, {-12, 34, 0.9F}}},
            {kIron, {{-16, 40, 1.6F}, {-12, 38, 2.4F}, {-8, 42, 1.4F}}},
            {kIron, {{-14, 46, 1.2F}, {-11, 44, 1.8F}, {-10, 49, 0.8F}}}};
}

// One continuous wave of three fingers.
std::vector<MotifLine> wave() {
    return {{Ink::kWipe,
             {{-50, -12, 13},
              {-36, 4, 13},
              {-25, 12, 13},
              {-14, 4, 13},
              {0, -12, 13},
              {14, -24, 13},
              {25, -28, 13},
              {36, -24, 13},
              {50, -12, 13}}}};
}

}  // namespace

std::span<const MotifLine> lines_of(Motif motif) {
    static const std::array<std::vector<MotifLine>, kMotifCount> kAll{
        std::vector<MotifLine>{}, crane(), cloud(), chrysanthemum(), fish(), grass(), wave()};
    return kAll[static_cast<std::size_t>(motif)];
}

}  // namespace onggi::decoration
