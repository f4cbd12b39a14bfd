// The voice of the kiosk: lines that are spoken one after the other. A line is a recording,
// FOLDER/LANGUAGE/KEY.wav, where the museum has made one, else synthetic speech. A background thread reads or
// makes it when it is due. What fails is silent and logged once.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"
#include "engine/sound/headphones.h"
#include "engine/sound/speech_program.h"
#include "engine/sound/spoken_line.h"
#include "game/kiosk/config.h"

namespace onggi::app {

struct SaidLine {
    std::string language;    // code
    std::string key;         // of its recording; empty: it has none
    std::string text;        // for synthetic speech; empty: only a recording
    bool is_urgent = false;  // replaces what is being said and what waits

    friend bool operator==(const SaidLine&, const SaidLine&) = default;
};

class KioskVoice final : private jobs::IoWork {
  public:
    // As sound::synthesise(), for a language and a text.
    using Synthesise = std::function<Result<sound::SpokenLine>(
        const std::string& language, const std::string& text, const std::function<bool()>& is_wanted)>;

    // An empty folder means no recordings, a null function no synthetic speech.
    KioskVoice(std::filesystem::path folder, Synthesise synthesise, bool listens_for_headphones = false)
        : folder_(std::move(folder)),
          synthesise_(std::move(synthesise)),
          listens_(listens_for_headphones) {}
    ~KioskVoice() override { stop(); }

    // Starts no thread if there is nothing to speak with.
    Result<void> start();
    void stop() noexcept;

    [[nodiscard]] bool has_recordings() const { return !folder_.empty(); }
    [[nodiscard]] bool can_synthesise() const { return synthesise_ != nullptr; }
    // The rest belongs to the main thread.

    // A line waits for those before it, unless it is urgent. The oldest of too many is dropped.
    void say(SaidLine line);
    void hush();
    // Once a frame: begins and ends lines by their length.
    void pass_time(double now_s);
    // The line to play now; null between lines.
    [[nodiscard]] const std::shared_ptr<const sound::SpokenLine>& line() const { return line_; }
    // Something is being said or waits.
    [[nodiscard]] bool speaks() const { return said_ || !waiting_.empty(); }
    // False if the constructor's `listens_for_headphones` was.
    [[nodiscard]] bool headphones_are_in() noexcept { return headphones_in_.latest(); }
    // The last error, in one line, once; may be empty.
    [[nodiscard]] std::string news();

  private:
    struct Request {
        std::uint64_t number = 0;
        SaidLine line;
    };
    struct Answer {
        std::uint64_t number = 0;
        std::shared_ptr<const sound::SpokenLine> line;
        std::string trouble;
    };

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}
    [[nodiscard]] Answer answer(const Request& request, std::int64_t now_ns);
    void begin_next();

    std::filesystem::path folder_;
    Synthesise synthesise_;
    bool listens_ = false;
    // The main thread's.
    std::deque<SaidLine> waiting_;
    std::optional<SaidLine> said_;
    std::uint64_t number_ = 0;  // of the newest request
    std::shared_ptr<const sound::SpokenLine> line_;
    double ends_s_ = 0.0;
    std::set<std::string> told_;  // errors that were reported
    // The I/O thread's.
    std::uint64_t answered_ = 0;
    int failures_ = 0;  // in a row
    std::int64_t rests_until_ns_ = 0;
    std::int64_t listens_ns_ = 0;  // next
    sound::Headphones headphones_;

    std::atomic<bool> stops_ = false;
    jobs::Mailbox<std::shared_ptr<const Request>> requests_;
    jobs::Mailbox<std::shared_ptr<const Answer>> answers_;
    jobs::Mailbox<bool> headphones_in_;
    jobs::IoThread thread_;
};

constexpr const char* kNoSpeechProgram =
    "expected espeak-ng for the speech that [sound] asks for, found none";

// The voice that the settings ask for; `lack` receives a line if it lacks what they need.
[[nodiscard]] std::unique_ptr<KioskVoice> make_voice(const kiosk::Config& config, std::string& lack);

}  // namespace onggi::app
