// The screen's transfer function, IEC 61966-2-1 (sRGB), one text for devices and for the processor: two
// square roots instead of a power, whose results differ between them. Within 0.1 of 255 of the standard; the
// inverse within 0.3.
#ifndef ONGGI_SHADERS_TRANSFER_H
#define ONGGI_SHADERS_TRANSFER_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// Constants of the standard: the linear part near black.
CONSTANT float kTransferLine = 12.92F;
CONSTANT float kTransferDark = 0.0031308F;
CONSTANT float kTransferDarkShown = 0.04045F;

// Encodes light of 0 to 1. Above the linear part: the minimax fit of 1, x^1/2, x^1/4 and x to 1.055 x^(1/2.4)
// - 0.055.
FORMULA REAL transferred(REAL light) {
    REAL root = sqrt(light);
    REAL bright = 0.8337021F * root + 0.2981428F * sqrt(root) - 0.0552913F * light - 0.0769095F;
    return select(light <= kTransferDark, kTransferLine * light, bright);
}

// The inverse; the best fit of a fourth-degree polynomial to ((x + 0.055) / 1.055)^2.4.
FORMULA REAL untransferred(REAL value) {
    REAL bright =
        (((-0.0888111F * value + 0.4733712F) * value + 0.5917405F) * value + 0.0222824F) * value + 0.0013236F;
    return select(value <= kTransferDarkShown, value * (1.0F / kTransferLine), bright);
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif
