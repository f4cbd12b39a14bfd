// Where the picture is wider than the photograph of the room, for a tall pot: the room goes on as its own mirror
// image, and into the dark.

// The place in the photograph to look at, for a place up to one photograph beside it.
vec2 mirrored(vec2 at) {
    return 1.0 - abs(1.0 - abs(at));
}

// How much of the values of the screen is left there, about the root of the light: little a tenth of the
// photograph further on, where the mirror would be seen to be one.
float left_beside(vec2 at) {
    vec2 beside = max(abs(at - 0.5) - 0.5, 0.0) * (1.0 / 0.06);
    return 1.0 / (1.0 + dot(beside, beside));
}
