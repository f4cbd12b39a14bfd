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

// How much of the key light passes the moving spheres on its way to p, 0 to 1.
float past_spheres(vec3 p) {
    float seen = 1.0;
    int count = min(int(frame.counts.x), kSpheres);
    for (int i = 0; i < count; ++i) {
        float radius = frame.spheres[i].w;
        vec3 to = frame.spheres[i].xyz - p;
        float along = dot(to, frame.key_direction.xyz);
        float gap = sqrt(max(dot(to, to) - along * along, 0.0)) - radius;
        float width = max(along * frame.key_direction.w, 0.5);
        if (along > 0.0) seen *= smoothstep(-width, width, gap);
    }
    return seen;
}

// Whether it may be less than all of it anywhere within `margin` mm of p.
bool may_be_past_spheres(vec3 p, float margin) {
    bool may_be = false;
    int count = min(int(frame.counts.x), kSpheres);
    for (int i = 0; i < count; ++i) {
        vec3 to = frame.spheres[i].xyz - p;
        float along = dot(to, frame.key_direction.xyz);
        float reach = frame.spheres[i].w + max((along + margin) * frame.key_direction.w, 0.5) + margin;
        if (along > -margin && dot(to, to) - along * along < reach * reach) may_be = true;
    }
    return may_be;
}

// How much of the sky they leave: a sphere of radius r at distance d hides (r/d)^2 of what faces it.
float sky_past_spheres(vec3 p, vec3 n) {
    float open = 1.0;
    int count = min(int(frame.counts.x), kSpheres);
    for (int i = 0; i < count; ++i) {
        float radius = frame.spheres[i].w;
        vec3 to = frame.spheres[i].xyz - p;
        float d2 = max(dot(to, to), radius * radius);
        open *= 1.0 - clamp(dot(n, to) * inversesqrt(d2), 0.0, 1.0) * radius * radius / d2;
    }
    return open;
}
