#!/usr/bin/env python3
"""Counts the false alarms of `candela conformance` on a driver whose faults are known.

    python3 tests/drivers/conformance/false_alarms.py --program build/release/candela [--icd FILE] [--seeds 200] [--alpha 0.05]
    python3 tests/drivers/conformance/false_alarms.py --program build/release/candela --whole-runs 20

The first line runs the cases that render pictures, which are decided by statistics, with a fresh seed for each run. The
second one runs all cases, as often as it says, and expects the results of the driver's baseline. Exit code: 0 if the
number of failures is one that the level explains (binomial, probability above 0.001), or no whole run is unexpected; 1
otherwise; 2 if a run fails.
"""
import argparse
import json
import os
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/judge/verify"))
from calibrate import IMPROBABLE, upper_tail  # noqa: E402

BASELINES = ROOT / "host/drivers/conformance/baselines"
COMPLETED = (0, 3)


def run_cases(options, arguments):
    """Returns the report of one run, or None if it did not complete."""
    command = [options.program, "conformance", "--json", "-", "-q", "--timeout", "240s", *arguments]
    if options.jobs:
        command += ["--jobs", options.jobs]
    for option in ("baseline", "skips"):
        if file := getattr(options, option):
            command += [f"--{option}", file if "/" in file else str(BASELINES / file)]
    environment = {**os.environ, **({"VK_ICD_FILENAMES": options.icd, "VK_DRIVER_FILES": options.icd} if options.icd else {})}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode not in COMPLETED:
        print(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr.strip()}", file=sys.stderr)
        return None
    return json.loads(done.stdout)


def unexpected(report):
    return [case for case in report["cases"] if case["result"] in ("Fail", "Crash", "Timeout", "UnexpectedImprovement(Pass)")]


def show(case, run):
    print(f"{run}: {case['result']} {case['name']}: {case['text'].splitlines()[0]}", flush=True)


def seeded(options):
    verdicts, failures = 0, Counter()
    for seed in range(options.first_seed, options.first_seed + options.seeds):
        report = run_cases(options, ["--cases", options.cases, "--seed", str(seed), "--alpha", str(options.alpha)])
        if report is None:
            return 2
        verdicts += sum(case["result"] != "Skip" for case in report["cases"])
        for case in unexpected(report):
            failures[case["name"]] += 1
            show(case, f"seed {seed}")
    count = failures.total()
    probability = upper_tail(count, verdicts, options.alpha) if count else 1
    print(f"{options.seeds} seeds, {verdicts} verdicts, alpha {options.alpha:g}: {count} failures, {verdicts * options.alpha:.0f} "
          f"permitted on average; as many or more have probability {probability:.3g} at most")
    return 0 if probability > IMPROBABLE else 1


def whole(options):
    bad, flakes, seconds = 0, 0, []
    for number in range(1, options.whole_runs + 1):
        start = time.monotonic()
        report = run_cases(options, ["--shuffle", str(number)])
        if report is None:
            return 2
        seconds.append(time.monotonic() - start)
        flakes += sum(case["result"] == "Flake" for case in report["cases"])
        failed = unexpected(report)
        bad += bool(failed)
        for case in failed:
            show(case, f"run {number}")
    print(f"{options.whole_runs} runs of {len(report['cases'])} cases in {min(seconds):.0f} to {max(seconds):.0f} s: "
          f"{bad} with unexpected results, {flakes} flakes")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/candela"))
    parser.add_argument("--icd", help="driver file for VK_ICD_FILENAMES")
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--alpha", type=float, default=0.05)
    parser.add_argument("--cases", default="kernel.*")
    parser.add_argument("--whole-runs", type=int, help="run all cases this often instead")
    parser.add_argument("--baseline", help="a file, or the name of a shipped one")
    parser.add_argument("--skips", help="a file, or the name of a shipped one")
    parser.add_argument("--jobs")
    options = parser.parse_args()
    return whole(options) if options.whole_runs else seeded(options)


if __name__ == "__main__":
    sys.exit(main())
