"""Takes the mechanism of each safety property out of the source, one after the other, and wants a test to notice.

  python3 tests/haptics/mutations.py BUILD [NUMBER ...]

BUILD is a configured build folder, for example build/release. The tree must be clean: a mutation is written into it,
built, tried, and taken back. Some five minutes. Exit 0 when every mutation was noticed, 1 when one was not.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = "engine/haptics/safety"
PROPERTIES = "haptics_safety_properties"
STATE = "SafetyState& state) noexcept {\n"


def off(stage):
    """A stage that passes the force on as it came."""
    return f"{STAGES}/{stage}.cpp", STATE, STATE + "    if (limits.peak_force_n > -1.0) return force_n;\n"


# Property, what is taken away, (file, text, text instead), test program.
MUTATIONS = [
    (1, "the peak", off("clamp"), PROPERTIES),
    (1, "the continuous force", off("budget"), PROPERTIES),
    (2, "the direction", (f"{STAGES}/clamp.cpp", "return safety::at_most(force_n, limits.peak_force_n, state);",
                          "return glm::clamp(force_n, dvec3(-limits.peak_force_n), dvec3(limits.peak_force_n));"),
     PROPERTIES),
    (3, "the slew limit", (f"{STAGES}/slew.cpp", STATE, STATE +
                           "    if (limits.peak_force_n > -1.0) return state.applied_force_n = force_n;\n"), PROPERTIES),
    (4, "the ramp", off("ramp"), PROPERTIES),
    (4, "the wait for a small force", (f"{STAGES}/ramp.cpp", "state.calm_ticks <= limits.small_force_ticks",
                                       "state.calm_ticks > 1000000"), PROPERTIES),
    (5, "the latched fault", off("gate"), PROPERTIES),
    (6, "the velocity gate", off("speed"), PROPERTIES),
    (7, "the host's watchdog", ("engine/haptics/watchdog.cpp", "        device_.silence();\n", ""), PROPERTIES),
    (7, "the silence of a USB device", ("engine/haptics/hid/force_gate.cpp",
                                        "now_ns - last_order_ns_ > limits_.silence_ns;", "false;"), PROPERTIES),
    (7, "the silence of the Inverse3", ("engine/haptics/haply/inverse_session.cpp",
                                        "std::exchange(silences_, silences) != silences",
                                        "std::exchange(silences_, silences) > silences"), "unit_haply"),
    (8, "the Inverse3's news of its place", ("engine/haptics/haply/inverse_device.h",
                                             ".position_is_new = is_new_", ".position_is_new = is_here_"), "unit_haply"),
    (8, "the stale position", (f"{STAGES}/hand.cpp", "input.hand_is_there && !is_stale",
                               "input.hand_is_there && (!is_stale || state.stale_s > 0.0)"), PROPERTIES),
    (9, "the passivity controller", off("passivity"), PROPERTIES),
    (10, "the check of stiffness at load", ("game/haptic/job.cpp", "    if (!work_.fits()) return work_.fits();\n", ""),
     PROPERTIES),
    (10, "the bound of a force over USB", ("game/haptic/device_force.cpp",
                                           "const dvec3 of_axes(shows_wall ? 1.0 : wire, wire, 1.0);",
                                           "const dvec3 of_axes(shows_wall ? 1.0 : 1.0, 1.0, std::min(1.0, wire));"),
     "haptics_shipped_devices"),
    (10, "the judgement of an unknown weight", ("engine/haptics/stability.cpp",
                                                "    const DeviceCapabilities known = judged(device);\n"
                                                "    const LoopSetting setting = loop_of(device, rate_hz);\n",
                                                "    if (device.moving_mass_kg <= 0.0) return {};\n"
                                                "    const DeviceCapabilities known = judged(device);\n"
                                                "    const LoopSetting setting = loop_of(device, rate_hz);\n"),
     "haptics_stability"),
    (11, "the softer clay of a late loop", off("late"), PROPERTIES),
    (12, "the ramp after a reopening", (f"{STAGES}/hand.cpp", "            restart_ramp(state);\n", ""), PROPERTIES),
    (13, "the tick without allocation", ("game/haptic/job.cpp", "    obey_commands();\n    put_on_states();\n",
                                         "    obey_commands();\n    delete new HapticState(start_);\n"
                                         "    put_on_states();\n"), "haptics_quiet_tick"),
    (14, "the dead man's switch", (f"{STAGES}/hand.cpp", "input.hand_is_there && !is_stale",
                                   "input.dt_s >= 0.0 && !is_stale"), PROPERTIES),
    (14, "letting go when nobody is there", ("game/haptic/job.cpp", "                nobody_is_there_ = true;\n",
                                             "                nobody_is_there_ = false;\n"), PROPERTIES),
    (14, "letting go when the picture hangs", ("game/haptic/job.cpp", " || watchdog_.picture_stands_still();",
                                               ";"), PROPERTIES),
    (14, "the stop key", (f"{STAGES}/gate.cpp", "} else if (input.stop) {", "} else if (input.stop && input.dt_s < 0.0) {"),
     PROPERTIES),
    (15, "the record of what was felt", ("game/haptic/job.cpp", "    record.tool = state_.tool;\n",
                                         "    record.tool = start_.tool;\n"), PROPERTIES),
]


def run(*words):
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True)


def noticed(build, file, program):
    built = run("cmake", "--build", build, "--target", program)
    if built.returncode != 0:
        sys.exit(f"mutations: {file}: expected it to compile, found:\n{built.stdout[-3000:]}")
    return run(str(pathlib.Path(build) / "tests" / program)).returncode != 0


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = sys.argv[1]
    wanted = {int(word) for word in sys.argv[2:]}
    if run("git", "status", "--porcelain", "--untracked-files=no").stdout:
        sys.exit("mutations: expected a clean tree, found changes that a mutation would be mixed with")
    missed = 0
    for number, what, (name, text, instead), program in MUTATIONS:
        if wanted and number not in wanted:
            continue
        file = ROOT / name
        source = file.read_text()
        if source.count(text) != 1:
            sys.exit(f"mutations: {name}: expected once {text!r}, found it {source.count(text)} times")
        try:
            file.write_text(source.replace(text, instead))
            seen = noticed(build, name, program)
        finally:
            file.write_text(source)
        missed += not seen
        print(f"{number:2} without {what}: {'noticed' if seen else 'NOT NOTICED'}", flush=True)
    for program in {mutation[3] for mutation in MUTATIONS}:  # as they should be
        run("cmake", "--build", build, "--target", program)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
