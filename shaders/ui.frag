#version 460
// A pixel of the overlay, already encoded for the screen and premultiplied: a shaded box, or (with
// ONGGI_PICTURE) a picture of the atlas. Two programs, because a texture costs as much as five boxes on a
// processor.
#ifdef ONGGI_PICTURE
layout(set = 0, binding = 0) uniform sampler2D pictures;
#endif
layout(location = 0) in vec4 colour;
layout(location = 1) in vec2 atlas;
layout(location = 0) out vec4 result;

void main() {
#ifdef ONGGI_PICTURE
    result = colour * texture(pictures, atlas);
#else
    result = colour;
#endif
}
