// Reads the backgrounds of another shape of picture beside the frame: decoding a pair of photographs takes as
// long as some frames. Main thread, except where it says otherwise.
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

    // What came of a request: the backgrounds by their camera's name, and a line for each that could not be
    // read.
    struct Loaded {
        std::vector<std::pair<std::string, std::shared_ptr<const render::Background>>> backgrounds;
        std::vector<std::string> lacks;
    };

    // Begins to read the backgrounds of these cameras of the workshop's, on a thread of its own that lasts as
    // long as that. Error: kFailed when no thread can be made. Precondition: not busy.
    Result<void> load(std::shared_ptr<const Workshop> workshop, std::vector<BackgroundCamera> cameras);
    [[nodiscard]] bool busy() const { return thread_.running(); }
    // Once all of them have been read, or refused; then it is no longer busy.
    [[nodiscard]] std::optional<Loaded> take();

  private:
    // The loader's thread.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

    std::shared_ptr<const Workshop> workshop_;
    std::vector<BackgroundCamera> cameras_;
    // The loader's thread's, until it says that it is done.
    std::size_t next_ = 0;
    Loaded loaded_;
    std::atomic<bool> done_{false};
    jobs::IoThread thread_;
};

}  // namespace onggi::wheel
