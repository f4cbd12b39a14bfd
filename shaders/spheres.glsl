// All of the moving spheres, always, unrolled: those that are not there lie far below everything, and are next
// to nothing. A loop up to their count would cost more: llvmpipe takes an index for one that differs from pixel
// to pixel, and fetches what lies there pixel by pixel. Needs frame.glsl.
#include "surface.h"

// How much of the key light passes them on its way to p, 0 to 1.
float past_spheres(vec3 p) {
    vec3 l = frame.key_direction.xyz;
    float tangent = frame.key_direction.w;
    return past_sphere(frame.spheres[0], l, tangent, p) * past_sphere(frame.spheres[1], l, tangent, p) *
           past_sphere(frame.spheres[2], l, tangent, p) * past_sphere(frame.spheres[3], l, tangent, p);
}

// How much of the sky they leave.
float sky_past_spheres(vec3 p, vec3 n) {
    return sky_past_sphere(frame.spheres[0], p, n) * sky_past_sphere(frame.spheres[1], p, n) *
           sky_past_sphere(frame.spheres[2], p, n) * sky_past_sphere(frame.spheres[3], p, n);
}
