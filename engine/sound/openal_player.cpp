#include "engine/sound/openal_player.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include "engine/core/list_folder.h"

// From <AL/alext.h>, whose location differs between releases.
#ifndef ALC_CONNECTED
#define ALC_CONNECTED 0x313
#endif

namespace onggi::sound {
namespace {

namespace fs = std::filesystem;

struct CloseDevice {
    void operator()(ALCdevice* device) const noexcept { alcCloseDevice(device); }
};
struct DestroyContext {
    void operator()(ALCcontext* context) const noexcept {
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context);
    }
};
using Device = std::unique_ptr<ALCdevice, CloseDevice>;
using Context = std::unique_ptr<ALCcontext, DestroyContext>;

class OpenAlPlayer final : public SoundPlayer {
  public:
    OpenAlPlayer(Device device, Context context) : device_(std::move(device)), context_(std::move(context)) {
        alGenSources(1, &source_);
        alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
        alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
        free_.assign(buffers_.begin(), buffers_.end());
    }
    ~OpenAlPlayer() override {
        alSourceStop(source_);
        alDeleteSources(1, &source_);
        alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    }
    OpenAlPlayer(const OpenAlPlayer&) = delete;
    OpenAlPlayer& operator=(const OpenAlPlayer&) = delete;

    [[nodiscard]] std::string name() const override {
        const ALCchar* name = alcGetString(device_.get(), ALC_DEVICE_SPECIFIER);
        return name == nullptr ? "OpenAL" : name;
    }

    Result<std::size_t> blocks_wanted() override {
        ALCint connected = ALC_TRUE;
        if (alcIsExtensionPresent(device_.get(), "ALC_EXT_disconnect") == ALC_TRUE)
            alcGetIntegerv(device_.get(), ALC_CONNECTED, 1, &connected);
        if (connected != ALC_TRUE) return failed("the sound device is gone");
        ALint played = 0;
        alGetSourcei(source_, AL_BUFFERS_PROCESSED, &played);
        for (; played > 0; --played) {
            ALuint buffer = 0;
            alSourceUnqueueBuffers(source_, 1, &buffer);
            if (alGetError() != AL_NO_ERROR) return failed("the sound device does not return played buffers");
            free_.push_back(buffer);
        }
        return free_.size();
    }

    Result<void> play(std::span<const Sample, kBlockFrames> block) override {
        if (free_.empty()) return {};
        constexpr float kLoudest = 32767.0F;
        for (std::size_t frame = 0; frame < kBlockFrames; ++frame) {
            pcm_[2 * frame] = static_cast<std::int16_t>(block[frame].left * kLoudest);
            pcm_[2 * frame + 1] = static_cast<std::int16_t>(block[frame].right * kLoudest);
        }
        const ALuint buffer = free_.back();
        free_.pop_back();
        alBufferData(buffer, AL_FORMAT_STEREO16, pcm_.data(), static_cast<ALsizei>(sizeof(pcm_)),
                     static_cast<ALsizei>(kSampleRateHz));
        alSourceQueueBuffers(source_, 1, &buffer);
        ALint state = AL_PLAYING;
        alGetSourcei(source_, AL_SOURCE_STATE, &state);
        // At the start, and after a late thread let the queue run empty.
        if (state != AL_PLAYING && free_.empty()) alSourcePlay(source_);
        if (const ALenum error = alGetError(); error != AL_NO_ERROR)
            return failed(fmt::format("the sound device refuses a block: OpenAL error {:#x}", error));
        return {};
    }

    void pause_ms(int milliseconds) override { poll(nullptr, 0, milliseconds); }

  private:
    Device device_;
    Context context_;
    ALuint source_ = 0;
    std::array<ALuint, kBlocksAhead> buffers_{};
    std::vector<ALuint> free_;
    std::array<std::int16_t, 2 * kBlockFrames> pcm_{};
};

class OpenAlPlace final : public SoundPlace {
  public:
    Result<std::unique_ptr<SoundPlayer>> open() override {
        if (const std::string obstacle = why_no_sound(); !obstacle.empty()) return system_lacks(obstacle);
        Device device(alcOpenDevice(nullptr));
        if (device == nullptr) return system_lacks("expected to open the default device, found it refuses");
        const std::array<ALCint, 3> request{ALC_FREQUENCY, static_cast<ALCint>(kSampleRateHz), 0};
        Context context(alcCreateContext(device.get(), request.data()));
        if (context == nullptr || alcMakeContextCurrent(context.get()) != ALC_TRUE)
            return system_lacks("expected a context on the default device, found none");
        return std::unique_ptr<SoundPlayer>(
            std::make_unique<OpenAlPlayer>(std::move(device), std::move(context)));
    }
};

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

bool has_a_card(const fs::path& folder) {
    const std::vector<fs::path> devices = list_folder(folder).entries;
    return std::any_of(devices.begin(), devices.end(), [](const fs::path& device) {
        const std::string name = device.filename().string();
        return name.starts_with("pcm") && name.ends_with("p");  // p: playback
    });
}

// PulseAudio's socket, also PipeWire's stand-in for it, or PipeWire's own, which OpenAL reaches through ALSA.
bool has_a_server() {
    if (is_set("PULSE_SERVER")) return true;
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
    std::error_code error;
    return runtime != nullptr && (fs::exists(fs::path(runtime) / "pulse/native", error) ||
                                  fs::exists(fs::path(runtime) / "pipewire-0", error));
}

}  // namespace

std::unique_ptr<SoundPlace> make_openal_place() {
    return std::make_unique<OpenAlPlace>();
}

// OpenAL's own list has a device where there is none
// (findings/openal-lists-a-device-where-there-is-no-sound.sh).
std::string why_no_sound(const fs::path& cards) {
    if (is_set("ALSOFT_DRIVERS") || has_a_server() || has_a_card(cards)) return {};
    return "expected a sound card or a sound server, found neither";
}

}  // namespace onggi::sound
