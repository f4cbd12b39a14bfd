// Runs the systems of a frame, which are free functions, phase by phase, and within a phase in the order of
// their addition. Main thread.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/ecs/registry.h"

namespace onggi::ecs {

// A frame's phases, in running order.
enum class Phase {
    kReceive,  // new snapshots and input become components
    kAnimate,  // camera and lights move
    kExtract,  // collects the renderer's input
};
constexpr std::size_t kPhaseCount = 3;

// Context: a frame's input and output besides the registry (elapsed time, the draw list).
template <typename Context>
class Schedule {
  public:
    using System = void (*)(Registry&, Context&);

    Schedule& add(Phase phase, std::string_view name, System system) {
        phases_[static_cast<std::size_t>(phase)].push_back({name, system});
        return *this;
    }

    void run(Registry& registry, Context& context) const {
        for (const auto& systems : phases_) {
            for (const Entry& entry : systems)
                entry.system(registry, context);
        }
    }

    // The systems in running order, for display and tests.
    [[nodiscard]] std::vector<std::string_view> names() const {
        std::vector<std::string_view> names;
        for (const auto& systems : phases_) {
            for (const Entry& entry : systems)
                names.push_back(entry.name);
        }
        return names;
    }

  private:
    struct Entry {
        std::string_view name;
        System system;
    };
    std::array<std::vector<Entry>, kPhaseCount> phases_;
};

}  // namespace onggi::ecs
