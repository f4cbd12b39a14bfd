"""sizes_test.py BUILD TABLE: every test of a build is in one size of the check, and every line of the table is a test.

BUILD: a build folder, whose tests ctest lists with their labels; TABLE: tests/tests.txt.
"""

import json
import subprocess
import sys

SIZES = ("basic", "landing", "release", "nightly")
# The tests that ./check must contain, by name prefix.
IN_BASIC = ("unit_", "paper_", "replay_", "export_", "golden_", "studio_", "haptics_", "house_", "cli_", "share_server",
            "hid_on_the_bus", "bench_", "window_visit_by_touch", "window_visit_by_keys")
# Tests that exist only in a build with the fuzzers, with npm, or on a machine with a slicer.
ELSEWHERE = ("fuzz_", "web_", "export_slicer")


def main(build, table):
    listed = json.loads(subprocess.check_output(["ctest", "--test-dir", build, "--show-only=json-v1"]))
    labels = {}
    for test in listed["tests"]:
        labels[test["name"]] = next((entry["value"] for entry in test["properties"] if entry["name"] == "LABELS"), [])
    rows = dict(line.split()[:2] for line in open(table, encoding="utf-8") if not line.startswith("#"))
    faults = []
    for name, words in labels.items():
        sizes = [size for size in SIZES if size in words]
        if sizes != [rows.get(name)]:
            faults.append(f"{name}: expected the size {rows.get(name)}, found {sizes}")
    is_release = "bench_paper_ratio" in labels
    for name in rows:
        if is_release and name not in labels and not name.startswith(ELSEWHERE):
            faults.append(f"{name}: expected a test of that name, found none")
    for start in IN_BASIC:
        if not any(name.startswith(start) and rows[name] == "basic" for name in rows):
            faults.append(f"{start}: expected a test in the size basic, found none")
    print("\n".join(faults) or f"{len(labels)} tests, each in one size")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
