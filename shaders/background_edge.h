// Where the picture is wider than the photograph of the room, for a tall pot: the room goes on as its own
// mirror image, and into the dark. Across and down alike.
#ifndef ONGGI_SHADERS_PLATE_EDGE_H
#define ONGGI_SHADERS_PLATE_EDGE_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// The place in the photograph to look at, for a place up to one photograph beside it.
FORMULA REAL mirrored(REAL at) {
    return 1.0F - abs(1.0F - abs(at));
}
// How far outside.
FORMULA REAL beside(REAL at) {
    return max(abs(at - 0.5F) - 0.5F, 0.0F) * (1.0F / 0.06F);
}
// How much of the values of the screen is left there, about the root of the light: little a tenth of the
// photograph further on, where the mirror would be seen to be one.
FORMULA REAL left_beside(REAL across, REAL down) {
    return 1.0F / (1.0F + across * across + down * down);
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif
