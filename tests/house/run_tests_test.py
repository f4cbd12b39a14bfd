"""run_tests_test.py RUNNER: the runner of the tests, on tests that pass, fail, hang and are skipped on purpose."""

import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

RUNNER = sys.argv.pop()


class Runner(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_tests(self, tests, *options):
        """tests: name -> (shell words, properties as CMake writes them). Returns the exit code and the output."""
        text = ""
        for name, (words, properties) in tests.items():
            (self.folder / f"{name}.sh").write_text(words)
            text += f'add_test({name} "sh" "{self.folder}/{name}.sh")\n'
            text += f"set_tests_properties({name} PROPERTIES TIMEOUT 60 {properties})\n"
        (self.folder / "CTestTestfile.cmake").write_text(text)
        done = subprocess.run([sys.executable, RUNNER, str(self.folder), *options], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_passes_where_all_pass(self):
        code, text = self.run_tests({"one": ("true", ""), "two": ("sleep 1", 'ENVIRONMENT "A=1"')})
        self.assertEqual(code, 0, text)
        self.assertIn("2 passed, 0 failed, 0 skipped", text)

    def test_says_how_to_repeat_what_failed(self):
        code, text = self.run_tests({"good": ("true", ""), "bad": ("echo seen; exit 3", "")})
        self.assertEqual(code, 1, text)
        self.assertIn(f"FAILED bad: exit code 3; again: ctest --test-dir {self.folder} -R '^bad$' --output-on-failure", text)
        self.assertIn("seen", text)
        self.assertIn("1 passed, 1 failed, 0 skipped", text)

    def test_ends_a_test_that_sleeps_for_ever_with_all_it_started(self):
        marker = f"{86400 + os.getpid() % 1000}.5"
        code, text = self.run_tests({"sleeps": (f"sleep {marker} & sleep {marker}", "TIMEOUT 2")})
        self.assertEqual(code, 1, text)
        self.assertIn("FAILED sleeps: over its limit of 2 s", text)
        self.assertIn("sleep (S)", text)
        self.assertNotEqual(subprocess.run(["pgrep", "-f", f"sleep {marker}"], check=False).returncode, 0)

    def test_ends_a_test_that_spins_for_ever(self):
        code, text = self.run_tests({"spins": ("while :; do :; done", "TIMEOUT 2")})
        self.assertEqual(code, 1, text)
        self.assertIn("FAILED spins: over its limit of 2 s", text)

    def test_does_not_count_the_time_in_which_a_test_waits_for_a_core(self):
        work = "i=0; while [ $i -lt 1500000 ]; do i=$((i+1)); done"
        began = time.monotonic()
        subprocess.run(["sh", "-c", work], check=True)
        limit_s = 2.0 * (time.monotonic() - began)
        crowd = [subprocess.Popen(["timeout", "300", "sh", "-c", "while :; do :; done"]) for _ in range(4 * len(os.sched_getaffinity(0)))]
        try:
            code, text = self.run_tests({"works": (work, f"TIMEOUT {limit_s:.1f}")})
        finally:
            for loop in crowd:
                loop.terminate()  # timeout also ends its command
                loop.wait()
        self.assertEqual(code, 0, text)

    def test_runs_nothing_whose_setup_failed(self):
        code, text = self.run_tests({"makes": ("false", "FIXTURES_SETUP pots"), "reads": ("true", "FIXTURES_REQUIRED pots")})
        self.assertEqual(code, 1, text)
        self.assertIn("FAILED reads: did not run, because makes did not pass", text)

    def test_skips_what_needs_a_skipped_setup(self):
        code, text = self.run_tests({"makes": ("echo no pots; exit 77", "FIXTURES_SETUP pots SKIP_RETURN_CODE 77"),
                                     "reads": ("true", "FIXTURES_REQUIRED pots")})
        self.assertEqual(code, 0, text)
        self.assertIn("skipped makes: no pots", text)
        self.assertIn("skipped reads: did not run, because makes did not pass", text)

    def test_keeps_what_shares_a_lock_apart(self):
        words = "mkdir taken && sleep 0.5 && rmdir taken"
        properties = f'RESOURCE_LOCK one WORKING_DIRECTORY "{self.folder}"'
        code, text = self.run_tests({name: (words, properties) for name in ("a", "b", "c")})
        self.assertEqual(code, 0, text)

    def test_counts_a_skipped_test_as_skipped(self):
        code, text = self.run_tests({"lacks": ("echo no cage; exit 77", "SKIP_RETURN_CODE 77")})
        self.assertEqual(code, 0, text)
        self.assertIn("skipped lacks: no cage", text)
        self.assertIn("0 passed, 0 failed, 1 skipped", text)

    def test_refuses_what_it_does_not_know(self):
        code, text = self.run_tests({"strange": ("true", "WILL_FAIL ON")})
        self.assertNotEqual(code, 0, text)
        self.assertIn("WILL_FAIL", text)

    def test_says_that_it_found_no_test(self):
        code, text = self.run_tests({"one": ("true", "")}, "-L", "none")
        self.assertEqual(code, 2, text)
        self.assertIn("found none", text)


if __name__ == "__main__":
    unittest.main()
