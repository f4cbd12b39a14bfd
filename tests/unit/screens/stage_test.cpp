#include "game/screens/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

#include "game/visit/steps.h"
#include "tests/support/comes_true.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

class Theatre : public testing::Test {
  protected:
    std::shared_ptr<const Composed> composed(const std::string& name, const std::string& language = "en",
                                             bool is_still = false) {
        for (const SampleView& sample :
             sample_views({.width_px = 640, .height_px = 360, .language = language})) {
            if (sample.name != name) continue;
            auto view = std::make_shared<View>(*sample.view);
            view->state.comfort.still = is_still;
            Composition composition = visit::compose(*view, painter_, store_);
            return std::make_shared<const Composed>(Composed{std::move(view), std::move(composition)});
        }
        return nullptr;
    }
    const ui::DrawList& draw(double now_s, int pressed = -1, const Cue* cue = nullptr) {
        return stage_.draw({.now_s = now_s, .pressed = pressed, .cue = cue});
    }
    static Cue belt() {
        Cue cue;
        for (int i = 0; i <= 10; ++i) {
            cue.belt.upper.push_back({200.0F + 10.0F * static_cast<float>(i), 100.0F});
            cue.belt.lower.push_back({200.0F + 10.0F * static_cast<float>(i), 130.0F});
        }
        return cue;
    }
    ui::Painter painter_;
    PaintingStore store_{painter_};
    Stage stage_;
};

TEST_F(Theatre, IsEmptyBeforeTheFirstScreen) {
    EXPECT_TRUE(draw(0.0).runs().empty());
    EXPECT_FALSE(stage_.covers());
    EXPECT_EQ(stage_.target_at({10.0F, 10.0F}), -1);
}

TEST_F(Theatre, UploadsEachPictureOnce) {
    stage_.take(composed("choose"), 0.0);
    static_cast<void>(draw(0.0));
    EXPECT_GT(stage_.uploads().size(), 10U);
    static_cast<void>(draw(0.1));
    EXPECT_TRUE(stage_.uploads().empty());
    EXPECT_TRUE(stage_.covers());
}

TEST_F(Theatre, FadesFromOneScreenToTheNextInUnderThreeTenths) {
    stage_.take(composed("choose"), 0.0);
    const std::uint64_t first = draw(1.0).hash();
    EXPECT_EQ(draw(2.0).hash(), first) << "a still screen is the same list every frame";
    stage_.take(composed("throw-0"), 2.0);
    EXPECT_TRUE(stage_.changes(2.1));
    const std::uint64_t half_way = draw(2.1).hash();
    EXPECT_NE(half_way, first);
    EXPECT_FALSE(stage_.covers()) << "the scene comes through";
    const std::uint64_t after = draw(2.3).hash();
    EXPECT_NE(after, half_way);
    EXPECT_EQ(draw(2.6).hash(), after);
}

TEST_F(Theatre, LetsTheSceneRestWhileAScreenThatCoversItComesOrGoes) {
    stage_.take(composed("choose"), 0.0);
    const std::uint64_t covered = draw(1.0).hash();
    EXPECT_FALSE(stage_.scene_rests());
    stage_.take(composed("throw-0"), 2.0);
    EXPECT_EQ(draw(2.0).hash(), covered) << "nothing has faded yet";
    EXPECT_TRUE(stage_.covers());
    EXPECT_TRUE(stage_.scene_rests());
    static_cast<void>(draw(2.1));
    EXPECT_FALSE(stage_.covers());
    EXPECT_TRUE(stage_.scene_rests());
    static_cast<void>(draw(2.6));
    EXPECT_FALSE(stage_.scene_rests());
    // In another language it is the same scene, with a visitor at work.
    stage_.take(composed("throw-0", "ko"), 3.0);
    static_cast<void>(draw(3.1));
    EXPECT_FALSE(stage_.scene_rests());
    stage_.take(composed("firing-0", "ko"), 4.0);
    static_cast<void>(draw(4.0));
    EXPECT_FALSE(stage_.covers());
    EXPECT_TRUE(stage_.scene_rests());
    static_cast<void>(draw(4.6));
    EXPECT_TRUE(stage_.covers());
    EXPECT_FALSE(stage_.scene_rests());
}

