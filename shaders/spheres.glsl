// All moving spheres, always evaluated and unrolled; unused ones are far below everything and have next to no
// effect. A loop over their count would cost more: llvmpipe assumes that the index differs between pixels,
// and fetches the values pixel by pixel. Needs frame.glsl.
#include "surface.h"

// Fraction of the key light that passes them on its way to p, 0 to 1.
float past_spheres(vec3 p) {
    vec3 l = frame.key_direction.xyz;
    float tangent = frame.key_direction.w;
    return past_sphere(frame.spheres[0], l, tangent, p) * past_sphere(frame.spheres[1], l, tangent, p) *
           past_sphere(frame.spheres[2], l, tangent, p) * past_sphere(frame.spheres[3], l, tangent, p);
}

// Fraction of the sky that they leave visible.
float sky_past_spheres(vec3 p, vec3 n) {
    return sky_past_sphere(frame.spheres[0], p, n) * sky_past_sphere(frame.spheres[1], p, n) *
           sky_past_sphere(frame.spheres[2], p, n) * sky_past_sphere(frame.spheres[3], p, n);
}
