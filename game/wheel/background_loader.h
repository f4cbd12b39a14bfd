// Loads the backgrounds for another aspect ratio in the background: decoding a pair of photographs takes as
// long as several frames. Main thread, except where it says otherwise.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/jobs/io_thread.h"
#include "game/wheel/workshop_files.h"

namespace onggi::wheel {

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
