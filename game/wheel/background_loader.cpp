#include "game/wheel/background_loader.h"

namespace onggi::wheel {

Result<void> BackgroundLoader::load(std::shared_ptr<const Workshop> workshop,
                                    std::vector<BackgroundCamera> cameras) {
    workshop_ = std::move(workshop);
    cameras_ = std::move(cameras);
    next_ = 0;
    loaded_ = {};
    done_.store(false, std::memory_order_relaxed);
    return thread_.start(*this, "backgrounds");
}

std::optional<BackgroundLoader::Loaded> BackgroundLoader::take() {
    if (!busy() || !done_.load(std::memory_order_acquire)) return std::nullopt;
    thread_.stop();
    return std::exchange(loaded_, {});
}

std::int64_t BackgroundLoader::round(std::int64_t /*now_ns*/) noexcept {
    constexpr std::int64_t kUntilStoppedNs = 3'600'000'000'000;
    if (next_ < cameras_.size()) {
        const BackgroundCamera& camera = cameras_[next_++];
        auto background = load_background(*workshop_, camera);
        if (background) {
            loaded_.backgrounds.emplace_back(camera.name, std::move(*background));
        } else {
            loaded_.lacks.push_back(background.error().message);
        }
    }
    if (next_ < cameras_.size()) return 0;
    done_.store(true, std::memory_order_release);
    return kUntilStoppedNs;
}

}  // namespace onggi::wheel
