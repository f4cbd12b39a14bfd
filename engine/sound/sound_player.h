// Something that plays samples: a sound device, or a test's. Called from one I/O thread; may allocate.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "engine/core/result.h"
#include "engine/sound/synthesiser.h"

namespace onggi::sound {

// Half of what is played ahead is heard later than it was meant: four blocks of some 10 ms are as little as
// an ordinary thread can keep filled.
constexpr std::size_t kBlockFrames = 512;
constexpr std::size_t kBlocksAhead = 4;

class SoundPlayer {
  public:
    virtual ~SoundPlayer() = default;  // silent at once

    [[nodiscard]] virtual std::string name() const = 0;
    // How many blocks it would take now, 0 to kBlocksAhead. Error: the device is gone.
    virtual Result<std::size_t> blocks_wanted() = 0;
    // Plays one block after those it has. Error: the device is gone.
    virtual Result<void> play(std::span<const Sample, kBlockFrames> block) = 0;
    virtual void pause_ms(int milliseconds) = 0;
};

// Finds and opens one; never blocks for more than some tens of ms. Error: one line that says why there is
// none.
class SoundPlace {
  public:
    virtual ~SoundPlace() = default;
    virtual Result<std::unique_ptr<SoundPlayer>> open() = 0;
};

}  // namespace onggi::sound
