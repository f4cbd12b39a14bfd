#include "engine/ecs/registry.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>

namespace onggi::ecs {
namespace {

struct Radius {
    double mm = 0.0;
};
struct Label {
    std::string text;
};
struct Owner {
    std::unique_ptr<int> thing;
};

struct RegistryTest : testing::Test {
    Registry registry;
};

TEST_F(RegistryTest, KnowsWhichEntitiesAreAlive) {
    EXPECT_FALSE(registry.alive(Entity{}));
    const Entity pot = registry.create();
    EXPECT_TRUE(registry.alive(pot));
    registry.destroy(pot);
    EXPECT_FALSE(registry.alive(pot));
}

TEST_F(RegistryTest, DoesNotMistakeANewEntityForADestroyedOne) {
    const Entity old_pot = registry.create();
    registry.add(old_pot, Radius{60.0});
    registry.destroy(old_pot);

    const Entity new_pot = registry.create();
    ASSERT_EQ(new_pot.index, old_pot.index);
    EXPECT_NE(new_pot, old_pot);
    EXPECT_EQ(registry.find<Radius>(new_pot), nullptr);
    registry.add(new_pot, Radius{1.0});
    EXPECT_EQ(registry.find<Radius>(old_pot), nullptr);
}

TEST_F(RegistryTest, DestroyingTwiceHasNoEffect) {
    const Entity first = registry.create();
    registry.destroy(first);
    registry.destroy(first);
    const Entity second = registry.create();
    const Entity third = registry.create();
    EXPECT_NE(second.index, third.index);
}

TEST_F(RegistryTest, ReplacesAComponentThatIsAddedAgain) {
    const Entity pot = registry.create();
    registry.add(pot, Radius{60.0});
    registry.add(pot, Radius{40.0});
    EXPECT_EQ(registry.get<Radius>(pot).mm, 40.0);
    int visits = 0;
    registry.each<Radius>([&](Entity, Radius&) { ++visits; });
    EXPECT_EQ(visits, 1);
}

TEST_F(RegistryTest, VisitsThoseThatHaveAllComponents) {
    const Entity both = registry.create();
    const Entity only_radius = registry.create();
    registry.add(both, Radius{1.0});
    registry.add(both, Label{"both"});
    registry.add(only_radius, Radius{2.0});

    std::vector<Entity> visited;
    registry.each<Radius, Label>([&](Entity entity, Radius& radius, Label& label) {
        visited.push_back(entity);
        radius.mm += 10.0;
        EXPECT_EQ(label.text, "both");
    });
    EXPECT_EQ(visited, std::vector<Entity>{both});
    EXPECT_EQ(registry.get<Radius>(both).mm, 11.0);
    EXPECT_EQ(registry.get<Radius>(only_radius).mm, 2.0);
}

TEST_F(RegistryTest, HoldsComponentsThatCannotBeCopied) {
    const Entity entity = registry.create();
    registry.add(entity, Owner{std::make_unique<int>(7)});
    EXPECT_EQ(*registry.get<Owner>(entity).thing, 7);
    registry.remove<Owner>(entity);
    EXPECT_FALSE(registry.has<Owner>(entity));
}

// Against a map, over many random calls: the sparse set must never lose, mix up or invent a component.
TEST_F(RegistryTest, AgreesWithAPlainMapOverRandomCalls) {
    std::vector<Entity> ever;
    std::map<std::size_t, double> expected;  // by position in ever
    std::mt19937 random(20240607);
    for (int call = 0; call < 20000; ++call) {
        const unsigned action = random() % 4;
        if (action == 0 || ever.empty()) {
            ever.push_back(registry.create());
            continue;
        }
        const std::size_t chosen = random() % ever.size();
        const Entity entity = ever[chosen];
        if (action == 1 && registry.alive(entity)) {
            registry.add(entity, Radius{static_cast<double>(call)});
            expected[chosen] = call;
        } else if (action == 2) {
            registry.remove<Radius>(entity);
            expected.erase(chosen);
        } else if (action == 3) {
            registry.destroy(entity);
            expected.erase(chosen);
        }
    }
    std::size_t found = 0;
    for (std::size_t i = 0; i < ever.size(); ++i) {
        const Radius* radius = registry.find<Radius>(ever[i]);
        const auto wanted = expected.find(i);
        ASSERT_EQ(radius != nullptr, wanted != expected.end()) << "entity " << i;
        if (radius == nullptr) continue;
        EXPECT_EQ(radius->mm, wanted->second);
        ++found;
    }
    EXPECT_EQ(found, expected.size());
    EXPECT_GT(found, 100U);
}

}  // namespace
}  // namespace onggi::ecs
