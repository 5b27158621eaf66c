#!/usr/bin/env python3
"""Compiles our shaders for eight GPUs that need not exist, and compares the figures of kernels with recorded ones.

    python3 tests/drivers/kernels/gpu_compilers.py make --root ROOT [--mirror URL]
    python3 tests/drivers/kernels/gpu_compilers.py check --root ROOT --program PROGRAM [--reports FOLDER] [--models FOLDER]
    python3 tests/drivers/kernels/gpu_compilers.py record --root ROOT --program PROGRAM [--replace]
    python3 tests/drivers/kernels/gpu_compilers.py check|record|table --reports FOLDER --reuse

ROOT is the folder of a Debian unstable system, whose Mesa has the stand-ins for GPUs that docs/kernels.md describes. `make`
makes it with debootstrap. All commands that use it need the rights of root, for chroot. The program of this build is
copied into the system for the time of a run, with the libraries that the system lacks.

Each scene is a process of its own, `candela kernels SCENE --all-kernels` with the validation layer. A scene fails if the program
ends with another exit code than 0, which includes any message of the layer, or if it takes longer than --timeout.
--failures FOLDER gets a folder for each failure: the scene, what was printed, the command, and the program that `candela capture` writes
of the scene on a driver of this machine. What drivers print otherwise is listed, with the number of times.

The scenes are those of scenes/, some of them with other structures, and what `candela generate` writes: many features of
glTF. --models adds the glTF files below a folder: they must compile, but their figures are not recorded.

The shaders of the conformance cases are compiled, too, by `candela conformance --compile-only`, which runs every case in a
child process; with --variants, so are the variants of shaders. They must compile, and have no figures. --cases "^conformance"
chooses them alone.

gpu_compilers.json has the figures, one line for each kernel: occupancy, spills to memory, spills to registers, registers,
instructions, or null where the driver does not report one. Its first key is the version of Mesa, because each has other
compilers; with a version that is not recorded, nothing is compared. A kernel is worse if its occupancy falls at all, or if spills or
instructions rise by more than --threshold, or from zero. `record` adds figures, but replaces them only with --replace. It changes no
figures of other GPUs than --gpus chooses, and none of other scenes than --cases chooses.
--reports FOLDER keeps what was reported; with --reuse, it is read from there and nothing is compiled.

`table` prints the tables of docs/kernels.md.
Exit code: 0 all kernels compile and none became worse, 1 not, 2 usage, 77 skipped: no such root, no rights, or no recorded figures.
"""
import argparse
import collections
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[3]
BASELINE = Path(__file__).with_name("gpu_compilers.json")
SKIP = 77  # SKIP_RETURN_CODE in CMakeLists.txt
PACKAGES = ["mesa-vulkan-drivers", "mesa-drm-shim", "libvulkan1", "vulkan-validationlayers"]
FIGURES = ["occupancyFraction", "spillsToMemory", "spillsToRegisters", "registers", "instructions"]
RISING_IS_WORSE = {"spillsToMemory", "spillsToRegisters", "instructions"}

Gpu = collections.namedtuple("Gpu", "name title driver shim variables")
GPUS = [
    Gpu("navi21", "RX 6800 (navi21)", "radeon", "amdgpu", {"AMDGPU_GPU_ID": "navi21"}),
    Gpu("navi31", "RX 7900 XTX (navi31)", "radeon", "amdgpu", {"AMDGPU_GPU_ID": "navi31"}),
    Gpu("gfx1201", "RX 9070 XT (gfx1201)", "radeon", "amdgpu", {"AMDGPU_GPU_ID": "gfx1201"}),
    Gpu("tu102", "TU102 (0x162)", "nouveau", "nouveau", {"NOUVEAU_CHIPSET": "0x162"}),
    Gpu("ga102", "GA102 (0x172)", "nouveau", "nouveau", {"NOUVEAU_CHIPSET": "0x172"}),
    Gpu("a660", "Adreno 660", "freedreno", "freedreno", {"FD_GPU_ID": "660"}),
    Gpu("a740", "Adreno 740", "freedreno", "freedreno", {"FD_GPU_ID": "740"}),
    Gpu("m1", "M1", "asahi", "asahi", {}),
]

