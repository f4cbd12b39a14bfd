// Light from everywhere but the key: sharp (reflected) and diffuse.

// Radiance from a direction, blurred by a surface of this roughness. The same formula as sky_light.cpp where
// roughness is 0. A lobe of sharpness s seen through a blur of sharpness b is one of s b / (s + b).
vec3 sky_radiance(vec3 d, float roughness) {
    float alpha = roughness * roughness;
    float height = min(abs(d.y), 1.0);
    float share = height * height * (3.0 - 2.0 * height);
    vec3 radiance = mix(frame.sky_horizon.rgb, d.y > 0.0 ? frame.sky_zenith.rgb : frame.sky_nadir.rgb, share);
    float blur = 2.0 / max(alpha * alpha, 1e-4);
    for (int i = 0; i < kPanels; ++i) {
        float s = frame.panel_direction[i].w;
        float soft = s * blur / (s + blur);
        radiance += frame.panel_radiance[i].rgb * (soft / s) *
                    exp(soft * (dot(frame.panel_direction[i].xyz, d) - 1.0));
    }
    return radiance;
}

// What a white surface facing n sends back of it.
vec3 sky_diffuse(vec3 n) {
    return max(frame.irradiance[0].rgb + frame.irradiance[1].rgb * n.y + frame.irradiance[2].rgb * n.z +
                   frame.irradiance[3].rgb * n.x + frame.irradiance[4].rgb * (n.x * n.y) +
                   frame.irradiance[5].rgb * (n.y * n.z) + frame.irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) +
                   frame.irradiance[7].rgb * (n.x * n.z) + frame.irradiance[8].rgb * (n.x * n.x - n.y * n.y),
               vec3(0.0));
}

// Ambient light in a hollow bounces off the hollow's own colour.
vec3 open_sky_colour(float open, vec3 albedo) {
    return open * (1.0 + albedo * (1.0 - open) * 1.6);
}
