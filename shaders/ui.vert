#version 460
// A vertex of the overlay: converts pixels from the top left of the picture to clip space, and atlas pixels
// to 0..1.
layout(push_constant) uniform Push {
    vec4 per_px;  // xy: clip space per pixel of the picture; zw: one over the atlas's size
};
layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 atlas_px;
layout(location = 2) in vec4 rgba;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 atlas;

void main() {
    colour = rgba;
    atlas = atlas_px * per_px.zw;
    gl_Position = vec4(position_px * per_px.xy - 1.0, 0.0, 1.0);
}
