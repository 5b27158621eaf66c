#!/usr/bin/env python3
"""Counts the false alarms, and the verdicts that are not decided, of `candela verify` on an unchanged program, with a fresh seed each.

    python3 tests/judge/verify/calibrate.py --program build/release/candela [--icd FILE] [--verdicts 1000] [--alpha 0.05]
    python3 tests/judge/verify/calibrate.py --program build/release/candela --sweep [FAMILY ...]

Without --sweep: ten scenes of the project in turn. With it, once each: every kind of `candela generate` at sizes up to
some ten thousand primitives (family generated) and the scenes of tests/formats/nff/spd (spd), by both integrators; rooms with a
mirror ball, 10^3 to 10^6 from the origin, whose light is free or touches a wall, a corner or the ball (translated), by
both integrators; and the glTF scenes of `candela generate` (gltf). The family large, which takes minutes, must be named: every
kind at a size of up to a million primitives, by both integrators. Exit code: 0 if the number of
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

ROOT = Path(__file__).resolve().parents[3]
SCENES = ["balls", "cornell", "depth_of_field", "lamp_over_plane", "mirror", "mirrors", "point_light", "primitives", "sky",
          "smallpt"]
KINDS = {"balls": (1, 2, 3, 4), "mount": (1, 3, 6), "tetra": (1, 3, 6), "rings": (1, 3, 7), "gears": (1, 2, 4),
         "tree": (1, 4, 8, 11), "jacks": (1, 2, 3), "lattice": (1, 4, 12), "shells": (1, 3, 5), "sombrero": (1, 2),
         "teapot": (1, 2, 6), "terrain": (2, 20, 70), "sphere": (1, 10, 40), "cornell": (1, 10, 29)}
LARGE_SIZES = {"balls": 6, "mount": 9, "tetra": 9, "rings": 30, "gears": 12, "tree": 16, "jacks": 6, "lattice": 50, "shells": 10,
               "sombrero": 4, "teapot": 50, "terrain": 700, "sphere": 300, "cornell": 60}
DEFAULT_FAMILIES = ("spd", "generated", "translated", "gltf")
FAMILIES = (*DEFAULT_FAMILIES, "large")
GLTF_KINDS = ("material-table", "material-furnace", "brushed-table", "brilliants", "still-life")
DISTANCES = (1e3, 1e4, 1e5, 1e6)
LIGHTS = {"free": (1, -1, 2), "wall": (0, -4, 1), "corner": (4, 4, 4), "ball": (0.54, 0, 0.72)}
IMPROBABLE = 0.001
UNDECIDED = 8  # exit code


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
    if done.returncode not in (0, 3, UNDECIDED):
        print(f"{run.name()}: exit code {done.returncode}: {done.stderr.strip()}", file=sys.stderr)
        return None
    return json.loads(done.stdout)


def questions_missed(report):
    missed = [name for name, failed in (("paths", report["samePaths"]["agrees"] is False),
                                        ("light", report["sameLight"]["agrees"] is False),
                                        ("exact", report.get("rightLight", {"agrees": True})["agrees"] is False)) if failed]
    return missed


def seeded_runs(options):
    scenes = [ROOT / f"scenes/{name}.p3f" for name in SCENES]
    return [Run(scene, "path", options.first_seed + index)
            for index, scene in zip(range(options.verdicts), itertools.cycle(scenes))]


def room(light, distance):
    """Returns the NFF text of a glossy room of side 8 with a mirror ball of radius 0.9, translated along a diagonal."""
    centre = (distance, distance, -distance)

    def at(*point):
        return " ".join(repr(c + p) for c, p in zip(centre, point))
    text = (f"v\nfrom {at(0.5, -3, 0.7)}\nat {at(0, 0, 0)}\nup 0 0 1\nangle 60\nhither 0.01\nresolution 64 64\nb 0 0 0\n"
            f"l {at(*light)} 1 1 1\nf 0.8 0.7 0.6 0.9 0.1 10 0 1\n")
    for axis in range(3):
        for side in (-4, 4):
            corners = [[a, b] for a, b in ((-4, -4), (4, -4), (4, 4), (-4, 4))]
            text += "p 4\n" + "".join(at(*corner[:axis], side, *corner[axis:]) + "\n" for corner in corners)
    return text + f"f 0.2 0.7 0.6 0.1 0.9 100 0 1\ns {at(0, 0, 0)} 0.9\n"


def generate(options, kind, size, scene):
    subprocess.run([options.program, "generate", kind, *size, "-o", str(scene), "-q"], check=True)
    return scene


def family_scenes(options, family, folder):
    if family == "spd":
        return sorted((ROOT / "tests/formats/nff/spd").glob("*.nff"))
    if family == "generated":
        return [generate(options, kind, ["--size", str(size)], folder / f"{kind}_{size}.nff")
                for kind, sizes in KINDS.items() for size in sizes]
    if family == "large":
        return [generate(options, kind, ["--size", str(size)], folder / f"{kind}_{size}.nff") for kind, size in LARGE_SIZES.items()]
    if family == "gltf":
        return [generate(options, kind, [], folder / f"{kind}.gltf") for kind in GLTF_KINDS]
    scenes = []
    for (name, light), distance in itertools.product(LIGHTS.items(), DISTANCES):
        scenes.append(folder / f"{name}_{distance:g}.nff")
        scenes[-1].write_text(room(light, distance), encoding="utf-8")
    return scenes


def sweep_runs(options, folder):
    seeds = itertools.count(options.first_seed)
    return [Run(scene, integrator, next(seeds)) for family in options.sweep or DEFAULT_FAMILIES
            for scene in family_scenes(options, family, folder)
            for integrator in (("path",) if family == "gltf" else ("path", "whitted"))]


def execute(options, runs):
    alarms, failures, undecided = [], 0, 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, (run, report) in enumerate(zip(runs, pool.map(lambda one: verdict(options, one), runs)), 1):
            failures += report is None
            missed = questions_missed(report) if report else []
            if missed:
                alarms.append(run)
                print(f"{run.name()}: {', '.join(missed)}: {report['verdict']}", flush=True)
            if report and report["undecided"]:
                undecided += 1
                print(f"{run.name()}: {report['undecided']['reason']}: {report['verdict']}", flush=True)
            if number % 50 == 0:
                print(f"{number} verdicts, {len(alarms)} alarms", flush=True)
    probability = upper_tail(len(alarms), len(runs), options.alpha) if alarms else 1
    print(f"{len(runs)} verdicts at {options.size}, alpha {options.alpha:g}: {len(alarms)} alarms, {undecided} not decided, {failures} runs failed; "
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
    parser.add_argument("--sweep", nargs="*", choices=FAMILIES, metavar="FAMILY", help="families of scenes; none: all but large")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        return execute(options, sweep_runs(options, Path(folder)) if options.sweep is not None else seeded_runs(options))


if __name__ == "__main__":
    sys.exit(main())
