#!/usr/bin/env python3
"""Runs the tests that ctest lists, as many in parallel as the cores have idle time for.

run_tests.py BUILD [CTEST OPTION...]: BUILD is a build folder; the options choose tests as ctest's do (-L, -LE, -R).
What a test prints is kept in BUILD/Testing/NAME.log, and the seconds that each took in BUILD/Testing/seconds.txt, as
tests/tests.txt has them. Exit code: 0 all passed, 1 some failed, 2 no test was found.

ctest starts a fixed number of tests and measures a time limit by the clock, so a busy machine fails tests that would
pass. This runner keeps one test running for each core, and starts another whenever the cores have been idle enough for
it. A test's time limit does not count the time in which the test waited for a core.
"""

import json
import math
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

POLL_S = 0.25
LOOKS_EVERY_S = 1.0
# In real time a test may take this many times its limit, however long it waited for a core.
MOST_LIMITS = 10
# Another test starts when this much of a core has been idle for this long.
IDLE_CORES = 0.3
SETTLING_S = 2.0
MOST_A_CORE = 6
PROGRESS_S = 60.0

# The supported properties. A test with any other is refused, so that none is silently ignored.
OBEYED = {"COST", "DEPENDS", "ENVIRONMENT", "FIXTURES_REQUIRED", "FIXTURES_SETUP", "LABELS", "RESOURCE_LOCK", "RUN_SERIAL",
          "SKIP_REGULAR_EXPRESSION", "SKIP_RETURN_CODE", "TIMEOUT", "WORKING_DIRECTORY"}


def say(line):
    print(f"onggi: {line}", flush=True)


class Test:
    """A test as ctest lists it."""

    def __init__(self, listed):
        properties = {entry["name"]: entry["value"] for entry in listed["properties"]}
        self.name = listed["name"]
        self.command = listed.get("command")
        unknown = properties.keys() - OBEYED
        if unknown or self.command is None:
            raise SystemExit(f"run_tests: {self.name}: expected a program and known properties, found {unknown or 'no program'}")
        self.folder = properties.get("WORKING_DIRECTORY")
        self.environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
        self.limit_s = properties["TIMEOUT"]
        self.cost_s = properties.get("COST", 1.0)
        self.locks = set(properties.get("RESOURCE_LOCK", []))
        self.is_serial = properties.get("RUN_SERIAL", False)
        self.needs = set(properties.get("FIXTURES_REQUIRED", []))
        self.provides = set(properties.get("FIXTURES_SETUP", []))
        self.skip_code = properties.get("SKIP_RETURN_CODE")
        self.skip_words = [re.compile(words) for words in properties.get("SKIP_REGULAR_EXPRESSION", [])]


class Processes:
    """A snapshot of the kernel's process table: parents, and which processes wait for a core (proc(5))."""

    def __init__(self):
        self.parents, self.sessions, self.words = {}, {}, {}
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            try:
                text = Path("/proc", entry, "stat").read_text(errors="replace")
            except OSError:
                continue  # it ended meanwhile
            name, rest = text[text.index("(") + 1:].rsplit(")", 1)
            fields = rest.split()
            self.parents[int(entry)], self.sessions[int(entry)] = int(fields[1]), int(fields[3])
            self.words[int(entry)] = f"{name} ({fields[0]})"

    def of(self, leader):
        """The process, its descendants, and its session's processes."""
        def descends(process):
            while process and process != leader:
                process = self.parents.get(process, 0)
            return process == leader
        return [process for process in self.parents if self.sessions[process] == leader or descends(process)]


def longest_wait_s(processes):
    """The longest time, s, that any of its threads has waited for a core so far (the kernel's schedstat)."""
    longest = 0.0
    for process in processes:
        try:
            for thread in os.listdir(f"/proc/{process}/task"):
                text = Path(f"/proc/{process}/task/{thread}/schedstat").read_text()
                longest = max(longest, int(text.split()[1]) * 1e-9)
        except OSError:
            continue
    return longest


class Run:
    """A test that is running."""

    def __init__(self, test, log):
        self.test, self.log = test, log
        self.began = self.looked = time.monotonic()
        with log.open("wb") as output:
            self.process = subprocess.Popen(test.command, cwd=test.folder, env={**os.environ, **test.environment},
                                            stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                            start_new_session=True)

    def elapsed_s(self):
        return time.monotonic() - self.began

    def hangs(self):
        """Returns whether it is over its limit, not counting the time that it waited for a core.

        Reads /proc only when the clock is over the limit, and seldom: the kernel is slow to end a process whose entries
        in /proc are read often.
        """
        now = time.monotonic()
        if self.elapsed_s() <= self.test.limit_s or now - self.looked < LOOKS_EVERY_S:
            return False
        self.looked = now
        waited_s = min(longest_wait_s(Processes().of(self.process.pid)), self.elapsed_s() * (1 - 1 / MOST_LIMITS))
        return self.elapsed_s() - waited_s > self.test.limit_s

    def end(self):
        """Ends its remaining processes and returns their names."""
        table = Processes()
        left = [process for process in table.of(self.process.pid) if not table.words[process].endswith("(Z)")]
        for process in left:
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.process.wait()
        return ", ".join(table.words[process] for process in left)


class Cores:
    """The idle share of the cores that this process may use, in cores."""

    def __init__(self):
        self.mine = {f"cpu{core}" for core in os.sched_getaffinity(0)}
        self.look_again()

    def idle_s(self):
        ticks = 0
        for line in Path("/proc/stat").read_text().splitlines():
            fields = line.split()
            if fields[0] in self.mine:
                ticks += int(fields[4]) + int(fields[5])
        return ticks / os.sysconf("SC_CLK_TCK")

    def look_again(self):
        self.looked, self.idle = time.monotonic(), self.idle_s()

    def have_room(self):
        since = time.monotonic() - self.looked
        if since < SETTLING_S:
            return False
        room = (self.idle_s() - self.idle) / since >= IDLE_CORES
        self.look_again()
        return room


class Suite:
    def __init__(self, build, tests):
        self.build = build
        self.waiting = sorted(tests, key=lambda test: (test.is_serial, -test.cost_s))
        self.count = len(tests)
        self.logs = Path(build, "Testing")
        self.logs.mkdir(parents=True, exist_ok=True)
        self.cores = Cores()
        self.running = []
        self.passed, self.skipped, self.failed = [], [], []  # pairs of a test and the reason
        self.seconds = {}
        self.setups = {name: {test.name for test in tests if name in test.provides} for test in tests for name in test.needs}
        self.began = self.reported = time.monotonic()

    def elapsed_s(self):
        return time.monotonic() - self.began

    def over(self):
        return [test for test, _ in self.passed + self.skipped + self.failed]

    def startable(self):
        """The longest test that may start now, or None."""
        if any(run.test.is_serial for run in self.running):
            return None
        taken = set().union(*(run.test.locks for run in self.running))
        passed = {test.name for test, _ in self.passed}
        for test in self.waiting:
            ready = all(self.setups[name] <= passed for name in test.needs)
            alone = not self.running or not test.is_serial
            if ready and alone and not test.locks & taken:
                return test
        return None

    def start(self):
        count = len(self.cores.mine)
        while self.waiting and len(self.running) < MOST_A_CORE * count:
            if len(self.running) >= count and not self.cores.have_room():
                return
            test = self.startable()
            if test is None:
                return
            self.waiting.remove(test)
            self.running.append(Run(test, self.logs / f"{test.name}.log"))
            self.cores.look_again()

    def judge(self, run, hangs, left):
        """The list that the test belongs to, and the reason."""
        test, status = run.test, run.process.returncode
        output = run.log.read_text(errors="replace")
        if hangs:
            return self.failed, f"over its limit of {test.limit_s:.0f} s after {run.elapsed_s():.0f} s; still running: {left}"
        if status == test.skip_code or status == 0 and any(words.search(output) for words in test.skip_words):
            return self.skipped, (output.strip().splitlines() or ["no reason given"])[-1]
        if status != 0:
            return self.failed, f"signal {-status}" if status < 0 else f"exit code {status}"
        return self.passed, ""

    def finish(self, run, hangs=False):
        self.running.remove(run)
        self.seconds[run.test.name] = run.elapsed_s()
        outcome, why = self.judge(run, hangs, run.end())
        outcome.append((run.test, why))
        if outcome is not self.passed:  # tests that need it do not run, with the same outcome
            for other in [other for other in self.waiting if other.needs & run.test.provides]:
                self.waiting.remove(other)
                outcome.append((other, f"did not run, because {run.test.name} did not pass"))
        word = "passed" if outcome is self.passed else "skipped" if outcome is self.skipped else "FAILED"
        print(f"[{len(self.over()):3}/{self.count}] {word:7} {run.test.name} {run.elapsed_s():.1f} s", flush=True)
        if outcome is self.failed:
            print(run.log.read_text(errors="replace").rstrip("\n"), flush=True)

    def look(self):
        for run in list(self.running):
            if run.process.poll() is not None:
                self.finish(run)
            elif run.hangs():
                self.finish(run, hangs=True)

    def report(self):
        self.reported += PROGRESS_S
        over = self.over()
        done_s = sum(test.cost_s for test in over) + sum(min(run.test.cost_s, run.elapsed_s()) for run in self.running)
        left_s = sum(test.cost_s for test in self.waiting) + sum(max(0.0, run.test.cost_s - run.elapsed_s()) for run in self.running)
        running = ", ".join(f"{run.test.name} ({run.elapsed_s():.0f} s)" for run in self.running)
        say(f"{self.elapsed_s() / 60:.0f} min: {len(over)} of {self.count} done, {len(self.failed)} failed, "
            f"{len(self.waiting)} waiting; running {running}; "
            f"about {left_s * self.elapsed_s() / max(done_s, 1.0) / 60:.0f} min left")

    def run(self):
        while self.waiting or self.running:
            self.look()
            self.start()
            if time.monotonic() - self.reported >= PROGRESS_S:
                self.report()
            time.sleep(POLL_S)

    def conclude(self):
        lines = [f"{name:42} {math.ceil(seconds)}" for name, seconds in sorted(self.seconds.items())]
        Path(self.logs, "seconds.txt").write_text("\n".join(lines) + "\n")
        for test, why in self.skipped:
            say(f"skipped {test.name}: {why}")
        for test, why in self.failed:
            say(f"FAILED {test.name}: {why}; again: ctest --test-dir {self.build} -R '^{test.name}$' --output-on-failure")
        say(f"took {self.elapsed_s():.0f} s")
        print(f"{len(self.passed)} passed, {len(self.failed)} failed, {len(self.skipped)} skipped", flush=True)
        return 1 if self.failed else 0


def main(words):
    build, options = words[0], words[1:]
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", *options], stdout=subprocess.PIPE, check=True)
    tests = [Test(entry) for entry in json.loads(listed.stdout)["tests"]]
    if not tests:
        say(f"expected tests in {build} for {' '.join(options) or 'no option'}, found none")
        return 2
    suite = Suite(build, tests)

    def end(number, _frame):
        for run in suite.running:
            run.end()
        sys.exit(128 + number)
    signal.signal(signal.SIGINT, end)
    signal.signal(signal.SIGTERM, end)
    suite.run()
    return suite.conclude()


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    sys.exit(main(sys.argv[1:]))
