// Beside the photograph of the room, see plate_edge.h.
#include "plate_edge.h"

vec2 mirrored(vec2 at) {
    return vec2(mirrored(at.x), mirrored(at.y));
}
float left_beside(vec2 at) {
    return left_beside(beside(at.x), beside(at.y));
}