# A case is a scene with options. `recorded`: its figures belong into the baseline.
Case = collections.namedtuple("Case", "name scene options recorded")
VARIANTS = [
    ("cornell.p3f", ["--layout", "bvh2"]),
    ("cornell.p3f", ["--accel", "grid"]),
    ("cornell.p3f", ["--accel", "none"]),
    ("cornell.p3f", ["--loads", "storage"]),
    ("cornell.p3f", ["--aov", "all"]),
    ("primitives.p3f", ["--accel", "grid"]),
    ("primitives.p3f", ["--integrator", "whitted"]),
]
GENERATED = [  # kind of `candela generate`, size, options
    ("material-table", 8, []),
    ("material-furnace", 8, ["--env", "white"]),
    ("brushed-table", 8, []),
    ("brilliants", 8, []),
    ("still-life", 8, ["--env", "sun:30,0,3"]),
    ("forest", 10, ["--env", "sun:30,0,3"]),
    ("street", 8, ["--lights", "tree"]),
]


class Failure(Exception):
    """The system could not be made, or the program could not be brought into it."""


def make(options):
    if os.geteuid() != 0:
        raise Failure("debootstrap needs the rights of root")
    if not shutil.which("debootstrap"):
        raise Failure("debootstrap is not installed: apt-get install debootstrap")
    subprocess.run(["debootstrap", "--variant=minbase", "sid", str(options.root), options.mirror], check=True)
    unattended = ["chroot", str(options.root), "env", "DEBIAN_FRONTEND=noninteractive", "LC_ALL=C", "apt-get"]
    subprocess.run([*unattended, "update"], check=True)
    subprocess.run([*unattended, "install", "--yes", "--no-install-recommends", *PACKAGES], check=True)
    print(f"{options.root} is ready")
    return 0


def missing_libraries(program, root):
    """The libraries of the program that the root lacks."""
    found = subprocess.run(["ldd", str(program)], capture_output=True, text=True, check=True).stdout
    libraries = re.findall(r"^\s*(\S+) => (/\S+)", found, re.MULTILINE)
    return [path for name, path in libraries if not any((root / "usr/lib").glob(f"*/{name}"))]


