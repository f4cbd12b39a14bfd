// The stability bench's device models: moving mass, damping, resolution. Values are from makers and published
// measurements where available; invented ones are marked as such.
#pragma once

#include <array>

#include "engine/haptics/haptic_device.h"

namespace onggi::test {

// A stylus of 45 g behind an encoder of 0.055 mm, as on a Phantom Omni (resolution: its data sheet), with the
// given damping and dry friction.
inline haptics::DeviceCapabilities stylus(const char* name, double damping_n_s_per_m, double coulomb_n) {
    return {.name = name,
            .force_axes = 3,
            .peak_force_n = 3.3,
            .continuous_force_n = 0.88,
            .max_stiffness_n_per_mm = 0.7,
            .position_resolution_mm = 0.055,
            .moving_mass_kg = 0.045,
            .damping_n_s_per_mm = damping_n_s_per_m / 1000.0,
            .coulomb_friction_n = coulomb_n};
}

// The model closest to the paper's device: 0.1 N s/m and 0.26 N of dry friction.
inline haptics::DeviceCapabilities omni_like() {
    return stylus("Omni-like", 0.1, 0.26);
}

// From the least to the most stable.
inline std::array<haptics::DeviceCapabilities, 5> bench_devices() {
    return {stylus("0.1 N s/m, no friction", 0.1, 0.0), stylus("0.3 N s/m, no friction", 0.3, 0.0),
            stylus("1.0 N s/m, no friction", 1.0, 0.0), stylus("0.3 N s/m, 0.13 N friction", 0.3, 0.13),
            omni_like()};
}

}  // namespace onggi::test
