#!/usr/bin/env python3
"""Plants faults in a copy of the tree, one at a time, and reports which test layer finds each.

    python3 tests/mutants/run.py [--check] [--only REGEX] [--build DIR] [--work FILE] [--no-means] [--markdown FILE]

The faults are those of mutants.toml. Only the layers that could see a fault are built and run, on lavapipe, until one
fails. Results are appended to --work, and faults whose results it has are not planted again. --check plants nothing: it
says whether every edit still has its place. Exit code: 0 enough faults were found (or every edit has its place), 3 too
few, 1 usage, 2 the unchanged program does not pass.
"""
import argparse
import filecmp
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
import xml.etree.ElementTree as ElementTree
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIST = Path(__file__).with_name("mutants.toml")
REQUIRED_SHARE = 0.8
LAYER_SECONDS = 300  # a fault may make a loop endless


@dataclass
class Outcome:
    name: str
    side: str
    layer: str = ""  # that found the fault; empty: none did
    by: str = ""
    mean_change: float | None = None  # of the device's picture; None where the fault leaves no picture
    seconds: float = 0


def read_list():
    with LIST.open("rb") as file:
        content = tomllib.load(file)
    return content["layer"], content["mutant"]


def misplaced_edits(mutants):
    """The edits whose `find` text does not occur exactly once in its file."""
    problems = []
    for mutant in mutants:
        for edit in mutant["edits"]:
            count = (ROOT / edit["file"]).read_text().count(edit["find"])
            if count != 1:
                problems.append(f"{mutant['name']}: {edit['file']} has {count} times: {edit['find']}")
    return problems


def lavapipe_environment(folder: Path):
    """The environment of programs that run on lavapipe alone, with their cache in `folder`."""
    drivers = glob.glob("/usr/share/vulkan/icd.d/lvp_icd*.json")
    if not drivers:
        sys.exit("lavapipe is not installed: apt-get install mesa-vulkan-drivers")
    return os.environ | {"VK_DRIVER_FILES": drivers[0], "VK_ICD_FILENAMES": drivers[0],
                         "CANDELA_CACHE_DIR": str(folder / "cache")}


def plant(mutant, tree: Path):
    """Makes the edits of a fault in a copy of the tree."""
    for edit in mutant["edits"]:
        path = tree / edit["file"]
        path.write_text(path.read_text().replace(edit["find"], edit["replace"]))


