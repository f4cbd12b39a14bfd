"""Removes the mechanism of each safety property from the source, one at a time, and expects a test to fail.

  python3 tests/haptics/mutations.py BUILD [NUMBER ...]

BUILD is a configured build folder, for example build/release. The tree must be clean: a mutation is written into it,
built, tried, and taken back. Some ten minutes. Exit 0 when every mutation was noticed, 1 when one was not.
"""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHAIN = "engine/haptics/safety_chain.cpp"
PROPERTIES = "haptics_safety_properties"
HID = "engine/haptics/hid"
LONGEST_S = 120


def begun(stage):
    """The head of a stage, up to the start of its body."""
    head = f"dvec3 {stage}("
    told = "/*input*/" if stage == "clamp" else "input"
    return (f"{head}const dvec3& force_n, const SafetyInput& {told}, const SafetyLimits& limits,\n"
            + " " * len(head) + "SafetyState& state) noexcept {\n")


def off(stage):
    """A stage that passes the force unchanged."""
    return CHAIN, begun(stage), begun(stage) + "    if (limits.peak_force_n > -1.0) return force_n;\n"


# A lock that the I/O thread holds while it writes to a device, and that the tick needs.
SHARED_LOCK = [
    (f"{HID}/hid_port.h", "class HidBus {", "inline std::mutex everybodys;\n\nclass HidBus {"),
    (f"{HID}/hid_port.h", "#include <memory>\n", "#include <memory>\n#include <mutex>\n"),
    (f"{HID}/hid_session.cpp", "    if (auto sent = driver_->send(",
     "    const std::lock_guard lock(everybodys);\n    if (auto sent = driver_->send("),
    (f"{HID}/hid_device.cpp", "    link_.force.put({.force_n",
     "    const std::lock_guard lock(hid::everybodys);\n    link_.force.put({.force_n"),
]

