// The photographs of a background on their way to the renderer. There they stay; what lies here is let go,
// for it is as much again: 7 MB a background of 1280x720. Made by any thread, then of the main thread.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/result.h"

namespace onggi::render {

// With the key light and without it, of one size.
struct PhotographPair {
    asset::Image key;
    asset::Image ambient;
};

class Photographs {
  public:
    using Read = std::function<Result<PhotographPair>()>;

    // `read` gives the same pair once more, where a lost device wants it again; without it they stay here.
    explicit Photographs(PhotographPair pair, Read read = {})
        : pair_(std::move(pair)),
          read_(std::move(read)) {}

    // The pair, read again if it was let go: some tens of ms. It stays until the next call or let_go().
    // Errors: those of `read`.
    [[nodiscard]] Result<const PhotographPair*> pair();
    // The renderer has them now.
    void let_go();
    [[nodiscard]] bool are_here() const { return pair_.has_value(); }

  private:
    std::optional<PhotographPair> pair_;
    Read read_;
};

}  // namespace onggi::render
