// The interface of a sound device or a test's player. Called from one I/O thread; may allocate.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "engine/core/result.h"
#include "engine/sound/synthesiser.h"

namespace onggi::sound {

// Blocks queued ahead delay the sound: four blocks of some 10 ms are the least that a thread with normal
// priority can keep filled.
constexpr std::size_t kBlockFrames = 512;
constexpr std::size_t kBlocksAhead = 4;

class SoundPlayer {
  public:
    virtual ~SoundPlayer() = default;  // silent at once

    [[nodiscard]] virtual std::string name() const = 0;
    // Returns the number of blocks that it accepts now, 0 to kBlocksAhead. Error: the device is gone.
    virtual Result<std::size_t> blocks_wanted() = 0;
    // Queues one block. Error: the device is gone.
    virtual Result<void> play(std::span<const Sample, kBlockFrames> block) = 0;
    virtual void pause_ms(int milliseconds) = 0;
};

// Finds and opens a player; blocks for some tens of ms at most. Error: one line that says why there is none.
class SoundPlace {
  public:
    virtual ~SoundPlace() = default;
    virtual Result<std::unique_ptr<SoundPlayer>> open() = 0;
};

}  // namespace onggi::sound
