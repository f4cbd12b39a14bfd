// How surfaces answer the key light.

// GGX with the visibility term of B. Karis, "Real Shading in Unreal Engine 4", 2013 (Schlick's shape), folded
// so that one division is left, which is the caller's: numerator and denominator. Times n.l.
vec2 ggx_fraction(float n_h, float n_v, float n_l, float roughness) {
    float alpha = roughness * roughness;
    float a2 = alpha * alpha;
    float k = alpha * 0.5;
    float d = n_h * n_h * (a2 - 1.0) + 1.0;
    float v = (n_v * (1.0 - k) + k) * (n_l * (1.0 - k) + k);
    return vec2(a2 * n_l, 3.14159265 * 4.0 * d * d * v);
}
float ggx(float n_h, float n_v, float n_l, float roughness) {
    vec2 fraction = ggx_fraction(n_h, n_v, n_l, roughness);
    return fraction.x / fraction.y;
}

float fresnel(float f0, float cosine) {
    float m = 1.0 - cosine;
    float m2 = m * m;
    return f0 + (1.0 - f0) * m2 * m2 * m;
}

// A source with a width, and light scattered under the surface, round off the edge of the lit side: below
// `width` the cosine eases to nothing instead of stopping.
float soft_cosine(float n_l, float width, float one_over_width) {
    float eased = max(n_l * one_over_width + 1.0, 0.0);
    return n_l > width ? n_l : width * 0.25 * eased * eased;
}

// How much of the key light passes a moving sphere on its way to p, 0 to 1. `tangent`: of half its width.
float past_sphere(vec4 sphere, vec3 towards_light, float tangent, vec3 p) {
    vec3 to = sphere.xyz - p;
    float along = dot(to, towards_light);
    float gap = sqrt(max(dot(to, to) - along * along, 0.0)) - sphere.w;
    float width = max(along * tangent, 0.5);
    return along > 0.0 ? smoothstep(-width, width, gap) : 1.0;
}

// How much of the sky it leaves: a sphere of radius r at distance d hides (r/d)^2 of what faces it.
float sky_past_sphere(vec4 sphere, vec3 p, vec3 n) {
    vec3 to = sphere.xyz - p;
    float square = sphere.w * sphere.w;
    float nearness = inversesqrt(max(dot(to, to), square));
    return 1.0 - clamp(dot(n, to) * nearness, 0.0, 1.0) * square * nearness * nearness;
}