TEST_F(Theatre, FadesSlowlyBetweenTheThrowingAndAMuseumsPotAndQuicklyToAVisitor) {
    stage_.take(composed("attract"), 0.0);
    static_cast<void>(draw(1.0));
    stage_.take(composed("attract-heritage"), 1.0);
    EXPECT_TRUE(stage_.changes(1.55));
    const std::uint64_t nearly = draw(1.55).hash();
    EXPECT_NE(draw(1.65).hash(), nearly);
    EXPECT_FALSE(stage_.changes(1.65));
    stage_.take(composed("choose"), 2.0);
    static_cast<void>(draw(2.1));
    EXPECT_FALSE(stage_.changes(2.25)) << "who has touched it does not wait";
}

// Counts the vertices that both lists have, with the same position and colour.
std::size_t shared_vertices(const std::vector<ui::Vertex>& list, const std::vector<ui::Vertex>& other) {
    return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), [&](const ui::Vertex& vertex) {
        return std::any_of(other.begin(), other.end(), [&](const ui::Vertex& one) {
            return one.position_px == vertex.position_px && one.atlas_px == vertex.atlas_px &&
                   one.rgba == vertex.rgba;
        });
    }));
}

TEST_F(Theatre, KeepsCommonItemsOfTwoScreensAndFadesTheOthers) {
    const auto drawn = [&](double now_s) {
        const ui::DrawList& list = draw(now_s);
        return std::vector<ui::Vertex>(list.vertices().begin(), list.vertices().end());
    };
    // The ledge and its keys in another language; two screens before the same wall.
    for (const auto& [from, to, least] :
         {std::tuple{"throw-0", "throw-0", 0.15}, {"choose", "glaze-0", 0.02}}) {
        const bool is_translated = std::string(from) == to;
        Stage fresh;
        std::swap(stage_, fresh);
        stage_.take(composed(from), 0.0);
        const std::vector<ui::Vertex> before = drawn(1.0);
        stage_.take(composed(to, is_translated ? "ko" : "en"), 2.0);
        ASSERT_TRUE(stage_.changes(2.1));
        const std::vector<ui::Vertex> half_way = drawn(2.1);
        const std::vector<ui::Vertex> after = drawn(2.6);
        EXPECT_LT(half_way.size(), before.size() + after.size()) << from << " to " << to;
        const double fraction =
            static_cast<double>(shared_vertices(after, half_way)) / static_cast<double>(after.size());
        EXPECT_GT(fraction, least) << from << " to " << to;
        EXPECT_LT(fraction, 1.0) << from << " to " << to << ": something fades";
        EXPECT_LT(shared_vertices(before, half_way), before.size());
    }
}

TEST_F(Theatre, ChangesAtOnceWithinAScreen) {
    stage_.take(composed("glaze-0"), 0.0);
    static_cast<void>(draw(1.0));
    stage_.take(composed("glaze-3"), 1.0);
    EXPECT_FALSE(stage_.changes(1.0));
}

TEST_F(Theatre, SinksATokenThatIsPressed) {
    const auto screen = composed("failure");
    stage_.take(screen, 0.0);
    const std::uint64_t up = draw(1.0).hash();
    const std::uint64_t down = draw(1.1, 2).hash();
    EXPECT_NE(down, up);
    EXPECT_EQ(draw(1.2).hash(), up);
}

TEST_F(Theatre, FindsTheTargetUnderAFinger) {
    const auto screen = composed("failure");
    stage_.take(screen, 0.0);
    const Target& last = screen->composition.targets.back();
    EXPECT_EQ(stage_.target_at(last.rect.centre() * screen->composition.px_per_u),
              static_cast<int>(screen->composition.targets.size()) - 1);
    EXPECT_EQ(stage_.target_at({320.0F, 180.0F}), -1);
}

TEST_F(Theatre, TakesATouchedPotForItsCard) {
    const auto screen = composed("choose");
    stage_.take(screen, 0.0);
    const Composition& composition = screen->composition;
    int touched = 0;
    for (std::size_t i = 0; i < composition.targets.size(); ++i) {
        const Target& target = composition.targets[i];
        if (target.button != kiosk::Button::kFree && target.button != kiosk::Button::kTarget) continue;
        EXPECT_LT(target.also.bottom(), target.rect.y) << "above its card: " << target.name;
        EXPECT_EQ(stage_.target_at(target.also.centre() * composition.px_per_u), static_cast<int>(i))
            << target.name;
        ++touched;
    }
    EXPECT_EQ(touched, 4) << "the clay, and three pots";
}