class Machine:
    """The program in the root, in a folder that is removed afterwards."""

    def __init__(self, options):
        self.options = options
        self.root = options.root.resolve()
        self.folder = Path(tempfile.mkdtemp(prefix="candela-kernels-", dir=self.root / "tmp"))
        (self.folder / "lib").mkdir()
        shutil.copy(options.program, self.folder / "candela")
        for library in missing_libraries(options.program, self.root):
            shutil.copy(library, self.folder / "lib")

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        shutil.rmtree(self.folder)

    def cases(self):
        """All cases, whose scenes are copied into the root or generated there."""
        shutil.copytree(SOURCE / "scenes", self.folder / "scenes")
        scenes = self.folder / "scenes"
        cases = [Case(scene.name, scene, [], True) for scene in sorted(scenes.glob("*.p3f"))]
        cases += [Case(" ".join([name, *words]), scenes / name, words, True) for name, words in VARIANTS]
        for kind, size, words in GENERATED:
            scene = scenes / f"{kind}.gltf"
            command = [str(self.options.program), "generate", kind, "--size", str(size), "-q", "-o", str(scene)]
            subprocess.run(command, check=True)
            cases.append(Case(kind, scene, words, True))
        if self.options.models:
            models = self.folder / "models"
            shutil.copytree(self.options.models, models)
            files = sorted(file for end in ("*.gltf", "*.glb") for file in models.rglob(end))
            cases += [Case(str(file.relative_to(models)), file, [], False) for file in files]
        return [case for case in cases if re.search(self.options.cases, case.name)]

    def inside(self, path):
        return "/" + str(path.relative_to(self.root))

    def program_on(self, gpu):
        """The words that start the program in the root, on the GPU."""
        variables = {
            "LD_LIBRARY_PATH": self.inside(self.folder / "lib"),
            "LD_PRELOAD": f"lib{gpu.shim}_noop_drm_shim.so",
            "VK_DRIVER_FILES": f"/usr/share/vulkan/icd.d/{gpu.driver}_icd.json",
            "CANDELA_VALIDATION": "1",
            "HOME": "/tmp",
            "PATH": "/usr/bin",
        } | gpu.variables
        return ["chroot", str(self.root), "/usr/bin/env", "-i", *(f"{name}={value}" for name, value in variables.items()),
                self.inside(self.folder / "candela")]

    def command(self, gpu, case):
        return [*self.program_on(gpu), "kernels", self.inside(case.scene), "--all-kernels", "--untuned", "--no-cache", "--quiet",
                "--json", "-", *case.options]

    def report(self, gpu, case):
        """What came of one scene: the JSON document, or None, and what was printed besides."""
        try:
            done = subprocess.run(self.command(gpu, case), capture_output=True, text=True, errors="replace",
                                  timeout=self.options.timeout)
        except subprocess.TimeoutExpired:
            return None, f"not finished after {self.options.timeout} s"
        if done.returncode != 0:
            return None, f"exit code {done.returncode}\n{done.stderr.strip()}"
        return json.loads(done.stdout), done.stderr

    def conformance_command(self, gpu, options):
        seconds = f"{self.options.timeout:g}s"
        return [*self.program_on(gpu), "conformance", "--compile-only", "--jobs", "1", "--timeout", seconds, "--quiet", *options]

    def conformance(self, gpu, options):
        """The report of all conformance cases, and what was printed besides."""
        done = subprocess.run([*self.conformance_command(gpu, options), "--json", "-"], capture_output=True, text=True,
                              errors="replace")
        try:
            return json.loads(done.stdout), done.stderr
        except ValueError as error:
            raise Failure(f"{gpu.name}, conformance: exit code {done.returncode}\n{done.stderr.strip()}") from error

    def failure_folder(self, gpu, name, text, command, cases):
        """A folder with what was printed, and the commands that repeat a failure. `cases`: the words for --cases."""
        folder = self.options.failures / gpu.name / re.sub(r"[^\w.-]+", "_", name)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "printed.txt").write_text(text + "\n")
        again = ["python3", str(Path(__file__).resolve()), "check", "--root", str(self.root), "--program",
                 str(self.options.program.resolve()), "--gpus", gpu.name, "--cases", *cases]
        if self.options.models:
            again += ["--models", str(self.options.models.resolve())]
        (folder / "again.sh").write_text(f"# The whole command, and the one that it runs in the root.\n{shlex.join(again)}\n"
                                         f"# {shlex.join(command)}\n")
        return folder

    def capture(self, folder, words):
        """The program that `candela capture` writes on a driver of this machine."""
        shutil.rmtree(folder / "capture", ignore_errors=True)
        capture = [str(self.options.program), "capture", *words, "-q", "-o", str(folder / "capture")]
        done = subprocess.run(capture, capture_output=True, text=True)
        if done.returncode != 0:
            (folder / "no_capture.txt").write_text(f"{shlex.join(capture)}\nexit code {done.returncode}\n{done.stderr}")

    def keep_case(self, gpu, name, text):
        """What repeats the failure of a conformance case."""
        words = ["--variants"] if name.startswith("variants.") else []
        command = self.conformance_command(gpu, ["--cases", name, *words])
        self.capture(self.failure_folder(gpu, f"conformance {name}", text, command, ["^conformance$", *words]), [name])

    def keep_failure(self, gpu, case, text):
        """What repeats the failure of a scene."""
        folder = self.failure_folder(gpu, case.name, text, self.command(gpu, case), [f"^{re.escape(case.name)}$"])
        shutil.copy(case.scene, folder)
        unused = {"--aov": 1}  # options that captures do not have
        words = [word for index, word in enumerate(case.options)
                 if word not in unused and (index == 0 or case.options[index - 1] not in unused)]
        self.capture(folder, [str(case.scene), *words])


