// The room outside its photograph, see background_edge.h.
#include "background_edge.h"

vec2 mirrored(vec2 at) {
    return vec2(mirrored(at.x), mirrored(at.y));
}
float left_beside(vec2 at) {
    return left_beside(beside(at.x), beside(at.y));
}