TEST_F(Theatre, BringsTheCueAndTakesItAway) {
    stage_.take(composed("throw-0"), 0.0);
    const std::size_t without = draw(1.0).vertices().size();
    Cue cue = belt();
    for (double now_s = 1.0; now_s < 1.3; now_s += 0.05)
        static_cast<void>(draw(now_s, -1, &cue));
    const std::size_t with_belt = draw(1.3, -1, &cue).vertices().size();
    EXPECT_GT(with_belt, without + 40);
    const std::uint64_t whole = draw(1.35, -1, &cue).hash();
    EXPECT_EQ(draw(1.4, -1, &cue).hash(), whole) << "it has come";
    EXPECT_NE(draw(1.45).hash(), whole) << "and goes";
    EXPECT_GT(draw(1.5).vertices().size(), without);
    static_cast<void>(draw(1.6));
    EXPECT_EQ(draw(1.7).vertices().size(), without);
    cue.way = CueWay::kUp;
    EXPECT_GT(draw(1.8, -1, &cue).vertices().size(), with_belt) << "and an arrow";
    const std::size_t with_arrow = draw(1.85, -1, &cue).vertices().size();
    cue.thread = {.finger_px = {250.0F, 40.0F}, .hand_px = {250.0F, 110.0F}, .strength = 1.0F};
    EXPECT_GT(draw(1.9, -1, &cue).vertices().size(), with_arrow) << "and a thread to hands that lag";
}

TEST_F(Theatre, DrawsNoCueUnderAWarningNorOutsideThrowing) {
    const Cue cue = belt();
    const Band band = cue.belt;
    stage_.take(composed("throw-0"), 0.0);
    const auto drawn = [&](double now_s, const Cue* shown) {
        return stage_.draw({.now_s = now_s, .band = &band, .cue = shown}).vertices().size();
    };
    static_cast<void>(drawn(1.0, nullptr));
    EXPECT_EQ(drawn(2.0, &cue), drawn(2.0, nullptr));
    stage_.take(composed("your-pot"), 3.0);
    static_cast<void>(draw(3.1));
    const std::size_t without = draw(4.0).vertices().size();
    static_cast<void>(draw(4.1, -1, &cue));
    EXPECT_EQ(draw(4.2, -1, &cue).vertices().size(), without);
}

TEST_F(Theatre, SaysBesideTheBeltWhyTheClayDoesLess) {
    for (const char* language : {"en", "ko", "ar"}) {
        const auto screen = composed("throw-3", language);
        Stage stage;
        stage.take(screen, 0.0);
        for (int guard = 1; guard < kCueGuardCount; ++guard) {
            for (const bool on_left : {false, true}) {
                Cue cue = belt();
                const auto whole = [&](double now_s) {
                    static_cast<void>(stage.draw({.now_s = now_s, .cue = &cue}));
                    return stage.draw({.now_s = now_s + 0.3, .cue = &cue}).vertices();
                };
                const std::size_t silent = whole(1.0).size();
                cue.guard = static_cast<CueGuard>(guard);
                cue.words_on_left = on_left;
                const auto vertices = whole(2.0);
                EXPECT_GT(vertices.size(), silent) << language << ' ' << guard;
                for (const ui::Vertex& vertex : vertices) {
                    EXPECT_GE(vertex.position_px.x, -1.0F) << language << ' ' << guard;
                    EXPECT_LE(vertex.position_px.x, 641.0F) << language << ' ' << guard;
                }
            }
        }
    }
}

TEST_F(Theatre, DrawsTheWarningOnThePotWithoutTheAtlas) {
    stage_.take(composed("warning-thin"), 0.0);
    const std::size_t without = draw(1.0).vertices().size();
    Band band;
    for (int i = 0; i <= 10; ++i) {
        band.upper.push_back({200.0F + 10.0F * static_cast<float>(i), 100.0F});
        band.lower.push_back({200.0F + 10.0F * static_cast<float>(i), 130.0F});
    }
    EXPECT_GT(stage_.draw({.now_s = 1.1, .band = &band}).vertices().size(), without + 60);
}