def compile_all(options):
    """Compiles all cases on all GPUs: {GPU: {"driver", "device", "cases": {name: rows, or None if it failed}, "notices"}}."""
    reports = {}
    with Machine(options) as machine:
        cases = machine.cases()
        for gpu in chosen_gpus(options):
            result = {"device": "", "driver": "", "cases": {}, "recorded": [], "conformance": {}, "notices": collections.Counter()}
            for case in cases:
                document, printed = machine.report(gpu, case)
                if case.recorded:
                    result["recorded"].append(case.name)
                result["cases"][case.name] = document and document["rows"]
                if document is None:
                    print(f"FAILED: {gpu.name}, {case.name}: {printed}", flush=True)
                    if options.failures:
                        machine.keep_failure(gpu, case, printed)
                    continue
                result["device"], result["driver"] = document["device"], document["driver"]
                add_notices(result, printed)
            compile_conformance(options, machine, gpu, result)
            reports[gpu.name] = result
            if options.reports:
                options.reports.mkdir(parents=True, exist_ok=True)
                (options.reports / f"{gpu.name}.json").write_text(json.dumps(result, indent=1) + "\n")
            print_summary(gpu.name, result)
    return reports


def add_notices(result, printed):
    result["notices"].update(re.sub(r"0x[0-9a-f]+", "0x...", line) for line in printed.splitlines() if line.strip())


def compile_conformance(options, machine, gpu, result):
    """Adds the results of the conformance cases."""
    for words in [[]] + [["--variants"]] * options.variants:
        if not re.search(options.cases, "conformance"):
            return
        report, printed = machine.conformance(gpu, words)
        result["device"], result["driver"] = report["device"], report["driver"]
        add_notices(result, printed)
        for case in report["cases"]:
            name, outcome = case["name"], case["result"]
            result["conformance"][name] = outcome
            if outcome in ("Pass", "Skip"):
                continue
            print(f"FAILED: {gpu.name}, conformance case {name}: {outcome}: {case['text']}", flush=True)
            if options.failures:
                machine.keep_case(gpu, name, f"{outcome}: {case['text']}")


def print_summary(gpu, result):
    failed = sum(rows is None for rows in result["cases"].values())
    kernels = sum(len(rows or []) for rows in result["cases"].values())
    print(f"{gpu}: {result['device']}, {result['driver']}: {kernels} kernels of {len(result['cases'])} scenes compiled, "
          f"{failed} scenes failed", flush=True)
    counts = collections.Counter(result["conformance"].values())
    if counts:
        print(f"{gpu}: conformance cases compiled: " + ", ".join(f"{name} {count}" for name, count in sorted(counts.items())))
    for notice, count in sorted(result["notices"].items()):
        print(f"  the driver prints {count} times: {notice}", flush=True)


def chosen_gpus(options):
    return [gpu for gpu in GPUS if not options.gpus or gpu.name in options.gpus.split(",")]


def load_reports(options):
    files = {gpu.name: options.reports / f"{gpu.name}.json" for gpu in chosen_gpus(options)}
    return {name: json.loads(file.read_text()) for name, file in files.items() if file.exists()}


def mesa_version(reports):
    versions = {match[1] for result in reports.values() if (match := re.search(r"Mesa (\d+\.\d+\.\d+)", result["driver"]))}
    if len(versions) != 1:
        raise Failure(f"the reports have {len(versions)} versions of Mesa: {sorted(versions)}")
    return versions.pop()


def figures_of(result):
    """{"scene: kernel": [figures]} of the cases that are recorded."""
    return {f"{name}: {row['kernel']}": [row[figure] for figure in FIGURES]
            for name in result["recorded"] for row in result["cases"].get(name) or []}


