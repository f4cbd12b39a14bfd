// Views of every screen, as a visit would bring them, for tests and pictures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/screens/page/view.h"

namespace onggi::screens {

struct SampleView {
    std::string name;
    std::shared_ptr<const View> view;
};

struct SampleRequest {
    int width_px = 1280;
    int height_px = 720;
    std::string language = "en";  // of en, ko, ar
    int text_size = 1;
    bool reach = false;
    bool left_hand = false;
    bool scans = false;  // the ring stands on the first target
    bool still = false;
    bool staff = true;  // their panel too
};

// One of each screen and panel, with what it needs.
[[nodiscard]] std::vector<SampleView> sample_views(const SampleRequest& request);
[[nodiscard]] std::shared_ptr<const std::vector<Exhibit>> sample_exhibits();

}  // namespace onggi::screens
