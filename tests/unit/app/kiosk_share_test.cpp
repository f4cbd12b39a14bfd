#include "game/app/kiosk/keeping/kiosk_share.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/exporter/studio_export.h"
#include "game/finish/glaze.h"
#include "game/screens/pots/pot_picture.h"
#include "tests/support/studio_samples.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

screens::FiredPot jar(const KioskSettings& settings) {
    screens::FiredPot pot;
    std::vector<vec2> outside;
    for (int i = 0; i <= 40; ++i)
        outside.push_back(
            {50.0F + 20.0F * std::sin(static_cast<float>(i) * 0.08F), static_cast<float>(i) * 4.0F});
    pot.shape = pot::hollowed(outside, 5.0F, 8.0F);
    pot.height_mm = 160.0;
    pot.width_mm = 140.0;
    pot.weight_g = 900.0;
    pot.capacity_l = 1.25;
    if (!settings.exhibits->empty()) pot.relative = {settings.exhibits, &settings.exhibits->front()};
    return pot;
}

TEST(KioskShare, HandsThePotOverAsThePageWantsIt) {
    const auto settings = load_settings("");
    ASSERT_TRUE(settings) << settings.error().message;
    const screens::FiredPot fired = jar(*settings);
    const sharing::SharedPot pot = shared_pot(fired, 0, *settings, 2);
    EXPECT_EQ(pot.outside.size(), fired.shape.outside.size());
    EXPECT_DOUBLE_EQ(pot.outside.back().height_mm, 160.0);
    EXPECT_EQ(pot.inside.size(), fired.shape.inside.size());
    EXPECT_EQ(pot.capacity_ml, 1250.0);
    EXPECT_EQ(pot.first_language, 2U);
    ASSERT_EQ(pot.words.size(), settings->languages->size());
    ASSERT_EQ((*settings->languages)[1].code(), "en");
    EXPECT_EQ(pot.words[1].glaze, "Celadon");
    EXPECT_EQ(pot.words[0].glaze, "청자");
    ASSERT_TRUE(fired.relative);
    EXPECT_EQ(pot.words[1].nearest_name, (*settings->languages)[1].shown(fired.relative->name_key));
    EXPECT_TRUE(pot.words[1].nearest_line.ends_with("\u00a0mm")) << pot.words[1].nearest_line;
    EXPECT_EQ(pot.words[1].nearest_line.find("\n\n"), std::string::npos) << "nothing is named by nothing";
    EXPECT_NE(pot.words[2].nearest_line.find("ملم"), std::string::npos);
    EXPECT_FALSE(pot.nearest_outside.empty());
    EXPECT_FALSE(pot.model_glb.is_given()) << "files are the caller's";
}

TEST(KioskShare, TellsThePotsStoryInEachLanguageTheHousesFirst) {
    auto settings = load_settings("");
    ASSERT_TRUE(settings) << settings.error().message;
    settings->config.sharing.licence = {{"", "CC BY 4.0"}};
    settings->config.sharing.publisher = {{"ko", "흙의 집"}, {"en", "House of Clay"}};
    screens::FiredPot fired = jar(*settings);
    fired.drawn_with.pigment[3] = 9;
    fired.drawn_with.pigment[4] = 9;
    const exporter::PotStory story = pot_story(fired, 0, *settings);
    const asset::About& about = story.about;
    ASSERT_EQ(about.title.size(), 3U);
    EXPECT_EQ(about.title[0], (asset::Wording{"en", "Pot, celadon"}));
    EXPECT_EQ(about.title[1], (asset::Wording{"ko", "그릇, 청자"}));
    EXPECT_NE(about.description[0].text.find("160 mm high. Closest to: "), std::string::npos)
        << about.description[0].text;
    EXPECT_EQ(about.description[0].text.find('\n'), std::string::npos);
    EXPECT_EQ(about.description[2].text.find(", "), std::string::npos) << "a comma of other letters";
    EXPECT_EQ(about.rights, (asset::Wordings{{"en", "CC BY 4.0"}}));
    EXPECT_EQ(about.publisher, (asset::Wordings{{"en", "House of Clay"}, {"ko", "흙의 집"}}));
    EXPECT_TRUE(about.relation.starts_with(fired.relative->record + " (")) << about.relation;
    std::vector<std::string> names;
    for (const asset::Extra& extra : story.extras)
        names.push_back(extra.first);
    EXPECT_EQ(names, (std::vector<std::string>{"title", "made", "glaze", "decoration", "nearest_pot",
                                               "nearest_pot_source", "licence", "publisher"}))
        << "and no word of the visitor";
    EXPECT_EQ(std::get<std::string>(story.extras[3].second), "iron, cobalt");

    fired.is_after_relative = true;
    EXPECT_EQ(pot_story(fired, 1, *settings).about.title[0].text,
              (*settings->languages)[1].shown(fired.relative->name_key) + ", white porcelain");
}

