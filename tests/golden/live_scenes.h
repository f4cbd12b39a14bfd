// The golden moving pictures, and how to draw them. Main thread.
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
    bool fades = false;  // halfway through a cross-fade to the other view
    bool has_overlay = false;

    friend std::ostream& operator<<(std::ostream& out, const LiveScene& scene) { return out << scene.name; }
};

// Returns the third of three frames: the first renders the room, the others draw the changes over it. A
// fading scene takes as many more frames as it needs.
[[nodiscard]] asset::Image draw_live(vk::Device& device, const LiveScene& scene,
                                     const render::RendererDesc& desc);

// Every kind of overlay element: glass, a line, a convex shape and a picture of its atlas.
class SampleOverlay {
  public:
    SampleOverlay();
    SampleOverlay(const SampleOverlay&) = delete;
    SampleOverlay& operator=(const SampleOverlay&) = delete;
    // The first call uploads its picture.
    [[nodiscard]] render::Overlay next();

  private:
    ui::DrawList list_;
    std::vector<ui::Atlas::Upload> uploads_;
    bool has_brought_ = false;
};

}  // namespace onggi::golden
