// What a hand or a tool sends to the eye: soft light on flesh, cloth and wood, a wet gleam where clay lies on it.

// n, v, l: unit vectors out of the surface, to the eye and to the light. ambient: diffuse and mirrored light of
// the sky together, finished; key: key light that gets here; mirror: what is mirrored of it, straight on.
vec3 mover_light(vec3 n, vec3 v, vec3 l, vec3 albedo, float roughness, vec3 ambient, vec3 key, vec3 mirror) {
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    // Light scatters under skin and in cloth: the edge of the lit side is soft, and warm where it is skin.
    float lit = soft_cosine(n_l, 0.30, 1.0 / 0.30);
    float half_length = inversesqrt(max(2.0 + 2.0 * dot(v, l), 1e-4));
    float gloss = ggx(max((n_v + n_l) * half_length, 0.0), n_v, max(n_l, 0.0), roughness);
    return ambient + key * (albedo * lit + mirror * gloss * 3.14159265);
}