def chosen_rows(rows, options):
    """The rows of the scenes that --cases chooses."""
    return {name: row for name, row in rows.items() if re.search(options.cases, name.rsplit(": ", 1)[0])}


def changes(old, new, threshold):
    """[(figure, old value, new value, whether it is worse)] of one kernel."""
    found = []
    for figure, before, after in zip(FIGURES, old, new):
        if before == after:
            continue
        if before is None or after is None:
            worse = after is None
        elif figure == "occupancyFraction":
            worse = after < before
        else:
            worse = figure in RISING_IS_WORSE and after > before * (1 + threshold)
        found.append((figure, before, after, worse))
    return found


def compare(recorded, reports, options):
    """Prints what changed. Returns the number of kernels that became worse or are missing on either side."""
    problems = compared = 0
    for gpu, result in reports.items():
        old, new = (chosen_rows(rows, options) for rows in (recorded.get(gpu, {}), figures_of(result)))
        failed = {name for name, rows in result["cases"].items() if rows is None}  # already printed
        for name in old:
            if name in new:
                compared += 1
                found = changes(old[name], new[name], options.threshold)
                problems += any(worse for *_, worse in found)
                for figure, before, after, worse in found:
                    print(f"{'FAILED' if worse else 'changed'}: {gpu}, {name}: {figure} was {before}, is {after}")
            elif name.rsplit(": ", 1)[0] not in failed:
                problems += 1
                print(f"FAILED: {gpu}, {name}: figures are recorded, but there is no such kernel")
        for name in new.keys() - old.keys():
            problems += 1
            print(f"FAILED: {gpu}, {name}: no figures are recorded")
    print(f"{compared} kernels compared, {problems} became worse or have no counterpart")
    return problems


def load_baseline():
    return json.loads(BASELINE.read_text()) if BASELINE.exists() else {}


def baseline_text(baseline):
    """JSON with one line for each kernel."""
    versions = []
    for version, gpus in sorted(baseline.items()):
        parts = []
        for gpu, rows in gpus.items():
            lines = ",\n".join(f"   {json.dumps(name)}: {json.dumps(row)}" for name, row in rows.items())
            parts.append(f"  {json.dumps(gpu)}: {{\n{lines}\n  }}")
        joined = ",\n".join(parts)
        versions.append(f" {json.dumps(version)}: {{\n{joined}\n }}")
    joined = ",\n".join(versions)
    return f"{{\n{joined}\n}}\n"


def failed_cases(reports):
    """The number of scenes and conformance cases that did not compile."""
    scenes = sum(rows is None for result in reports.values() for rows in result["cases"].values())
    return scenes + sum(outcome not in ("Pass", "Skip") for result in reports.values()
                        for outcome in result["conformance"].values())


def check(options, reports):
    failed = failed_cases(reports)
    version = mesa_version(reports)
    recorded = load_baseline().get(version)
    if recorded is None:
        print(f"No figures were compared, because {BASELINE.name} has none of Mesa {version}; `record` adds them.")
        return 1 if failed else SKIP
    return 1 if compare(recorded, reports, options) or failed else 0


def record(options, reports):
    if failed_cases(reports):
        print("nothing is recorded, because scenes or conformance cases failed")
        return 1
    version = mesa_version(reports)
    baseline = load_baseline()
    recorded = baseline.setdefault(version, {})
    for gpu, result in reports.items():
        all_rows = recorded.get(gpu, {})
        old, new = (chosen_rows(rows, options) for rows in (all_rows, figures_of(result)))
        changed = [name for name, row in old.items() if new.get(name) != row]
        if changed and not options.replace:
            print(f"{gpu}: these figures would change or go; nothing is recorded without --replace:", *changed, sep="\n  ")
            return 1
        recorded[gpu] = {name: row for name, row in all_rows.items() if name not in old or name in new} | new
    BASELINE.write_text(baseline_text(baseline))
    print(f"Mesa {version}: {sum(map(len, recorded.values()))} kernels on {len(recorded)} GPUs")
    return 0


