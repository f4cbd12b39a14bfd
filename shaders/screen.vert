#version 460
// One triangle over the whole target; position is 0..1 from the top left.
layout(location = 0) out vec2 position;

void main() {
    position = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
    gl_Position = vec4(position * 2.0 - 1.0, 1.0, 1.0);
}
