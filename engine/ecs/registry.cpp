#include "engine/ecs/registry.h"

namespace onggi::ecs {

Entity Registry::create() {
    if (free_indices_.empty()) {
        generations_.push_back(0);
        return {static_cast<std::uint32_t>(generations_.size() - 1), 0};
    }
    const std::uint32_t index = free_indices_.back();
    free_indices_.pop_back();
    return {index, generations_[index]};
}

void Registry::destroy(Entity entity) {
    if (!alive(entity)) return;
    for (auto& [type, storage] : storages_)
        storage->erase(entity);
    // The old identifier is now dead; the next entity at this index has another generation.
    ++generations_[entity.index];
    free_indices_.push_back(entity.index);
}

bool Registry::alive(Entity entity) const {
    return entity.index < generations_.size() && generations_[entity.index] == entity.generation;
}

}  // namespace onggi::ecs
