// Plays the wheel's sound: runs the synthesiser on an I/O thread with the newest scene. Without a sound
// device it is silent, reports the reason in the status and searches again from time to time.
//
//     SoundOutput sound(make_openal_place());
//     sound.open();                       // main thread
//     sound.play({...});                  // once a frame; wait-free
//     sound.close();                      // fades out
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"
#include "engine/sound/sound_player.h"
#include "engine/sound/spoken_line.h"
#include "engine/sound/synthesiser.h"

namespace onggi::sound {

struct SoundStatus {
    bool is_heard = false;     // a device is playing
    std::string device = {};   // its name
    std::string message = {};  // why there is no device, one line
    std::uint64_t blocks = 0;  // played so far
};

// The I/O thread's work, without the thread: tests call round() with a virtual time.
class SoundWork final : public jobs::IoWork {
  public:
    explicit SoundWork(std::unique_ptr<SoundPlace> place) : place_(std::move(place)) {}

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    // Fades out, which takes up to 150 ms.
    void finish() noexcept override;

    jobs::Mailbox<SoundScene> scene;  // main thread to I/O thread
    // Likewise: the line to speak now, from its beginning; null stops it.
    jobs::Mailbox<std::shared_ptr<const SpokenLine>> line;
    jobs::Mailbox<SoundStatus> status;  // I/O thread to main thread

  private:
    void look_for_a_player(std::int64_t now_ns);
    // Blocks that the device took; an error: it is gone.
    Result<std::size_t> fill(const SoundScene& now);
    void lose(std::int64_t now_ns, const std::string& message);

    std::unique_ptr<SoundPlace> place_;
    std::unique_ptr<SoundPlayer> player_;
    Synthesiser synthesiser_;
    Speaker speaker_;
    std::shared_ptr<const SpokenLine> said_;
    SoundStatus status_;
    std::array<Sample, kBlockFrames> block_{};
    std::int64_t next_look_ns_ = 0;
    std::int64_t last_taken_ns_ = 0;  // when the device last took a block
};

// Every method belongs to the main thread.
class SoundOutput {
  public:
    explicit SoundOutput(std::unique_ptr<SoundPlace> place) : work_(std::move(place)) {}
    ~SoundOutput() { close(); }
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    // Error: the thread cannot start.
    Result<void> open();
    void close() noexcept { thread_.stop(); }
    void play(const SoundScene& scene) noexcept { work_.scene.put(scene); }
    // Speaks the line once over everything else; null: stops speaking.
    void say(const std::shared_ptr<const SpokenLine>& line) noexcept { work_.line.put(line); }
    [[nodiscard]] const SoundStatus& status() noexcept { return work_.status.latest(); }

  private:
    SoundWork work_;
    jobs::IoThread thread_;
};

}  // namespace onggi::sound