TEST(Composer, ComposesTheNewestRequestBesideTheFrame) {
    Composer composer(visit::compose);
    ASSERT_TRUE(composer.start());
    const auto samples = sample_views({.width_px = 640, .height_px = 360});
    for (const SampleView& sample : samples)
        composer.ask(sample.view);
    std::shared_ptr<const Composed> latest;
    ASSERT_TRUE(test::comes_true([&] {
        latest = composer.latest();
        return latest && latest->view == samples.back().view;
    }));
    EXPECT_FALSE(latest->composition.items.empty());
}

// A frame never waits for text: it is painted beside the frames.
TEST(Composer, LeavesNoPaintingToTheFrame) {
    const auto samples = sample_views({.width_px = 320, .height_px = 180});
    Composer composer(visit::compose);
    Stage stage;
    ASSERT_TRUE(composer.start());
    const std::uint64_t before = ui::Painter::work_of_this_thread();
    double now_s = 0.0;
    for (const SampleView& sample : samples) {
        composer.ask(sample.view);
        ASSERT_TRUE(test::comes_true([&] {
            now_s += 0.016;
            stage.take(composer.latest(), now_s);
            stage.turn(composer.turned());
            static_cast<void>(stage.draw({.now_s = now_s}));
            return stage.shown() != nullptr && stage.shown()->view == sample.view;
        }));
    }
    EXPECT_EQ(ui::Painter::work_of_this_thread(), before);
}

TEST_F(Theatre, TurnsAPotInTwoPlacesByTurns) {
    const auto screen = composed("your-pot");
    stage_.take(screen, 0.0);
    const auto& items = screen->composition.items;
    const auto pot =
        std::find_if(items.begin(), items.end(), [](const Item& item) { return item.turning != nullptr; });
    ASSERT_NE(pot, items.end());
    const std::uint64_t still = draw(1.0).hash();
    const auto turned = [&](double turn) {
        return std::make_shared<const TurnedPots>(TurnedPots{{pot->key, pot->turning->at(turn)}});
    };
    stage_.turn(turned(0.1));
    const std::uint64_t first = draw(1.1).hash();
    EXPECT_EQ(stage_.uploads().size(), 1U);
    stage_.turn(turned(0.2));
    const std::uint64_t second = draw(1.2).hash();
    EXPECT_EQ(stage_.uploads().size(), 1U);
    EXPECT_EQ((std::set<std::uint64_t>{still, first, second}).size(), 3U);
    EXPECT_EQ(draw(1.25).hash(), second);
    EXPECT_TRUE(stage_.uploads().empty()) << "only new pictures";
    stage_.turn(turned(0.3));
    EXPECT_EQ(draw(1.3).hash(), first) << "the first place again";
}

TEST_F(Theatre, KeepsDoneWhereItIsWhateverTheHandHolds) {
    const auto done_of = [&](const char* name) {
        std::vector<ui::Rect> places;
        const auto screen = composed(name);
        for (const Target& target : screen->composition.targets)
            if (target.button == kiosk::Button::kDone) places.push_back(target.rect);
        return places;
    };
    const auto by_hand = done_of("throw-3");
    ASSERT_EQ(by_hand.size(), 1U);
    for (const char* name : {"held-1", "held-2", "held-3"}) {
        const auto held = done_of(name);
        ASSERT_EQ(held.size(), 1U) << name;
        EXPECT_EQ(held[0].centre(), by_hand[0].centre()) << name;
    }
}

TEST_F(Theatre, SaysWhatAHeldToolDoesAndBeforeTheLessonIsOverWhatItCannotDo) {
    const auto says = [&](const char* name, const char* words) {
        const auto screen = composed(name);
        const auto& writings = screen->composition.writings;
        return std::any_of(writings.begin(), writings.end(),
                           [&](const Writing& writing) { return writing.words == words; });
    };
    EXPECT_TRUE(says("held-1", "Makes the wall straight and even"));
    EXPECT_TRUE(says("held-2", "Smooths, and soaks up water"));
    EXPECT_TRUE(says("held-too-soon", "Only the hand opens and raises"));
    EXPECT_FALSE(says("throw-0", "Only the hand opens and raises"));
}

