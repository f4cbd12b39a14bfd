// Storage of one component type: components lie side by side in insertion order, and a sparse table leads
// from an entity's index to its place. Adding, removing and finding take constant time. Main thread. Removing
// moves the last component into the gap, so order changes, but always in the same way: two runs of the same
// calls walk the components in the same order.
#pragma once

#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/ecs/entity.h"

namespace onggi::ecs {

// What the registry must do with a storage without knowing its component type.
class AnySparseSet {
  public:
    virtual ~AnySparseSet() = default;
    virtual void erase(Entity entity) = 0;
};

template <typename Component>
class SparseSet final : public AnySparseSet {
  public:
    [[nodiscard]] std::size_t size() const { return entities_.size(); }
    [[nodiscard]] bool contains(Entity entity) const { return find_place(entity) != kNowhere; }

    // Null where the entity has none. Valid until a component of this type is added or removed.
    [[nodiscard]] Component* find(Entity entity) {
        const std::size_t place = find_place(entity);
        return place == kNowhere ? nullptr : &components_[place];
    }

    // Adds, or replaces what the entity has.
    Component& put(Entity entity, Component component) {
        if (Component* present = find(entity)) return *present = std::move(component);
        if (entity.index >= places_.size()) places_.resize(entity.index + 1U, kNowhere);
        places_[entity.index] = entities_.size();
        entities_.push_back(entity);
        return components_.emplace_back(std::move(component));
    }

    void erase(Entity entity) override {
        const std::size_t place = find_place(entity);
        if (place == kNowhere) return;
        const std::size_t last = entities_.size() - 1;
        if (place != last) {
            entities_[place] = entities_[last];
            components_[place] = std::move(components_[last]);
            places_[entities_[place].index] = place;
        }
        entities_.pop_back();
        components_.pop_back();
        places_[entity.index] = kNowhere;
    }

    [[nodiscard]] Entity entity_at(std::size_t place) const { return entities_[place]; }
    [[nodiscard]] Component& component_at(std::size_t place) { return components_[place]; }

  private:
    static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

    [[nodiscard]] std::size_t find_place(Entity entity) const {
        if (entity.index >= places_.size()) return kNowhere;
        const std::size_t place = places_[entity.index];
        return place != kNowhere && entities_[place] == entity ? place : kNowhere;
    }

    std::vector<std::size_t> places_;  // by entity index
    std::vector<Entity> entities_;     // side by side with components_
    std::vector<Component> components_;
};

}  // namespace onggi::ecs
