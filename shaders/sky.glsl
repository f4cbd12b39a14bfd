// The sky of this frame, see sky.h. Needs frame.glsl.
#include "sky.h"

// Returns the radiance from a direction, blurred by a surface of this roughness.
vec3 sky_radiance(vec3 d, float roughness) {
    vec3 radiance = mix(frame.sky_horizon.rgb, d.y > 0.0 ? frame.sky_zenith.rgb : frame.sky_nadir.rgb,
                        sky_height(d.y));
    for (int i = 0; i < kPanels; ++i) {
        float s = frame.panel_direction[i].w;
        radiance += frame.panel_radiance[i].rgb *
                    panel_fraction(s, panel_seen_through(s, roughness), dot(frame.panel_direction[i].xyz, d));
    }
    return radiance;
}

// Returns the sky's light that a white surface facing n reflects diffusely.
vec3 sky_diffuse(vec3 n) {
    return sky_sum(frame.irradiance[0].rgb, frame.irradiance[1].rgb, frame.irradiance[2].rgb,
                   frame.irradiance[3].rgb, frame.irradiance[4].rgb, frame.irradiance[5].rgb,
                   frame.irradiance[6].rgb, frame.irradiance[7].rgb, frame.irradiance[8].rgb, n.x, n.y, n.z);
}