# Property, removed mechanism, (file, text, replacement) or several of them, test program.
MUTATIONS = [
    (1, "the peak", off("clamp"), PROPERTIES),
    (1, "the continuous force", off("budget"), PROPERTIES),
    (1, "the largest force ever told", ("game/haptic/job.cpp", "std::max(largest_force_n2_, glm::dot(",
                                        "std::max(0.0, glm::dot("), PROPERTIES),
    (2, "the direction", (CHAIN, "    return safety::at_most(force_n, limits.peak_force_n, state);",
                          "    return glm::clamp(force_n, dvec3(-limits.peak_force_n), dvec3(limits.peak_force_n));"),
     PROPERTIES),
    (3, "the slew limit", (CHAIN, begun("slew"), begun("slew") +
                           "    if (limits.peak_force_n > -1.0) return state.applied_force_n = force_n;\n"), PROPERTIES),
    (4, "the ramp", off("ramp"), PROPERTIES),
    (4, "the wait for a small force", (CHAIN, "state.calm_ticks <= limits.small_force_ticks",
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
    (7, "the stop of a starved joystick", (f"{HID}/pid_driver.cpp",
                                           "return write(port, device_control(*layout_, PidUsage::kStopAll));",
                                           "return {};"), "unit_hid"),
    (7, "the supervisor's part", ("engine/jobs/supervisor.cpp", "        after_crash(WTERMSIG(status));\n", ""),
     "unit_jobs"),
    (7, "the supervisor's part after a library's exit", ("engine/jobs/supervisor.cpp",
                                                         "        if (code == kAfterCrash) after_crash(0);\n", ""),
     "unit_jobs"),
    (7, "what the supervisor tells the devices", (f"{HID}/hid_device.cpp", "        driver->stop(**port);\n", ""),
     "unit_hid"),
    (8, "the refreshed place of a USB device", (f"{HID}/tool_tracker.cpp", "input.refreshed != last_refreshed_",
                                                "input.heartbeat != 0"), "unit_hid"),
    (8, "the habit of a stick", (f"{HID}/pid_driver.cpp", "habit_.reports_all_the_time();",
                                 "habit_.reports_all_the_time() && !was_heard_;"), "unit_hid"),
    (8, "the stale position", (CHAIN, "input.hand_is_there && !is_stale",
                               "input.hand_is_there && (!is_stale || state.stale_s > 0.0)"), PROPERTIES),
    (9, "the passivity controller", off("passivity"), PROPERTIES),
    (9, "the wheel's credit for no more than it did", (CHAIN, "glm::dot(state.applied_driven_n,",
                                                       "glm::dot(input.driven_force_n,"), "unit_haptics"),
    (9, "the motor's part through the ramp", (CHAIN,
                                              "safety::fraction_of(force_n, state.ramp, state)",
                                              "force_n * state.ramp"), "unit_haptics"),
    (9, "the share that a change of hands leaves", ("engine/haptics/hands.cpp",
                                                    "    signs.force_fraction *= motors_[holder_].given_fraction;\n", ""),
     "unit_haptics"),
    (9, "the share that the gate leaves", (f"{HID}/hid_session.cpp", "published.force_fraction = gate_.fraction();",
                                           "published.force_fraction = 1.0;"), "unit_hid"),
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
    (11, "the bound of a tick's time", ("engine/jobs/pacer.h", "std::min(kMostPeriods, 1.0",
                                        "std::min(1e9 * kMostPeriods, 1.0"), "unit_jobs"),
    (11, "the skip of missed ticks", ("engine/jobs/pacer.h", "std::max(index, index_at(start_ns))",
                                      "std::min(index, index_at(start_ns))"), "unit_jobs"),
    (12, "the tick that waits for no device", SHARED_LOCK, "stress_loop"),
    (12, "the next device where one fails", (f"{HID}/hid_session.cpp", "is_worse) told = std::move(status);",
                                             "is_worse) told = std::move(status);\n"
                                             "        if (is_worse) break;"), "unit_hid"),
    (12, "the ramp after a reopening", (CHAIN, "            restart_ramp(state);\n", ""), PROPERTIES),
    (13, "the tick without allocation", ("game/haptic/job.cpp", "    obey_commands();\n    put_on_states();\n",
                                         "    obey_commands();\n    delete new HapticState(start_);\n"
                                         "    put_on_states();\n"), "haptics_quiet_tick"),
    (14, "the dead man's switch", (CHAIN, "input.hand_is_there && !is_stale",
                                   "input.dt_s >= 0.0 && !is_stale"), PROPERTIES),
    (14, "letting go without a hand", ("game/haptic/job.cpp", "                nobody_is_there_ = true;\n",
                                             "                nobody_is_there_ = false;\n"), PROPERTIES),
    (14, "letting go when the picture hangs", ("game/haptic/job.cpp", " || watchdog_.picture_stands_still();",
                                               ";"), PROPERTIES),
    (14, "the stop key", (CHAIN, "} else if (input.stop) {", "} else if (input.stop && input.dt_s < 0.0) {"),
     PROPERTIES),
    (15, "the record of what was felt", ("game/haptic/job.cpp", "    record.tool = state_.tool;\n",
                                         "    record.tool = start_.tool;\n"), PROPERTIES),
]


def run(*words):
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True)


def noticed(build, what, program):
    built = run("cmake", "--build", build, "--target", program)
    if built.returncode != 0:
        sys.exit(f"mutations: without {what}: expected it to compile, found:\n{built.stdout[-3000:]}")
    # Some mutations make a test hang; that counts as noticed. Its child processes are not waited for.
    test = str(pathlib.Path(build) / "tests" / program)
    quiet = subprocess.DEVNULL
    try:
        return subprocess.run([test], cwd=ROOT, stdout=quiet, stderr=quiet, timeout=LONGEST_S).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = sys.argv[1]
    wanted = {int(word) for word in sys.argv[2:]}
    if run("git", "status", "--porcelain", "--untracked-files=no").stdout:
        sys.exit("mutations: expected a clean tree, found changes that a mutation would be mixed with")
    missed = 0
    for number, what, edits, program in MUTATIONS:
        if wanted and number not in wanted:
            continue
        edits = edits if isinstance(edits, list) else [edits]
        before = {name: (ROOT / name).read_text() for name, _, _ in edits}
        try:
            for name, text, instead in edits:
                source = (ROOT / name).read_text()
                if source.count(text) != 1:
                    sys.exit(f"mutations: {name}: expected once {text!r}, found it {source.count(text)} times")
                (ROOT / name).write_text(source.replace(text, instead))
            seen = noticed(build, what, program)
        finally:
            for name, source in before.items():
                (ROOT / name).write_text(source)
        missed += not seen
        print(f"{number:2} without {what}: {'noticed' if seen else 'NOT NOTICED'}", flush=True)
    for program in {mutation[3] for mutation in MUTATIONS}:  # with the original source
        run("cmake", "--build", build, "--target", program)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
