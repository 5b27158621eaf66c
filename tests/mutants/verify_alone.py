#!/usr/bin/env python3
"""Counts the planted faults that `candela verify` finds without any other test.

    python3 tests/mutants/verify_alone.py --checkout DIR --models DIR [--sample N] [--seed N] [--markdown FILE]

The faults are those of mutants.toml that change the light of the default kernel on one side. Each is planted in a clean
checkout whose folder build/release is configured (another git worktree, say), and only the program is built. Scenes that
show the material are verified at 64 x 64 until one differs; at last the first scene at its own size. --models has
Khronos' sample models of glTF. Exit code: 0 at least four in five were found, 3 fewer, 1 usage.
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from run import REQUIRED_SHARE, ROOT, lavapipe_environment, plant, read_list
from verify_scenes import GENERATED, SCENES, TOUCHING, lamps, scenes_of

RUN_SECONDS = 300  # a fault may make a loop endless
# Code that the default kernel does not execute, or that does not change the light.
OTHER_CODE = re.compile(r"wave_|shaders/bvh\.glsl|path_state|command_recorder|gpu_session|layers|lanes")
OTHER_LIGHT = ["light that was scattered once is limited", "the film's second moment is its first", "layers: ", "alpha: ",
               "backdrops: ", "mattes: ", "orthographic"]


def is_eligible(mutant):
    others = any(OTHER_CODE.search(edit["file"]) for edit in mutant["edits"]) or any(
        mutant["name"].startswith(name) for name in OTHER_LIGHT)
    return mutant["side"] in ("device", "reference", "flatten") and mutant["layers"][0] in SCENES and not others


@dataclass
class Outcome:
    mutant: dict
    scene: str = ""  # in which it was found; empty: in none
    question: str = ""
    p_value: float = 1
    difference: float = 0  # of the image mean, relative


class Bench:
    """A checkout in which faults are planted, and the scenes."""

    def __init__(self, options, folder: Path):
        self.checkout, self.models, self.folder = options.checkout, options.models, folder
        self.program = self.checkout / "build/release/candela"
        self.environment = lavapipe_environment(folder)
        self.require_clean_checkout()
        if not self.build():
            sys.exit(f"{self.checkout}/build/release: candela does not build; configure it with cmake --preset release")
        self.make_scenes()

    def require_clean_checkout(self):
        status = subprocess.run(["git", "status", "--porcelain", "-uno"], cwd=self.checkout, capture_output=True, text=True,
                                check=False)
        if status.returncode:
            sys.exit(f"--checkout {self.checkout}: {status.stderr.strip()}")
        if status.stdout:
            sys.exit(f"{self.checkout} has uncommitted changes: faults are planted in a clean checkout only")

    def build(self):
        command = ["cmake", "--build", "build/release", "-j", "1", "--target", "candela"]
        return subprocess.run(command, cwd=self.checkout, stdout=subprocess.DEVNULL, check=False).returncode == 0

    def make_scenes(self):
        (self.folder / "touching.p3f").write_text(TOUCHING)
        (self.folder / "lamps.gltf").write_text(json.dumps(lamps()))
        for kind in GENERATED:
            subprocess.run([self.program, "generate", kind, "--size", "8", "-o", self.folder / f"{kind}.gltf", "-q"], check=True)

    def path(self, scene):
        place, name = scene.split("/", maxsplit=1)
        if place == "models":
            return next(file for file in sorted((self.models / name).iterdir()) if file.suffix in (".glb", ".gltf"))
        if place in ("made", "generated"):
            return self.folder / (name if "." in name else f"{name}.gltf")
        return ROOT / scene

    def verify(self, scene, words):
        """Returns verify's report, or the exit code if there is none."""
        command = [self.program, "verify", self.path(scene), *words, "--json", "-", "-q"]
        try:
            done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=RUN_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return "no end"
        return json.loads(done.stdout) if done.returncode in (0, 3, 8) else f"exit code {done.returncode}"


def judged(outcome, scene, report):
    """Notes what a report says, and returns whether it has a verdict against the program."""
    if isinstance(report, str):
        outcome.question = report
        return False
    image = report["sameLight"]["regions"][0]
    outcome.difference = image["difference"] / image["reference"] if image["reference"] else 0
    if report["agrees"] is not False:
        return False
    outcome.scene = scene
    questions = [number for number, failed in (("1", report["samePaths"]["agrees"] is False), ("2", report["sameLight"]["agrees"] is False),
                                               ("3", report.get("rightLight", {"agrees": True})["agrees"] is False)) if failed]
    outcome.question = ", ".join(questions)
    return True


def attempts(mutant):
    scenes = scenes_of(mutant)
    own = f"scenes/{mutant.get('scene', '')}"
    ordered = sorted(scenes, key=lambda scene: scene[0] != own)
    return [(scene, [*words, "--size", "64x64"]) for scene, words in ordered] + [ordered[0]]


def examine(bench: Bench, mutant):
    outcome = Outcome(mutant)
    saved = {file: file.read_text() for file in {bench.checkout / edit["file"] for edit in mutant["edits"]}}
    try:
        plant(mutant, bench.checkout)
        if not bench.build():
            raise RuntimeError(f"{mutant['name']}: does not compile")
        for scene, words in attempts(mutant):
            if judged(outcome, scene, bench.verify(scene, words)):
                break
    finally:
        for file, text in saved.items():
            file.write_text(text)
    return outcome


def row(outcome):
    found = f"question {outcome.question}" if outcome.scene else f"**not found** {outcome.question}".strip()
    scene = outcome.scene.split("/")[-1] or "all"
    return f"| {outcome.mutant['name']} | {outcome.mutant['side']} | {scene} | {100 * outcome.difference:+.3g} % | {found} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--checkout", type=Path, required=True, metavar="DIR", help="a clean checkout in which to plant")
    parser.add_argument("--models", type=Path, required=True, metavar="DIR", help="Khronos' glTF-Sample-Assets/Models")
    parser.add_argument("--sample", type=int, metavar="N", help="a random sample of the faults")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--only", default="", metavar="REGEX", help="only faults whose name has this")
    parser.add_argument("--list", action="store_true", help="only list the faults")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table here")
    options = parser.parse_args()

    eligible = [mutant for mutant in read_list()[1] if is_eligible(mutant)]
    chosen = random.Random(options.seed).sample(eligible, options.sample) if options.sample else eligible
    chosen = [mutant for mutant in chosen if re.search(options.only, mutant["name"])]
    print(f"{len(eligible)} faults change the light of the default kernel on one side; {len(chosen)} are planted", flush=True)
    if options.list:
        print("\n".join(f"{mutant['side']:10} {mutant['layers'][0]:26} {mutant['name']}" for mutant in chosen))
        return 0
    lines = ["| fault | side | scene | image mean | found by |", "|---|---|---|---:|---|"]
    found = 0
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, Path(folder))
        for mutant in chosen:
            outcome = examine(bench, mutant)
            found += outcome.scene != ""
            lines.append(row(outcome))
            print(lines[-1], flush=True)
    print(f"{found} of {len(chosen)} found")
    if options.markdown:
        options.markdown.write_text("\n".join(lines) + "\n")
    return 0 if found >= REQUIRED_SHARE * len(chosen) else 3


if __name__ == "__main__":
    sys.exit(main())
