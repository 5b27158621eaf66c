#!/usr/bin/env python3
"""Counts the false alarms of `candela verify` on an unchanged program, with a fresh seed for each verdict.

    python3 tests/verify/calibrate.py --program build/release/candela [--icd FILE] [--verdicts 1000] [--alpha 0.05]
    python3 tests/verify/calibrate.py --program build/release/candela --sweep

Without --sweep: ten scenes of the project in turn. With it: every kind of `candela generate` at sizes up to some ten
thousand primitives, and the scenes of tests/scene/spd, by both integrators, once each. Exit code: 0 if the number of
alarms is one that the level explains (binomial, probability above 0.001), 1 otherwise, 2 if a run fails.
"""
import argparse
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["balls", "cornell", "depth_of_field", "lamp_over_plane", "mirror", "mirrors", "point_light", "primitives", "sky",
          "smallpt"]
KINDS = {"balls": (1, 2, 3, 4), "mount": (1, 3, 6), "tetra": (1, 3, 6), "rings": (1, 3, 7), "gears": (1, 2, 4),
         "tree": (1, 4, 8, 11), "jacks": (1, 2, 3), "lattice": (1, 4, 12), "shells": (1, 3, 5), "sombrero": (1, 2),
         "teapot": (1, 2, 6), "terrain": (2, 20, 70), "sphere": (1, 10, 40), "cornell": (1, 10, 29)}
IMPROBABLE = 0.001


@dataclass
class Run:
    scene: Path
    integrator: str
    seed: int

    def name(self):
        return f"{self.scene.stem} ({self.integrator}, seed {self.seed})"


def upper_tail(count, trials, probability):
    """Returns the probability of `count` or more successes."""
    log_factorial = math.lgamma
    return sum(math.exp(log_factorial(trials + 1) - log_factorial(k + 1) - log_factorial(trials - k + 1) +
                        k * math.log(probability) + (trials - k) * math.log1p(-probability))
               for k in range(count, trials + 1))


def verdict(options, run):
    """Returns the report of one run of verify."""
    command = [options.program, "verify", str(run.scene), "--size", options.size, "--seed", str(run.seed), "--alpha",
               str(options.alpha), "--integrator", run.integrator, "--json", "-", "-q"]
    if options.time_limit:
        command += ["--time-limit", options.time_limit]
    environment = {**os.environ, **({"VK_ICD_FILENAMES": options.icd} if options.icd else {})}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        print(f"{run.name()}: exit code {done.returncode}: {done.stderr.strip()}", file=sys.stderr)
        return None
    return json.loads(done.stdout)


def questions_missed(report):
    missed = [name for name, failed in (("paths", not report["samePaths"]["agrees"]),
                                        ("light", not report["sameLight"]["agrees"]),
                                        ("exact", not report.get("rightLight", {"agrees": True})["agrees"])) if failed]
    return missed


def seeded_runs(options):
    scenes = [ROOT / f"scenes/{name}.p3f" for name in SCENES]
    return [Run(scene, "path", options.first_seed + index)
            for index, scene in zip(range(options.verdicts), itertools.cycle(scenes))]


def sweep_runs(options, folder):
    scenes = sorted((ROOT / "tests/scene/spd").glob("*.nff"))
    for kind, sizes in KINDS.items():
        for size in sizes:
            scenes.append(folder / f"{kind}_{size}.nff")
            subprocess.run([options.program, "generate", kind, "--size", str(size), "-o", str(scenes[-1]), "-q"], check=True)
    seeds = itertools.count(options.first_seed)
    return [Run(scene, integrator, next(seeds)) for scene in scenes for integrator in ("path", "whitted")]


def execute(options, runs):
    alarms, failures = [], 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, (run, report) in enumerate(zip(runs, pool.map(lambda one: verdict(options, one), runs)), 1):
            failures += report is None
            missed = questions_missed(report) if report else []
            if missed:
                alarms.append(run)
                print(f"{run.name()}: {', '.join(missed)}: {report['verdict']}", flush=True)
            if number % 50 == 0:
                print(f"{number} verdicts, {len(alarms)} alarms", flush=True)
    probability = upper_tail(len(alarms), len(runs), options.alpha) if alarms else 1
    print(f"{len(runs)} verdicts at {options.size}, alpha {options.alpha:g}: {len(alarms)} alarms, {failures} runs failed; "
          f"as many or more have probability {probability:.3g} at most if every verdict's is alpha")
    if failures:
        return 2
    return 0 if probability > IMPROBABLE else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/candela"))
    parser.add_argument("--icd", help="driver file for VK_ICD_FILENAMES")
    parser.add_argument("--verdicts", type=int, default=1000)
    parser.add_argument("--alpha", type=float, default=0.05)
    parser.add_argument("--size", default="64x64")
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--time-limit", help="of each verdict, as verify has it")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--sweep", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        return execute(options, sweep_runs(options, Path(folder)) if options.sweep else seeded_runs(options))


if __name__ == "__main__":
    sys.exit(main())
