// How near clay is to giving way, as it is shown on it: a hatch that grows denser and a colour that grows
// redder, framed by pale lines where the warning begins. Place and pattern say it without the colour.
// load_pixels.h of engine/render is the same in C++.
const float kLoadWarns = 0.6;

// along: mm along the hatch's own axis.
vec3 with_load(vec3 colour, float load, float along) {
    float near = clamp((load - kLoadWarns) / (1.0 - kLoadWarns), 0.0, 1.0);
    float warned = smoothstep(0.0, 0.05, load - kLoadWarns);
    colour = mix(colour, vec3(0.50, 0.10, 0.03), (0.25 + 0.45 * near) * warned);
    float line = abs(fract(along / 7.0) - 0.5);
    float width = fwidth(along / 7.0);
    float hatch = 1.0 - smoothstep(0.10 + 0.25 * near, 0.10 + 0.25 * near + width, line);
    colour = mix(colour, vec3(0.045, 0.008, 0.002), hatch * warned * 0.85);
    float frame_line = abs(load - kLoadWarns) / max(fwidth(load), 1e-5);
    return mix(vec3(1.0, 0.88, 0.66), colour, smoothstep(1.2, 2.2, frame_line));
}
