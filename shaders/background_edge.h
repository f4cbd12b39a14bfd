// Pictures wider than the photograph of the room, for a tall pot: the room continues as its mirror image and
// fades to dark, horizontally and vertically alike.
#ifndef ONGGI_SHADERS_PLATE_EDGE_H
#define ONGGI_SHADERS_PLATE_EDGE_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// The mirrored coordinate in the photograph, for places up to one photograph's width outside.
FORMULA REAL mirrored(REAL at) {
    return 1.0F - abs(1.0F - abs(at));
}
// Distance outside the photograph, scaled for left_beside().
FORMULA REAL beside(REAL at) {
    return max(abs(at - 0.5F) - 0.5F, 0.0F) * (1.0F / 0.06F);
}
// The fraction that remains of the encoded value (about the square root of the light). A tenth of the
// photograph further out little is left, before the mirroring becomes noticeable.
FORMULA REAL left_beside(REAL across, REAL down) {
    return 1.0F / (1.0F + across * across + down * down);
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif
