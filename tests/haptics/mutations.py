"""Removes the mechanism of each safety property from the source, one at a time, and expects a test to fail.

  mutations.py FOLDER [WORDS]   Exit 0 when every mutation was noticed, 1 when one was not or does not build. Mutates a copy
                                of the checkout in FOLDER, which it builds there; a copy of before is brought up to date.
                                An hour or two.
                                WORDS: only the mutations whose names or test programs hold them.
  mutations.py --check          Exit 1 when a mutation quotes a text that its file does not hold exactly once: it names all.

Besides the mutations written here, every number of SafetyLimits and of ForceGateLimits is made a tenth larger.
"""
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHAIN = "engine/haptics/safety_chain.cpp"
HEADER = "engine/haptics/safety_chain.h"
PROPERTIES = "haptics_safety_properties"
HID = "engine/haptics/hid"
GATE = f"{HID}/force_gate.cpp"


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
    (9, "the share that a change of hands leaves", ("engine/haptics/device_group.cpp",
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
    (11, "the skip of missed ticks", ("engine/jobs/pacer.h", "std::max(last, index_at(start_ns))",
                                      "std::min(last, index_at(start_ns))"), "unit_jobs"),
    (12, "the tick that waits for no device", SHARED_LOCK, "stress_loop"),
    (12, "the next device where one fails", (f"{HID}/hid_session.cpp", "is_worse) told = std::move(status);",
                                             "is_worse) told = std::move(status);\n"
                                             "        if (is_worse) break;"), "unit_hid"),
    (12, "the ramp after a reopening", (CHAIN, "            restart_ramp(state);\n", ""), PROPERTIES),
    (13, "the tick without allocation", ("game/haptic/job.cpp", "    apply_commands();\n    put_on_states();\n",
                                         "    apply_commands();\n    delete new HapticState(start_);\n"
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

    # Every check of the gate, and of sound input.
    (5, "the check of the position for finite", (CHAIN, "    if (!safety::finite(at)) {", "    if (input.dt_s == 77.0) {"),
     "unit_haptics"),
    (5, "the workspace", (CHAIN, "} else if (!safety::is_within(at, limits.workspace_mm)) {",
                          "} else if (input.dt_s == 77.0) {"), "unit_haptics"),
    *[(5, f"the bound along {axis}", (CHAIN, f"std::abs(v.{axis}) <= most", "true"), "unit_haptics") for axis in "xyz"],
    *[(5, f"finiteness along {axis}", (CHAIN, f"std::isfinite(v.{axis})", "true"), "unit_haptics") for axis in "xyz"],
    (5, "the check of the velocity for finite", (CHAIN, " || !safety::finite(input.velocity_mm_s)) {", ") {"), "unit_haptics"),
    (5, "the fault of an input that is not sound", (CHAIN, "        latch(state, is_finite ? Fault::kInputNotSound : "
                                                          "Fault::kForceNotFinite);\n",
                                                    "        (void)is_finite;\n"), "unit_haptics"),
    (5, "the word for a force that is not finite", (CHAIN, "is_finite = safety::finite(force_n) && ", "is_finite = "),
     "unit_haptics"),
    (5, "the word for a driven part that is not finite", (CHAIN, "&& safety::finite(input.driven_force_n) &&", "&&"),
     "unit_haptics"),
    (5, "the word for a velocity that is not finite", (CHAIN, "input.driven_force_n) &&\n                               "
                                                              "safety::finite(input.velocity_mm_s);",
                                                       "input.driven_force_n);"), "unit_haptics"),
    (5, "the gate at the head of the chain", (CHAIN, "is_gated ? gate(force_n, input, limits, state) : force_n", "force_n"),
     "unit_haptics"),
    (5, "the check of all inputs where there is no gate", (CHAIN, "!safety::is_sound(force_n, input, limits)) {\n        restart",
                                                           "input.dt_s == 77.0) {\n        restart"), "unit_haptics"),
    (5, "the ramp after an input that is not sound", (CHAIN, "        restart_ramp(state);\n        return apply(state,",
                                                      "        return apply(state,"), "unit_haptics"),
    (5, "the least time", (CHAIN, "input.dt_s >= 0.0 && ", ""), "unit_haptics"),
    (5, "the longest time", (CHAIN, " && input.dt_s <= limits.longest_tick_s", ""), "unit_haptics"),
    (5, "the least applied fraction", (CHAIN, " && input.applied_fraction >= 0.0", ""), "unit_haptics"),
    (5, "the largest applied fraction", (CHAIN, "input.applied_fraction <= 1.0 && ", ""), "unit_haptics"),
    (5, "the bound of the driven part", (CHAIN, "is_within(input.driven_force_n, limits.most_driven_n) &&", "true &&"),
     "unit_haptics"),
    (5, "the check of the force for finite", (CHAIN, "           finite(force_n);\n",
                                               "           (finite(force_n) || input.dt_s >= 0.0);\n"), "unit_haptics"),
    (4, "the fourth small tick of the ramp", (CHAIN, "state.calm_ticks <= limits.small_force_ticks) {",
                                              "state.calm_ticks < limits.small_force_ticks) {"), "unit_haptics"),
    # What the stages do with time.
    (8, "the slowness of the return", (CHAIN, "input.dt_s / limits.return_s", "input.dt_s / limits.decay_s"), "unit_haptics"),
    (11, "the missed periods in the lateness", (CHAIN, "limits.late_memory_s * (1.0 + missed)", "limits.late_memory_s"),
     "unit_haptics"),
    (11, "the lateness of the tick", (CHAIN, "missed / (1.0 + missed)", "missed > 0.0 ? 1.0 : 0.0"), "unit_haptics"),
    (1, "the knee of the budget", (HEADER, "budget_knee = 0.5;", "budget_knee = 0.9;"), "unit_haptics"),
    (1, "the exactness of the cooling", (CHAIN, "part - 0.5 * part * part", "part"), "unit_haptics"),
    (1, "the bound of what one tick heats", (CHAIN, "> room_n2 * limits.budget_s) {", "> 1e9 * limits.budget_s) {"),
     "unit_haptics"),
    (3, "the speed of the release", (CHAIN, "before_n - limits.release_n_per_s * input.dt_s",
                                     "before_n - 4.0 * limits.release_n_per_s * input.dt_s"), "unit_haptics"),
    (3, "the stillness of the direction in the release", (CHAIN, "        if (held_n > wanted_n) return apply(state, held, "
                                                         "held_driven);\n", ""), "unit_haptics"),
    (6, "the ramp after a tool that was too fast", (CHAIN, "        ++state.speed_stops;\n        restart_ramp(state);\n",
                                                    "        ++state.speed_stops;\n"), "unit_haptics"),
    (6, "the brake against the motion", (CHAIN, ", state) - v * (limits.brake", ", state) + v * (limits.brake"), "unit_haptics"),
    # The energy.
    (9, "the fault of a device that gives energy", (CHAIN, "        latch(state, Fault::kEnergyGenerated);\n", ""),
     "unit_haptics"),
    (9, "what the wheel drives in the energy given", (CHAIN, " - taken_mj - driven_mj);", " - taken_mj);"), "unit_haptics"),
    (9, "the floor of the energy given", (CHAIN, "state.generated_mj = std::max(0.0, ", "state.generated_mj = std::max(-1e9, "),
     "unit_haptics"),
    (9, "the end of the energy given with the ramp", (CHAIN, "    state.generated_mj = 0.0;\n", ""), "unit_haptics"),
    (9, "the energy of devices without motors", (CHAIN, "if (!device.has_motors || device.force_axes == 0) limits.most_gen",
                                                 "if (device.force_axes == 0) limits.most_gen"), "unit_haptics"),
    (9, "the energy of devices without force", (CHAIN, "if (!device.has_motors || device.force_axes == 0) limits.most_gen",
                                                "if (!device.has_motors) limits.most_gen"), "unit_haptics"),
    # The motors of a hand, by the stage.
    *[(1, f"the {stage} of a hand's motors", [(HEADER, "array<SafetyStage, 3> kMotorStages", "array<SafetyStage, 2> kMotorStages"),
                                              (HEADER, row, "")], "unit_haptics")
      for stage, row in (
          ("ramp", '    {"ramp", "from zero to full force once a device has the tool and the force is small", &ramp},\n'),
          ("budget", '    {"budget", "this device\'s own mean force, while it works and while it rests", &budget},\n'),
          ("clamp", '    {"clamp", "this device\'s own peak force, direction kept", &clamp},\n'))],
    # What a device's own limits do to the chain's.
    (1, "the lower peak of a weak device", (CHAIN, "limits.peak_force_n = std::min(limits.peak_force_n, device.peak_force_n);",
                                            "limits.peak_force_n = device.peak_force_n;"), "unit_haptics"),
    (1, "the profile's continuous force", (CHAIN, "kKioskContinuousForceN, device.cont", "device.continuous_force_n, device.cont"),
     "unit_haptics"),
    (8, "the period of a slow device", (CHAIN, "limits.device_period_s = 1.0 / device.report_rate_hz;",
                                        "limits.device_period_s = 0.1 / device.report_rate_hz;"), "unit_haptics"),
    # The last gate, on the device's thread.
    (7, "the end of a loop that is dead", (GATE, "now_ns - last_order_ns_ > limits_.starved_ns;", "false;"), "unit_hid"),
    (7, "the zero before the first order", (GATE, "order.ticks == 0 || ", ""), "unit_hid"),
    (7, "the wait of the gate for a small force", (GATE, "        if (size_n > limits_.small_n) return allowed;\n", ""),
     "unit_hid"),
    (7, "the ramp of the gate", (GATE, "fraction_ = ramp * (size_n", "fraction_ = (ramp < 0.0 ? 0.0 : 1.0) * (size_n"),
     "unit_hid"),
    (7, "the ramp of the gate after nonsense", (GATE, "        restart();\n", ""), "unit_hid"),
    (1, "the peak of the gate", (GATE, "size_n > limits_.peak_n ? limits_.peak_n / size_n : 1.0", "1.0"), "unit_hid"),
    (1, "the third axis in the gate's peak", (GATE, "order.force_n.y * order.force_n.y +\n", "order.force_n.y * order.force_n.y + 0.0 *\n"),
     "unit_hid"),
    (5, "the check of the force in the gate", (GATE, "std::isfinite(size_n) && ", ""), "unit_hid"),
    (5, "the check of the tool's radius in the gate", (GATE, "std::isfinite(order.tool_mm.x) && ", ""), "unit_hid"),
    (5, "the check of the tool's height in the gate", (GATE, " && std::isfinite(order.tool_mm.y);", ";"), "unit_hid"),

]


def numbers_of(file, struct, program):
    """A mutation for each number of a struct: a tenth more, and of a whole number one."""
    body = re.search(rf"\nstruct {struct} {{\n(.*?)\n}};\n", (ROOT / file).read_text(), re.S).group(1)
    rows = re.findall(r"    ((double|int|std::int64_t) (\w+) = )([^;]+);", body)
    for line, kind, name, value in rows:
        more = {"double": f"({value}) == 0.0 ? 0.001 : 1.1 * ({value})", "int": f"({value}) + 1"}.get(kind, f"({value}) * 11 / 10")
        yield (0, f"{struct}::{name} a tenth larger", (file, f"    {line}{value};", f"    {line}{more};"), program)


def all_mutations():
    numbers = [*numbers_of(HEADER, "SafetyLimits", "unit_haptics"), *numbers_of(f"{HID}/force_gate.h", "ForceGateLimits", "unit_hid")]
    constants = [(0, f"{name} a tenth larger", (HEADER, f"constexpr double {name} = ", f"constexpr double {name} = 1.1 * "),
                  "unit_haptics") for name in ("kKioskPeakForceN", "kKioskContinuousForceN")]
    for number, what, edits, program in MUTATIONS + numbers + constants:
        yield number, what, edits if isinstance(edits, list) else [edits], program


def stale():
    """One line for each quoted text that its file does not hold exactly once."""
    for number, what, edits, _ in all_mutations():
        for name, text, _ in edits:
            found = (ROOT / name).read_text().count(text) if (ROOT / name).exists() else 0
            if found != 1:
                yield f"mutations: {number} without {what}: {name}: expected once {text!r}, found it {found} times"


class Copy:
    """The checkout, in a folder where it may be changed."""

    LEFT_OUT = {"build", ".git", "node_modules", "__pycache__"}

    def __init__(self, folder):
        self.root = folder / "checkout"
        self.build = folder / "build"
        kept = set()
        for at, folders, files in os.walk(ROOT):
            folders[:] = [name for name in folders if name not in self.LEFT_OUT]
            for name in set(files) - self.LEFT_OUT:
                source = pathlib.Path(at) / name
                place = self.root / source.relative_to(ROOT)
                kept.add(place)
                if not place.exists() or place.read_bytes() != source.read_bytes():
                    place.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(source, place)
        for place in [path for path in self.root.rglob("*") if path.is_file() and path not in kept]:
            place.unlink()
        if not self.run("cmake", "--preset", "dev", "-B", str(self.build), "-DONGGI_TESTS=ON"):
            sys.exit(1)

    def run(self, *words):
        done = subprocess.run(words, cwd=self.root, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"mutations: {' '.join(words)}: expected it to work, found:\n{(done.stdout + done.stderr)[-3000:]}")
        return done.returncode == 0

    def builds(self, *programs):
        return self.run("cmake", "--build", str(self.build), "--target", *programs)

    def passes(self, program, longest_s):
        # Some mutations make a test hang; that counts as noticed. Its child processes are not waited for.
        quiet = subprocess.DEVNULL
        try:
            test = [str(self.build / "tests" / program)]
            return subprocess.run(test, cwd=self.root, stdout=quiet, stderr=quiet, timeout=longest_s).returncode == 0
        except subprocess.TimeoutExpired:
            return False

    def mutated(self, edits):
        """Writes the edits; gives what takes them back."""
        before = {}
        for name, text, instead in edits:
            source = (self.root / name).read_text()
            before.setdefault(name, source)
            (self.root / name).write_text(source.replace(text, instead))
        return before


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    faults = list(stale())
    if faults or sys.argv[1] == "--check":
        print("\n".join(faults) or f"{len(list(all_mutations()))} mutations, each of text that stands there once")
        return 1 if faults else 0
    wanted = [mutation for mutation in all_mutations() if " ".join(sys.argv[2:]) in f"{mutation[1]} {mutation[3]}"]
    wanted.sort(key=lambda mutation: mutation[3])
    copy = Copy(pathlib.Path(sys.argv[1]).resolve())
    if not copy.builds(*sorted({mutation[3] for mutation in wanted})):
        return 1
    missed = 0
    for program, mutations in itertools.groupby(wanted, key=lambda mutation: mutation[3]):
        copy.builds(program)
        began = time.monotonic()
        if not copy.passes(program, None):
            sys.exit(f"mutations: {program}: expected it to pass as it is, found that it fails")
        longest_s = 60 + 10 * (time.monotonic() - began)
        for number, what, edits, _ in mutations:
            before = copy.mutated(edits)
            outcome = ("DOES NOT BUILD" if not copy.builds(program) else
                       "NOT NOTICED" if copy.passes(program, longest_s) else "noticed")
            for name, source in before.items():
                (copy.root / name).write_text(source)
            missed += outcome != "noticed"
            print(f"{number:2} without {what}: {outcome}", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
