// Displays how close a wall is to collapse: a hatch that grows denser and a colour that grows redder, framed
// by pale lines where the warning begins, so that it can be read without colour. Also the cut faces, drawn
// like a technical section: pale, hatched at 45 degrees, with an outline, and a longer line every ten
// millimetres of height as a scale.
#ifndef ONGGI_SHADERS_LOAD_H
#define ONGGI_SHADERS_LOAD_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

CONSTANT float kLoadWarns = 0.6F;
CONSTANT vec3 kLoadRed = vec3(0.50F, 0.10F, 0.03F);
CONSTANT vec3 kLoadDark = vec3(0.045F, 0.008F, 0.002F);
CONSTANT vec3 kLoadPale = vec3(1.0F, 0.88F, 0.66F);

// A width is the change of a value from one pixel to the next.
FORMULA REAL load_past(REAL load) {
    return load - kLoadWarns;
}
FORMULA REAL load_near(REAL load) {
    return clamp(load_past(load) / (1.0F - kLoadWarns), 0.0F, 1.0F);
}
FORMULA REAL load_warned(REAL load) {
    return smoothstep(0.0F, 0.05F, load_past(load));
}
FORMULA REAL load_red(REAL load) {
    return (0.25F + 0.45F * load_near(load)) * load_warned(load);
}
// along: mm along the hatch's own axis.
FORMULA REAL load_dark(REAL load, REAL along, REAL along_width) {
    REAL line = abs(fract(along / 7.0F) - 0.5F);
    REAL from = 0.10F + 0.25F * load_near(load);
    REAL hatch = 1.0F - smoothstep(from, from + max(along_width / 7.0F, 1e-5F), line);
    return hatch * load_warned(load) * 0.85F;
}
FORMULA REAL load_pale(REAL load, REAL load_width) {
    return 1.0F - smoothstep(1.2F, 2.2F, abs(load_past(load)) / max(load_width, 1e-5F));
}
FORMULA COLOUR with_load(COLOUR own, REAL red, REAL dark, REAL pale, COLOUR as_red, COLOUR as_dark,
                         COLOUR as_pale) {
    return mix(mix(mix(own, as_red, red), as_dark, dark), as_pale, pale);
}

FORMULA REAL section_hatch(REAL along, REAL along_width) {
    REAL line = abs(fract(along / 3.0F) - 0.5F);
    return 0.70F + 0.30F * smoothstep(0.12F, 0.12F + max(along_width / 3.0F, 1e-5F), line);
}
// `through`: position between the faces of the wall, 0 to 1.
FORMULA REAL section_border(REAL through, REAL through_width) {
    return mix(0.25F, 1.0F, smoothstep(0.0F, max(1.5F * through_width, 1e-5F), min(through, 1.0F - through)));
}
FORMULA REAL section_scale(REAL up_mm, REAL up_width) {
    REAL mark = abs(fract(up_mm * 0.1F + 0.5F) - 0.5F) * 10.0F;
    return mix(0.35F, 1.0F, smoothstep(0.5F, 1.5F, mark / max(up_width, 1e-4F)));
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif
