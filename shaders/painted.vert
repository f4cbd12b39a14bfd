#version 460
// A rectangle of tiles on which an overlay lies that the processor has painted.
layout(push_constant) uniform Push {
    vec2 clip_per_px;
    uint width_px;
};
layout(location = 0) in vec2 position_px;

void main() {
    gl_Position = vec4(position_px * clip_per_px - 1.0, 0.0, 1.0);
}
