// The recordings that a kiosk speaks: FOLDER/LANGUAGE/KEY.wav, read on a thread of their own when they are
// due. A recording that is missing is silence; one that cannot be read is silence and a line for the log,
// once.
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
    // An empty folder: nothing is ever spoken.
    explicit KioskVoice(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~KioskVoice() override { stop(); }

    Result<void> start();
    void stop() noexcept { thread_.stop(); }

    // Main thread. What is due now; the same again changes nothing. True when it is another than before.
    bool ask(std::string_view language, std::string_view key);
    // Main thread. The line to be heard now: null until it is read, and where there is none.
    [[nodiscard]] std::shared_ptr<const sound::SpokenLine> line() noexcept;
    // What could not be read, one line, once; empty: nothing.
    [[nodiscard]] std::string news();

    // The recording of a line; null where there is none. `trouble` says what is wrong with one that is there.
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
    std::string asked_;           // main thread
    std::set<std::string> told_;  // main thread: troubles
    std::string read_;            // the I/O thread
    jobs::Mailbox<std::shared_ptr<const std::string>> requests_;
    jobs::Mailbox<std::shared_ptr<const Found>> found_;
    jobs::IoThread thread_;
};

}  // namespace onggi::app