class Workshop:
    """A copy of the tracked files, and its build."""

    def __init__(self, folder: Path, layers):
        self.source = folder / "source"
        self.build = folder / "build"
        self.layers = layers
        self.environment = lavapipe_environment(folder) | {"CANDELA_VALIDATION": "1"}

    def prepare(self):
        """Copies the tracked files that differ. Others keep their times, so that Ninja rebuilds what a fault changed."""
        tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        names = {name for name in tracked.split("\0") if name and (ROOT / name).is_file()}
        for path in [path for path in self.source.rglob("*") if path.is_file()]:
            if str(path.relative_to(self.source)) not in names:
                path.unlink()
        for name in names:
            target = self.source / name
            if not target.exists() or not filecmp.cmp(ROOT / name, target, shallow=False):
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / name, target)
                shutil.copymode(ROOT / name, target)
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"],
                       check=True, stdout=subprocess.DEVNULL)

    def restore(self, mutant):
        for edit in mutant["edits"]:
            shutil.copyfile(ROOT / edit["file"], self.source / edit["file"])

    def compile(self, target):
        """True if `target` builds; a fault that does not compile proves nothing."""
        return subprocess.run(["ninja", "-C", self.build, target], stdout=subprocess.DEVNULL).returncode == 0

    def run(self, command):
        try:
            return subprocess.run(command, cwd=self.source, env=self.environment, timeout=LAYER_SECONDS,
                                  capture_output=True, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            return None

    def find_fault(self, layer_name):
        """The failures of the layer; empty if there are none."""
        layer = self.layers[layer_name]
        if not self.compile(layer["target"]):
            raise RuntimeError(f"{layer['target']} does not compile")
        program = self.build / layer["program"]
        if "arguments" in layer:
            result = self.run([program, *layer["arguments"]])
            return "" if result and result.returncode == 0 else layer["arguments"][0]
        report = self.build / "mutant.xml"
        report.unlink(missing_ok=True)
        specification = ["-#", layer["tests"]] if "tests" in layer else []
        result = self.run([program, "--abort", "-r", "junit", "-o", report, *specification, "~[slow]"])
        if result is None:
            return f"no end within {LAYER_SECONDS} s"
        if result.returncode == 0:
            return ""
        return first_failure(report) or f"a crash (exit code {result.returncode})"

    def mean(self, scene, arguments):
        """Mean luminance of the device's picture, or None."""
        if not self.compile("candela"):
            return None
        result = self.run([self.build / "candela", "compare", self.source / "scenes" / scene, "--size", "96x96", "--spp",
                           "64", "--quiet", "--json", "-", *arguments])
        try:
            return json.loads(result.stdout)["mean"]["device"]
        except (AttributeError, KeyError, TypeError, json.JSONDecodeError):
            return None


def first_failure(report: Path):
    try:
        cases = ElementTree.parse(report).iter("testcase")
        return next((case.get("name") for case in cases if case.find("failure") is not None or case.find("error") is not None), "")
    except (ElementTree.ParseError, FileNotFoundError):
        return ""


def scene_of(mutant):
    return mutant.get("scene", "cornell.p3f"), mutant.get("arguments", [])


def examine(workshop: Workshop, mutant, means):
    outcome = Outcome(mutant["name"], mutant["side"])
    start = time.monotonic()
    plant(mutant, workshop.source)
    try:
        for layer in mutant["layers"]:
            outcome.by = workshop.find_fault(layer)
            if outcome.by:
                outcome.layer = layer
                break
        scene, arguments = scene_of(mutant)
        if (scene, *arguments) in means:
            mean = workshop.mean(scene, arguments)
            outcome.mean_change = None if mean is None else mean / means[scene, *arguments] - 1
    except RuntimeError as error:
        outcome.by = str(error)
    finally:
        workshop.restore(mutant)
    outcome.seconds = time.monotonic() - start
    return outcome


def require_soundness(workshop: Workshop, mutants):
    """Requires that the unchanged program passes every layer."""
    for layer in dict.fromkeys(layer for mutant in mutants for layer in mutant["layers"]):
        failure = workshop.find_fault(layer)
        if failure:
            print(f"the unchanged program fails in {layer}: {failure}", file=sys.stderr)
            sys.exit(2)


def means_by_scene(workshop: Workshop, mutants):
    return {(scene, *arguments): workshop.mean(scene, arguments) for scene, arguments in map(scene_of, mutants)}


def read_results(work: Path | None):
    if work is None or not work.exists():
        return []
    return [Outcome(**json.loads(line)) for line in work.read_text().splitlines()]


def percent(change):
    return "no picture" if change is None else f"{100 * change:+.2f} %"


def markdown(outcomes):
    lines = ["| fault | side | mean | found by |", "|---|---|---:|---|"]
    for o in outcomes:
        found = f"{o.layer}: {o.by}" if o.layer else "**nothing**"
        lines.append(f"| {o.name} | {o.side} | {percent(o.mean_change)} | {found} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only say whether every edit has its place")
    parser.add_argument("--only", default="", metavar="REGEX", help="only faults whose name has this")
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "mutants", metavar="DIR")
    parser.add_argument("--work", type=Path, metavar="FILE", help="results as JSON, one a line")
    parser.add_argument("--no-means", action="store_true", help="do not render the picture of each fault")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table here")
    options = parser.parse_args()

    layers, mutants = read_list()
    problems = misplaced_edits(mutants)
    print("\n".join(problems) if problems else f"{len(mutants)} faults, every edit has its place")
    if options.check or problems:
        return 1 if problems else 0

    outcomes = read_results(options.work)
    done_before = {(o.name, o.side) for o in outcomes}
    chosen = [mutant for mutant in mutants
              if re.search(options.only, mutant["name"]) and (mutant["name"], mutant["side"]) not in done_before]
    workshop = Workshop(options.build, layers)
    workshop.prepare()
    require_soundness(workshop, chosen)
    means = {} if options.no_means else means_by_scene(workshop, chosen)
    for mutant in chosen:
        o = examine(workshop, mutant, means)
        outcomes.append(o)
        print(f"{o.seconds:5.0f} s  {percent(o.mean_change):>10}  {o.layer or 'NOT FOUND':12}  {o.name}  [{o.by}]", flush=True)
        if options.work:
            with options.work.open("a") as file:
                file.write(json.dumps(asdict(o)) + "\n")
    found = sum(1 for o in outcomes if o.layer)
    print(f"{found} of {len(outcomes)} found, {sum(o.seconds for o in outcomes) / 60:.0f} minutes")
    if options.markdown:
        options.markdown.write_text(markdown(outcomes))
    return 0 if found >= REQUIRED_SHARE * len(outcomes) else 3


if __name__ == "__main__":
    sys.exit(main())
