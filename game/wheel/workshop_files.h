// The photographed workshop on disk: cameras.json, light.json, plates/NAME_key.jpg and
// plates/NAME_ambient.jpg (assets/workshop/README.md describes them). Any thread but the haptic one; blocks.
// mm, rad, linear light.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"
#include "engine/math/math.h"
#include "engine/render/camera.h"
#include "engine/render/scene.h"

namespace onggi::wheel {

// The views of a visitor. Camera names begin with the view's name.
enum class View {
    kThrowing,   // throw_...: pot and hands
    kLookingIn,  // look_in_...: from above, into the pot
};
[[nodiscard]] std::string_view name_of(View view);

// A fixed camera, and the size of its backgrounds.
struct BackgroundCamera {
    std::string name;
    render::Camera camera;
    int width_px = 0;
    int height_px = 0;
};

// The light on a pot in this room, without the backgrounds themselves.
struct Workshop {
    std::filesystem::path folder;
    std::vector<BackgroundCamera> cameras;  // larger variants are listed only if their photographs exist
    render::DirectionalLight key;
    std::array<vec3, 9> irradiance{};  // see render::sky_irradiance()
    render::Environment environment;

    // The camera of this view with the nearest aspect ratio, and among equals with the nearest size; null if
    // the view has no camera.
    [[nodiscard]] const BackgroundCamera* camera_for(View view, int width_px, int height_px) const;
};

// Reads both JSON files. Bad input: a file that is missing, too large or not JSON, or a field that is missing
// or out of range; the message names file and field. The result has at least one throwing camera.
[[nodiscard]] Result<Workshop> load_workshop(const std::filesystem::path& folder);

// The backgrounds of one camera. Bad input: a file that is missing or damaged, or differs in size from
// cameras.json.
[[nodiscard]] Result<std::shared_ptr<const render::Background>> load_background(
    const Workshop& workshop, const BackgroundCamera& camera);

// Placement of the room's photograph in the picture: screens leave it more or less room. Any thread; pure.

struct Framing {
    dvec2 shift{0.0};   // of the picture, in half pictures, x right and y down
    double zoom = 1.0;  // of the background about its middle, applied before the shift

    friend bool operator==(const Framing&, const Framing&) = default;
};

// A background's camera with the framing applied.
[[nodiscard]] inline render::Camera framed(const render::Camera& camera, const Framing& framing) {
    render::Camera shown = render::zoomed(camera, framing.zoom);
    shown.lens_shift = vec2(framing.shift);
    return shown;
}

// Loads the backgrounds for another aspect ratio in the background: decoding a pair of photographs takes as
// long as several frames. Main thread, except where it says otherwise.

class BackgroundLoader final : private jobs::IoWork {
  public:
    BackgroundLoader() = default;
    ~BackgroundLoader() override { thread_.stop(); }

    // Result of a request: the backgrounds by camera name, and one line for each that could not be read.
    struct Loaded {
        std::vector<std::pair<std::string, std::shared_ptr<const render::Background>>> backgrounds;
        std::vector<std::string> lacks;
    };

    // Starts to read the backgrounds of these workshop cameras, on a thread of its own. Error: kFailed if no
    // thread can be started. Precondition: not busy.
    Result<void> load(std::shared_ptr<const Workshop> workshop, std::vector<BackgroundCamera> cameras);
    [[nodiscard]] bool busy() const { return thread_.running(); }
    // Returns the result once every background was read or refused; then busy() is false. Empty before that.
    [[nodiscard]] std::optional<Loaded> take();

  private:
    // Runs on the loader's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

    std::shared_ptr<const Workshop> workshop_;
    std::vector<BackgroundCamera> cameras_;
    // Owned by the loader's thread until done_ is set.
    std::size_t next_ = 0;
    Loaded loaded_;
    std::atomic<bool> done_{false};
    jobs::IoThread thread_;
};

}  // namespace onggi::wheel
