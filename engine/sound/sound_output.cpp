#include "engine/sound/sound_output.h"

#include <utility>

namespace onggi::sound {
namespace {

constexpr std::int64_t kMs = 1'000'000;              // ns
constexpr std::int64_t kRestNs = 5 * kMs;            // half a block
constexpr std::int64_t kLookAgainNs = 30'000 * kMs;  // finds a loudspeaker that is plugged in late
constexpr int kFadeRounds = 30;
constexpr int kFadePauseMs = 5;

}  // namespace

std::int64_t SoundWork::round(std::int64_t now_ns) noexcept {
    if (!player_ && now_ns >= next_look_ns_) look_for_a_player(now_ns);
    if (!player_) return next_look_ns_ - now_ns;
    if (!fill(scene.latest())) lose(now_ns, "the sound device is gone");
    return kRestNs;
}

void SoundWork::look_for_a_player(std::int64_t now_ns) {
    auto opened = place_->open();
    if (!opened) return lose(now_ns, opened.error().message);
    player_ = std::move(opened).value();
    status_.is_heard = true;
    status_.device = player_->name();
    status_.message.clear();
    status.put(status_);
}

bool SoundWork::fill(const SoundScene& now) {
    const auto wanted = player_->blocks_wanted();
    if (!wanted) return false;
    if (const auto& newest = line.latest(); newest != said_) speaker_.say(said_ = newest);
    for (std::size_t block = 0; block < *wanted; ++block) {
        synthesiser_.render(now, block_);
        speaker_.mix(block_, now.volume);
        if (!player_->play(block_)) return false;
        ++status_.blocks;
    }
    if (*wanted > 0) status.put(status_);
    return true;
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
