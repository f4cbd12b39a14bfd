// The registry owns every entity and every component of a scene. Main thread.
// Systems are free functions over it; a component type needs no registration.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/ecs/entity.h"
#include "engine/ecs/sparse_set.h"

namespace onggi::ecs {

class Registry {
  public:
    [[nodiscard]] Entity create();
    // Destroys the entity with all its components. An entity that is not alive is left alone.
    void destroy(Entity entity);
    [[nodiscard]] bool alive(Entity entity) const;

    // Adds a component, or replaces the one the entity has. Precondition: the entity is alive.
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

    // Null where the entity is dead or has no such component. Valid until one of this type is added or
    // removed.
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

    std::vector<std::uint32_t> generations_;   // by index; the generation the living or next entity has
    std::vector<std::uint32_t> free_indices_;  // indices of destroyed entities, last one used first
    std::unordered_map<std::type_index, std::unique_ptr<AnySparseSet>> storages_;
};

}  // namespace onggi::ecs
