#include "engine/sound/sound_output.h"

#include <utility>

namespace onggi::sound {
namespace {

constexpr std::int64_t kMs = 1'000'000;              // ns
constexpr std::int64_t kRestNs = 5 * kMs;            // half a block
constexpr std::int64_t kLookAgainNs = 30'000 * kMs;  // finds a loudspeaker that is plugged in late
// A sound server that ended leaves a device that is connected and takes nothing
// (findings/openal-plays-on-after-the-end-of-pipewire.sh). A block lasts 10 ms.
constexpr std::int64_t kStuckNs = 2'000 * kMs;
constexpr int kFadeRounds = 30;
constexpr int kFadePauseMs = 5;

}  // namespace

std::int64_t SoundWork::round(std::int64_t now_ns) noexcept {
    if (!player_ && now_ns >= next_look_ns_) look_for_a_player(now_ns);
    if (!player_) return next_look_ns_ - now_ns;
    const auto taken = fill(scene.latest());
    if (!taken) {
        lose(now_ns, taken.error().message);
    } else if (*taken > 0) {
        last_taken_ns_ = now_ns;
    } else if (now_ns - last_taken_ns_ > kStuckNs) {
        lose(now_ns, "the sound device takes no more sound");
    }
    return kRestNs;
}

void SoundWork::look_for_a_player(std::int64_t now_ns) {
    auto opened = place_->open();
    if (!opened) return lose(now_ns, opened.error().message);
    player_ = std::move(opened).value();
    last_taken_ns_ = now_ns;
    status_.is_heard = true;
    status_.device = player_->name();
    status_.message.clear();
    status.put(status_);
}

Result<std::size_t> SoundWork::fill(const SoundScene& now) {
    const auto wanted = player_->blocks_wanted();
    if (!wanted) return wanted;
    if (const auto& newest = line.latest(); newest != said_) speaker_.say(said_ = newest);
    for (std::size_t block = 0; block < *wanted; ++block) {
        synthesiser_.render(now, block_);
        speaker_.mix(block_, now.volume);
        if (const auto played = player_->play(block_); !played) return played.error();
        ++status_.blocks;
    }
    if (*wanted > 0) status.put(status_);
    return wanted;
}

void SoundWork::lose(std::int64_t now_ns, const std::string& message) {
    player_.reset();
    next_look_ns_ = now_ns + kLookAgainNs;
    status_.is_heard = false;
    status_.device.clear();
    status_.message = message;
    status.put(status_);
}

void SoundWork::finish() noexcept {
    if (!player_) return;
    SoundScene silence = scene.latest();
    silence.volume = 0.0;
    for (int round = 0; round < kFadeRounds && fill(silence); ++round)
        player_->pause_ms(kFadePauseMs);
    player_.reset();
}

Result<void> SoundOutput::open() {
    if (thread_.running()) return {};
    return thread_.start(work_, "onggi-sound");
}

}  // namespace onggi::sound
