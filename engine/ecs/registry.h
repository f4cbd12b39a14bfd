// The registry owns every entity and every component of a scene. Main thread.
// Systems are free functions over it; a component type needs no registration.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace onggi::ecs {

// An entity is an identifier: an index into the registry's tables, and a generation that tells a new entity
// from a destroyed one with the same index. A default-constructed one is alive in no registry.
struct Entity {
    static constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t index = kNoIndex;
    std::uint32_t generation = 0;

    friend bool operator==(Entity, Entity) = default;
};

// Storage of one component type: components are contiguous in insertion order, and a sparse table maps an
// entity's index to its component. Adding, removing and finding take constant time. Removing moves the last
// component into the gap, so the order changes, but deterministically: two runs of the same calls visit the
// components in the same order.

// The operations of a storage that do not depend on its component type.
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

    // Null if the entity has none. Valid until a component of this type is added or removed.
    [[nodiscard]] Component* find(Entity entity) {
        const std::size_t place = find_place(entity);
        return place == kNowhere ? nullptr : &components_[place];
    }

    // Adds or replaces the entity's component.
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

    std::vector<std::size_t> places_;  // indexed by entity
    std::vector<Entity> entities_;     // parallel to components_
    std::vector<Component> components_;
};

class Registry {
  public:
    [[nodiscard]] Entity create() {
        if (free_indices_.empty()) {
            generations_.push_back(0);
            return {static_cast<std::uint32_t>(generations_.size() - 1), 0};
        }
        const std::uint32_t index = free_indices_.back();
        free_indices_.pop_back();
        return {index, generations_[index]};
    }

    // Destroys the entity with all its components. Does nothing if it is not alive.
    void destroy(Entity entity) {
        if (!alive(entity)) return;
        for (auto& [type, storage] : storages_)
            storage->erase(entity);
        // The old identifier is now dead; the next entity at this index has another generation.
        ++generations_[entity.index];
        free_indices_.push_back(entity.index);
    }

    [[nodiscard]] bool alive(Entity entity) const {
        return entity.index < generations_.size() && generations_[entity.index] == entity.generation;
    }

    // Adds or replaces a component. Precondition: the entity is alive.
    template <typename Component>
    Component& add(Entity entity, Component component) {
        assert(alive(entity));
        return storage<Component>().put(entity, std::move(component));
    }

    template <typename Component>
    void remove(Entity entity) {
        storage<Component>().erase(entity);
    }

    template <typename Component>
    [[nodiscard]] bool has(Entity entity) {
        return storage<Component>().contains(entity);
    }

    // Null if the entity is dead or has no such component. Valid until one of this type is added or removed.
    template <typename Component>
    [[nodiscard]] Component* find(Entity entity) {
        return storage<Component>().find(entity);
    }

    // Precondition: the entity has the component.
    template <typename Component>
    [[nodiscard]] Component& get(Entity entity) {
        Component* found = find<Component>(entity);
        assert(found != nullptr);
        return *found;
    }

    // Calls visit(entity, first, rest...) for each entity that has them all, in the order of First's storage.
    // visit may change components, but must not add or remove any of the types it visits.
    template <typename First, typename... Rest, typename Visit>
    void each(Visit&& visit) {
        SparseSet<First>& first = storage<First>();
        for (std::size_t place = 0; place < first.size(); ++place) {
            const Entity entity = first.entity_at(place);
            if ((has<Rest>(entity) && ...)) visit(entity, first.component_at(place), get<Rest>(entity)...);
        }
    }

  private:
    template <typename Component>
    SparseSet<Component>& storage() {
        std::unique_ptr<AnySparseSet>& slot = storages_[std::type_index(typeid(Component))];
        if (!slot) slot = std::make_unique<SparseSet<Component>>();
        return static_cast<SparseSet<Component>&>(*slot);
    }

    std::vector<std::uint32_t> generations_;   // by index: generation of the living or next entity
    std::vector<std::uint32_t> free_indices_;  // indices of destroyed entities; the last is reused first
    std::unordered_map<std::type_index, std::unique_ptr<AnySparseSet>> storages_;
};

}  // namespace onggi::ecs