def cell(rows):
    """The worst figures of some kernels: occupancy, spills to memory, instructions."""
    if not rows:
        return "–"
    spills = [row["spillsToMemory"] for row in rows if row["spillsToMemory"] is not None]
    return (f"{100 * min(row['occupancyFraction'] for row in rows):.1f} %; {max(spills, default=0):,.0f}; "
            f"{max(row['instructions'] for row in rows):,.0f}")


def table(options, reports):
    """Prints the worst figures of each kernel of all scenes, and those of the megakernel for each scene."""
    titles = {gpu.name: gpu.title for gpu in GPUS}
    rule = "|---|" + "---:|" * len(reports)

    def head(first):
        print(f"| {first} | " + " | ".join(titles[gpu] for gpu in reports) + " |\n" + rule)

    def rows_of(result, kernel, case=None):
        return [row for name in result["recorded"] if case in (None, name) for row in result["cases"][name] or []
                if row["kernel"] == kernel]

    first = next(iter(reports.values()))
    kernels = list(dict.fromkeys(row["kernel"] for rows in first["cases"].values() for row in rows or []))
    head("worst of all scenes")
    for kernel in kernels:
        print(f"| {kernel} | " + " | ".join(cell(rows_of(result, kernel)) for result in reports.values()) + " |")
    print()
    head("megakernel")
    for case in first["recorded"]:
        print(f"| {case} | " + " | ".join(cell(rows_of(result, "megakernel", case)) for result in reports.values()) + " |")
    return 0


def folder_or_none(text):
    text = text or os.environ.get("CANDELA_GPU_COMPILERS", "")
    return Path(text) if text else None


def skip_reason(options):
    if not options.root or not (options.root / "usr/share/vulkan/icd.d").is_dir():
        return f"no system with Vulkan drivers in '{options.root or ''}'; `make` makes one"
    if os.geteuid() != 0:
        return "chroot needs the rights of root"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=("make", "check", "record", "table"))
    parser.add_argument("--root", type=folder_or_none, default="",
                        help="folder of the system; default: CANDELA_GPU_COMPILERS of the environment, also if it is empty")
    parser.add_argument("--mirror", default="http://deb.debian.org/debian", help="for `make`: where Debian is")
    parser.add_argument("--program", type=Path, help="the candela program")
    parser.add_argument("--models", type=Path, help="folder of glTF files that are compiled, too")
    parser.add_argument("--variants", action="store_true", help="compile the variants of shaders, too: many minutes for each GPU")
    parser.add_argument("--gpus", default="", help="names, separated by commas: " + ", ".join(gpu.name for gpu in GPUS))
    parser.add_argument("--cases", default="", help="regular expression of the names of scenes, and of `conformance`")
    parser.add_argument("--reports", type=Path, help="folder that keeps the reports")
    parser.add_argument("--reuse", action="store_true", help="compile nothing, and read the reports")
    parser.add_argument("--failures", type=Path, help="folder for what repeats failures")
    parser.add_argument("--timeout", type=float, default=600, help="of one scene, seconds")
    parser.add_argument("--threshold", type=float, default=0.05, help="fraction by which spills and instructions may rise")
    parser.add_argument("--replace", action="store_true", help="for `record`: replace figures that differ")
    options = parser.parse_args()
    if options.reuse and not options.reports or options.command == "make" and not options.root:
        parser.error("--reuse needs --reports, and `make` needs --root")
    try:
        if options.command == "make":
            return make(options)
        if not options.reuse:
            reason = skip_reason(options)
            if reason:
                print(f"SKIPPED: {reason}")
                return SKIP
            if not options.program:
                parser.error("--program is missing")
        reports = load_reports(options) if options.reuse else compile_all(options)
        return {"check": check, "record": record, "table": table}[options.command](options, reports)
    except (Failure, subprocess.CalledProcessError) as error:
        print(f"FAILED: {error}")
        return 1


if __name__ == "__main__":
    sys.exit(main())
