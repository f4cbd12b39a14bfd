// Moving pictures that are kept, and how one of them is drawn. Main thread.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/render/overlay.h"
#include "engine/render/renderer_desc.h"
#include "engine/vk/device.h"
#include "tests/golden/golden_scenes.h"

namespace onggi::golden {

struct LiveScene {
    std::string name;
    std::string pot;  // one of the golden scenes
    double evening = 0.0;
    bool fades = false;  // the other view has half faded in
    bool has_overlay = false;

    friend std::ostream& operator<<(std::ostream& out, const LiveScene& scene) { return out << scene.name; }
};

// The third of three frames: in the first the room is made, in the others what has changed is laid over. One
// that fades: as many more as it takes.
[[nodiscard]] asset::Image draw_live(vk::Device& device, const LiveScene& scene,
                                     const render::RendererDesc& desc);

// Every kind of thing that an overlay draws: glass, a line, a convex shape and a picture of its atlas.
class SampleOverlay {
  public:
    SampleOverlay();
    SampleOverlay(const SampleOverlay&) = delete;
    SampleOverlay& operator=(const SampleOverlay&) = delete;
    // Brings its picture the first time it is asked for.
    [[nodiscard]] render::Overlay next();

  private:
    ui::DrawList list_;
    std::vector<ui::Atlas::Upload> uploads_;
    bool has_brought_ = false;
};

}  // namespace onggi::golden
