// The recordings of spoken lines: FOLDER/LANGUAGE/KEY.wav, read on a background thread when they are due. A
// missing recording is silent; an unreadable one is silent and logged once.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"
#include "engine/sound/spoken_line.h"

namespace onggi::app {

class KioskVoice final : private jobs::IoWork {
  public:
    // An empty folder means no speech.
    explicit KioskVoice(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~KioskVoice() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Main thread. Requests the line that is due; repeating the request has no effect. Returns true if it
    // changed.
    bool ask(std::string_view language, std::string_view key);
    // Main thread. The line to play; null until it is read or if it has no recording.
    [[nodiscard]] std::shared_ptr<const sound::SpokenLine> line() noexcept;
    // The last reading error, in one line, once; may be empty.
    [[nodiscard]] std::string news();

    // Reads the recording of a line; null if there is none. `trouble` receives the error if it cannot be
    // read.
    [[nodiscard]] static std::shared_ptr<const sound::SpokenLine> read(const std::filesystem::path& folder,
                                                                       const std::string& name,
                                                                       std::string& trouble);

  private:
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

    struct Found {
        std::string name;
        std::shared_ptr<const sound::SpokenLine> line;
        std::string trouble;
    };
    std::filesystem::path folder_;
    std::string asked_;           // by the main thread
    std::set<std::string> told_;  // errors that the main thread has reported
    std::string read_;            // by the I/O thread
    jobs::Mailbox<std::shared_ptr<const std::string>> requests_;
    jobs::Mailbox<std::shared_ptr<const Found>> found_;
    jobs::IoThread thread_;
};

}  // namespace onggi::app
