#include "engine/render/photographs.h"

#include <utility>

namespace onggi::render {

Result<const PhotographPair*> Photographs::pair() {
    if (!pair_) {
        auto again = read_();
        if (!again) return again.error();
        pair_ = std::move(*again);
    }
    return static_cast<const PhotographPair*>(&*pair_);
}

void Photographs::let_go() {
    if (read_) pair_.reset();
}

}  // namespace onggi::render
