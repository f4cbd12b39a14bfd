// Displays the load on the lathe, see load.h.
#include "load.h"

// along: mm along the hatch's own axis.
vec3 with_load(vec3 colour, float load, float along) {
    return with_load(colour, load_red(load), load_dark(load, along, fwidth(along)),
                     load_pale(load, fwidth(load)), kLoadRed, kLoadDark, kLoadPale);
}