TEST(KioskShare, JoinsThePotsStoryByTheSignsOfItsLanguage) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "kiosk.toml", "[languages]\norder = [\"fr\", \"ja\", \"de\"]\nfirst = \"fr\"\n");
    const auto settings = load_settings(folder / "kiosk.toml");
    ASSERT_TRUE(settings) << settings.error().message;
    const exporter::PotStory story = pot_story(jar(*settings), 0, *settings);
    EXPECT_EQ(story.about.title[0], (asset::Wording{"fr", "Pot de terre, céladon"}));
    EXPECT_EQ(story.about.title[1], (asset::Wording{"ja", "うつわ、青磁"}));
    EXPECT_EQ(story.about.title[2], (asset::Wording{"de", "Gefäß, Seladon"}));
    const auto says = [&](std::size_t place, std::string_view words) {
        const std::string& text = story.about.description[place].text;
        EXPECT_NE(text.find(words), std::string::npos) << text;
    };
    says(0, "Le plus proche\u00a0: ");
    says(1, "高さ160\u00a0mm。似たうつわ：");
    says(2, "160\u00a0mm hoch. Am ähnlichsten: ");
}

TEST(KioskShare, DrawsAPosterThatStandsWhereThePageDrawsThePot) {
    const auto settings = load_settings("");
    ASSERT_TRUE(settings);
    constexpr int kSide = 200;
    const asset::Image poster = share_poster(jar(*settings).shape, 0, kSide);
    ASSERT_EQ(poster.width, kSide);
    const auto alpha = [&](int x, int y) {
        return poster.rgba[(static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)) * 4 + 3];
    };
    for (const auto& [x, y] : {std::pair{0, 0}, {199, 0}, {0, 199}, {199, 199}, {100, 198}})
        EXPECT_EQ(alpha(x, y), 0) << x << ' ' << y;
    EXPECT_EQ(alpha(100, 100), 255);
    int top = 0;
    int bottom = kSide - 1;
    while (top < kSide && alpha(100, top) == 0)
        ++top;
    while (bottom > 0 && alpha(100, bottom) == 0)
        --bottom;
    EXPECT_GT(top, 2);
    EXPECT_LT(top, 20);
    EXPECT_GT(bottom, 175);
    EXPECT_LT(bottom, 196) << "on the board";
}

struct Silhouette {
    int side_px = 0;
    std::vector<bool> covered;  // rows from the top

    [[nodiscard]] bool at(int x, int y) const {
        return x >= 0 && y >= 0 && x < side_px && y < side_px &&
               covered[static_cast<std::size_t>(y * side_px + x)];
    }
};

Silhouette silhouette_of(const asset::Image& picture) {
    Silhouette found{.side_px = picture.width, .covered = {}};
    for (std::size_t at = 3; at < picture.rgba.size(); at += 4)
        found.covered.push_back(picture.rgba[at] >= 128);
    return found;
}

// Of the exported solid, as the poster's camera sees it.
Silhouette silhouette_of(const asset::Mesh& mesh, const pot::Section& shape, int side_px) {
    constexpr float kElevationRad = 0.16F;
    constexpr float kBoard = 0.039F;
    const float side = static_cast<float>(side_px);
    const float across = shape.radius_mm() * std::sin(kElevationRad);
    const float tall_mm = 0.5F * shape.height_mm() * std::cos(kElevationRad) + across;
    const float scale = 0.5F * side / std::max(tall_mm * 1.06F / (1.0F - kBoard), shape.radius_mm() * 1.16F);
    const vec2 foot(0.5F * side, side * (1.0F - kBoard) - across * scale);
    asset::Image picture{.width = side_px, .height = side_px, .rgba = {}};
    picture.rgba.resize(static_cast<std::size_t>(4 * side_px * side_px));
    std::vector<vec2> px;
    for (const vec3& at_m : mesh.positions_m) {
        const vec3 mm = 1e3F * at_m;
        px.push_back(foot +
                     scale * vec2(mm.x, mm.z * std::sin(kElevationRad) - mm.y * std::cos(kElevationRad)));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec2 a = px[mesh.indices[i]];
        const vec2 b = px[mesh.indices[i + 1]] - a;
        const vec2 c = px[mesh.indices[i + 2]] - a;
        const float area = b.x * c.y - b.y * c.x;
        if (std::abs(area) < 1e-6F) continue;
        const vec2 low = glm::floor(a + glm::min(vec2(0.0F), glm::min(b, c)));
        const vec2 high = glm::ceil(a + glm::max(vec2(0.0F), glm::max(b, c)));
        for (float y = low.y; y < high.y; y += 1.0F) {
            for (float x = low.x; x < high.x; x += 1.0F) {
                const vec2 p = vec2(x + 0.5F, y + 0.5F) - a;
                const float u = (p.x * c.y - p.y * c.x) / area;
                const float v = (b.x * p.y - b.y * p.x) / area;
                if (u < 0.0F || v < 0.0F || u + v > 1.0F) continue;
                picture.rgba[static_cast<std::size_t>(
                    4 * (static_cast<int>(y) * side_px + static_cast<int>(x)) + 3)] = 255;
            }
        }
    }
    return silhouette_of(picture);
}

// Whether each covered pixel of one has a covered one of the other within so many pixels.
bool is_within(const Silhouette& one, const Silhouette& other, int px) {
    for (int y = 0; y < one.side_px; ++y) {
        for (int x = 0; x < one.side_px; ++x) {
            bool has_near = !one.at(x, y);
            for (int k = 0; k < (2 * px + 1) * (2 * px + 1) && !has_near; ++k)
                has_near = other.at(x - px + k % (2 * px + 1), y - px + k / (2 * px + 1));
            if (!has_near) return false;
        }
    }
    return true;
}

// The most that two silhouettes are apart, pixels.
int most_apart_px(const Silhouette& one, const Silhouette& other) {
    int px = 0;
    while (px < 20 && !(is_within(one, other, px) && is_within(other, one, px)))
        ++px;
    return px;
}

TEST(KioskShare, DrawsAPosterOfAPotThatIsNotRoundAsItsSolidIs) {
    constexpr int kSide = 480;
    int off_round = 0;
    for (const support::StudioSample& sample : support::all_studio_samples()) {
        if (sample.euler != 2 || sample.parts != 1 || sample.name.ends_with("jagged")) continue;
        const screens::FiredPot fired = fired_pot(sample.clay, {}, nullptr);
        // The one for printing, whose edges no glaze rounds.
        const auto solid = exporter::pot_file(sample.clay, clay::Firing::kGlaze);
        ASSERT_TRUE(solid) << sample.name;
        const Silhouette drawn = silhouette_of(share_poster(fired.shape, 0, kSide));
        EXPECT_LE(most_apart_px(drawn, silhouette_of(solid->content.mesh, fired.shape, kSide)), 1)
            << sample.name;
        if (!fired.shape.off_round) continue;
        ++off_round;
        pot::Section round = fired.shape;
        round.off_round = nullptr;
        EXPECT_GT(most_apart_px(silhouette_of(share_poster(round, 0, kSide)),
                                silhouette_of(solid->content.mesh, round, kSide)),
                  1)
            << sample.name << ": a round one is another";
    }
    EXPECT_GE(off_round, 2);
}

TEST(KioskShare, HandsThePageAxisAndDentsOfAPotThatIsNotRound) {
    const auto settings = load_settings("");
    ASSERT_TRUE(settings);
    screens::FiredPot fired = jar(*settings);
    EXPECT_TRUE(shared_pot(fired, 0, *settings, 0).axis.empty());
    pot::OffRound map{.centre_mm = {{0.0F, 0.0F}, {3.0F, -1.0F}},
                      .dents_mm = std::vector<float>(2 * pot::OffRound::kCorners, 0.0F)};
    map.dents_mm[pot::OffRound::kCorners] = -4.0F;  // at the rim, in the clay's direction 0
    fired.shape.off_round = std::make_shared<const pot::OffRound>(map);
    const sharing::SharedPot pot = shared_pot(fired, 0, *settings, 0);
    ASSERT_EQ(pot.axis.size(), 2U);
    ASSERT_EQ(pot.dents_mm.size(), 2U);
    // Without a decoration the clay's direction 0 is to the right.
    EXPECT_NEAR(pot.axis[1].x_mm, 3.0, 1e-4);
    EXPECT_NEAR(pot.axis[1].z_mm, 1.0, 1e-4);
    EXPECT_NEAR(pot.axis[1].height_mm, double{fired.shape.height_mm()}, 1e-4);
    EXPECT_NEAR(pot.dents_mm[1][0], -4.0, 1e-4);
    EXPECT_NEAR(pot.dents_mm[1][64], 0.0, 1e-4);
    EXPECT_NEAR(pot.dents_mm[0][0], 0.0, 1e-4);
    EXPECT_NEAR(pot.reach_mm, double{fired.shape.radius_mm()}, 1e-6);
}

TEST(KioskShare, KnowsWhereAndHowLong) {
    auto settings = load_settings("");
    ASSERT_TRUE(settings);
    kiosk::Config& config = settings->config;
    config.sharing.listen = "lo";
    config.sharing.most_mb = 12.0;
    EXPECT_EQ(*share_base_url(config), "http://127.0.0.1:8080");
    config.sharing.public_url = "https://museum.org/pots";
    EXPECT_EQ(*share_base_url(config), "https://museum.org/pots");
    const sharing::OutboxOptions options = outbox_options(*settings);
    EXPECT_EQ(options.most_bytes, 12'000'000U);
    EXPECT_EQ(options.public_url, "https://museum.org/pots");
    EXPECT_EQ(options.languages, settings->languages);
    config.sharing.hours = 3;
    const sharing::ShareTime time = share_time_now(config);
    EXPECT_EQ(time.expires_s - time.now_s, 3 * 3600);
    EXPECT_LE(std::abs(time.utc_offset_s), 14 * 3600);
    config.sharing = {};
    EXPECT_FALSE(share_base_url(config)) << "off";
}

TEST(KioskShare, WrapsEachGlazeRoundThePotWithoutASeamAndLeavesTheFootBare) {
    const auto settings = load_settings("");
    ASSERT_TRUE(settings);
    const pot::Section shape = jar(*settings).shape;
    for (int glaze = 0; glaze < finish::kGlazeCount; ++glaze) {
        const asset::Image wrapped = share_surface(shape, glaze);
        ASSERT_GT(wrapped.width, 0);
        const auto at = [&](int column, int row, int channel) {
            return int{wrapped.rgba[static_cast<std::size_t>(4 * (row * wrapped.width + column) + channel)]};
        };
        int most_step = 0;  // from one column to the next, anywhere but where they meet
        int seam = 0;
        for (int row = 0; row < wrapped.height; ++row) {
            seam = std::max(seam, std::abs(at(0, row, 0) - at(wrapped.width - 1, row, 0)));
            for (int column = 1; column < wrapped.width; ++column)
                most_step = std::max(most_step, std::abs(at(column, row, 0) - at(column - 1, row, 0)));
        }
        EXPECT_LE(seam, most_step) << finish::glaze_at(glaze).id;
        const bool has_bare_foot = finish::glaze_at(glaze).foot_bare_mm > 1.0F;
        for (int column = 1; has_bare_foot && column < wrapped.width; ++column)
            EXPECT_EQ(at(column, wrapped.height - 1, 0), at(0, wrapped.height - 1, 0));
    }
    EXPECT_EQ(share_surface({}, 0).width, 0) << "no outside, nothing to wrap";
}

}  // namespace
}  // namespace onggi::app