TEST(TurnTable, TurnsOnceInNineSecondsAndStopsUnderAFinger) {
    TurnTable table;
    double turn = 0.0;
    for (int i = 0; i < 45; ++i)
        turn = table.pass(0.1, false, false);
    EXPECT_NEAR(turn, 0.5, 1e-9);
    EXPECT_EQ(table.pass(1.0, false, true), turn);
}

TEST(TurnTable, ShowsFourStillViewsWithReducedMotion) {
    TurnTable table;
    std::map<double, int> views;
    for (int i = 0; i < 159; ++i)
        ++views[table.pass(0.1, true, false)];
    ASSERT_EQ(views.size(), 4U);
    for (const auto& [view, times] : views)
        EXPECT_NEAR(times, 40, 1) << view;
}

TEST_F(Theatre, DrawsTheWireUnderThePotInASecond) {
    stage_.take(composed("firing-0"), 0.0);
    const std::uint64_t behind = draw(0.05).hash();
    EXPECT_NE(draw(0.5).hash(), behind);
    const std::uint64_t through = draw(1.05).hash();
    EXPECT_NE(through, behind);
    EXPECT_EQ(draw(2.0).hash(), through);
}

TEST_F(Theatre, HeatsThePotInAFireThatFlickersAndCoolsItToItsGlaze) {
    stage_.take(composed("firing-1"), 0.0);
    static_cast<void>(draw(3.0));
    stage_.take(composed("firing-2"), 3.0);
    std::set<std::uint64_t> seen;
    for (int frame = 0; frame < 20; ++frame)
        seen.insert(draw(5.0 + frame / 30.0).hash());
    EXPECT_EQ(seen.size(), 20U);
    stage_.take(composed("glaze-1"), 6.0);
    const std::uint64_t glowing = draw(6.5).hash();
    const std::uint64_t cool = draw(8.0).hash();
    EXPECT_NE(glowing, cool);
    EXPECT_EQ(draw(9.0).hash(), cool);
}

TEST_F(Theatre, OpensTheKilnsDoorOnTheGlaze) {
    const auto is_hidden = [&](const char* name, double since_s, bool still = false) {
        const auto shown = composed(name, "en", still);
        const Composition& screen = shown->composition;
        const ui::Rect pot = screen.pots.front().grown(-12.0F);  // the box is larger than the pot
        return std::any_of(screen.items.begin(), screen.items.end(), [&](const Item& item) {
            if (item.motion.from_y_u == 0.0F || !item.painting) return false;
            const Moved moves = still ? moved_to_the_end(item.motion) : moved(item.motion, since_s);
            const ui::Rect now = item.rect.moved({0.0F, moves.down_u});
            return moves.alpha >= 1.0F && now.x <= pot.x && now.right() >= pot.right() && now.y <= pot.y &&
                   now.bottom() >= pot.bottom();
        });
    };
    constexpr double kFireS = 2.4;
    EXPECT_FALSE(is_hidden("firing-2", 1.2)) << "first the pot glows in the fire";
    EXPECT_TRUE(is_hidden("firing-2", kFireS));
    EXPECT_FALSE(is_hidden("firing-2", 0.0, true)) << "who wants less motion sees the fire";
    EXPECT_TRUE(is_hidden("glaze-1", 0.0)) << "the next screen begins where this one ends";
    EXPECT_FALSE(is_hidden("glaze-1", 1.0));
    EXPECT_FALSE(is_hidden("glaze-1", 0.0, true));
}

TEST_F(Theatre, ShowsTheEndOfEveryMotionToWhoWantsLessOfIt) {
    for (const char* name : {"firing-0", "firing-1", "firing-2", "glaze-1"}) {
        Stage still;
        still.take(composed(name, "en", true), 0.0);
        const std::uint64_t first = still.draw({.now_s = 0.01}).hash();
        EXPECT_EQ(still.draw({.now_s = 3.0}).hash(), first) << name;
    }
}

}  // namespace
}  // namespace onggi::screens
