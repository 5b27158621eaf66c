#!/usr/bin/env python3
"""Records the film hashes of all scenes in scenes/, and checks that a program still renders the same films.

    python3 tests/guard/film_hashes.py record --program PROGRAM --compiler "GNU 12.2" [--icd FILE] [--replace]
    python3 tests/guard/film_hashes.py check --program PROGRAM --compiler "GNU 12.2" [--icd FILE] [--quick] [--variants]

--emulator COMMAND runs a program for another processor, e.g. "qemu-aarch64 -L build/arm64-root".
Without --icd the reference tracer renders (--device cpu), with --icd the Vulkan driver whose manifest FILE is. Each
scene is rendered by every integrator except `cost`, whose film depends on the acceleration structure, and by `path` with and
without next-event estimation. `check --quick` renders `path` with next-event estimation alone. `check --variants`
renders `path` with other acceleration structures, node layouts and kernels, too: all of them must have the recorded hash.

The hashes are in film_hashes.json, under a key that names what may alter the last bits of an unchanged program's film:
- device and driver as the program reports them: lavapipe's names contain the releases of Mesa and LLVM and the vector
  width; SwiftShader's have no release, so after an update of Chromium a difference may be the driver's;
- the compiler, because it may evaluate functions of constants, and orders operations that the language leaves open;
- the C library, because its releases round functions such as pow and sin differently, and the instruction set: glibc's
  libm and LLVM generate or choose other code where the processor has fused multiply-add. With glibc 2.36 the
  reference's film of `primitives` at 64 samples changes if libm does without it. (The script clears GLIBC_TUNABLES, a
  variable that switches it off.) 64-bit ARM has the hashes of x86_64 with fused multiply-add, because glibc has the same bits
  there in all functions on which films of the reference depend.
The key does not name the build type: the program is compiled with -ffp-contract=off and without -ffast-math, so the
level of optimisation must not change a film. Nor does it name the GLSL compiler: a film that changes with it is a
finding.

`check` skips where the table lacks the key, and prints the command that records it. A scene without an entry, and an
entry without a scene, are failures. `record` adds entries, but changes recorded hashes only with --replace.
Exit code: 0 all films are as recorded, 1 not, or the program failed, 2 usage, 77 skipped.
"""
import argparse
import json
import os
import platform
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = Path(__file__).with_name("film_hashes.json")
SKIP = 77  # SKIP_RETURN_CODE in CMakeLists.txt
RENDER_SECONDS = 600
BAD_INPUT = 2  # exit code of the program that refuses a scene
QUICK = {"integrator": "path", "nee": "on"}
FILMS = [QUICK, {"integrator": "path", "nee": "off"}] + [
    {"integrator": name} for name in ("whitted", "ao", "normal", "albedo", "depth", "id")]
REFERENCE_VARIANTS = [QUICK | {"accel": "none"}, QUICK | {"accel": "grid"}]
DEVICE_VARIANTS = [QUICK | variant for variant in (
    {"accel": "none"},
    {"accel": "grid"},
    {"layout": "bvh2"},
    {"layout": "cwbvh"},
    {"kernel": "wavefront", "accel": "none"},
    {"kernel": "wavefront", "accel": "grid"},
    {"kernel": "wavefront", "layout": "bvh2"},
    {"kernel": "wavefront", "layout": "cwbvh"},
)] + [{"integrator": "path", "nee": "off", "kernel": "wavefront"}]
REPORTED_AS = {"accel": "structure", "layout": "layout", "kernel": "kernel"}  # option: its key in the JSON report


class RenderError(Exception):
    """The program failed, or did not render as it was asked to."""


class NotApplicable(Exception):
    """The device refuses brute force over so many primitives, or a scene has too few for a BVH."""


class Renderer:
    """The program on one device."""

    def __init__(self, program, icd, emulator):
        self.command = [*shlex.split(emulator), str(program)]
        self.device = [] if icd else ["--device", "cpu"]
        self.environment = {name: value for name, value in os.environ.items() if name != "GLIBC_TUNABLES"}
        if icd:  # VK_ICD_FILENAMES is what loaders before 1.3.207 read
            self.environment |= {"VK_DRIVER_FILES": str(icd), "VK_ICD_FILENAMES": str(icd)}

    def report(self, scene, settings, size="64x64", spp=4):
        """The JSON report of a render. `settings`: options without their dashes, and their values."""
        command = [*self.command, str(scene), "--size", size, "--spp", str(spp), "--untuned", "--quiet", "--json", "-",
                   *self.device]
        for name, value in settings.items():
            command += [f"--{name}", value]
        try:
            done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=RENDER_SECONDS)
        except subprocess.TimeoutExpired as error:
            raise RenderError(f"no film after {RENDER_SECONDS} s: {shlex.join(command)}") from error
        if done.returncode == BAD_INPUT and settings.get("accel") == "none" and "--accel none" in done.stderr:
            raise NotApplicable(f"{scene.name}: {done.stderr.strip()}")
        if done.returncode != 0:
            raise RenderError(f"exit code {done.returncode}: {shlex.join(command)}\n{done.stderr}")
        report = json.loads(done.stdout)
        if "layout" in settings and report["layout"] == "list":
            raise NotApplicable(f"{scene.name} --layout {settings['layout']}: the scene has no BVH")
        for option, key in REPORTED_AS.items():
            if option in settings and report[key] != settings[option]:
                raise RenderError(f"{key} is {report[key]!r}: {shlex.join(command)}")
        return report

    def hash(self, scene, settings):
        return self.report(scene, settings)["filmHash"]


def scene_files():
    return sorted((ROOT / "scenes").glob("*.p3f"))


def entry_name(scene, film):
    nee = f" nee={film['nee']}" if "nee" in film else ""
    return f"{scene.stem} {film['integrator']}{nee}"


def entry_names():
    return {entry_name(scene, film) for scene in scene_files() for film in FILMS}


def instruction_set():
    """The machine's architecture, and whether an x86 processor has fused multiply-add. AArch64 is no key of its own."""
    if platform.machine() == "aarch64":
        return "x86_64 fma"
    if platform.machine() != "x86_64":
        return platform.machine()
    flags = next((line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("flags")), "")
    return "x86_64 fma" if "fma" in flags.split() else "x86_64"


def table_key(renderer, compiler):
    report = renderer.report(scene_files()[0], {"integrator": "normal"}, size="8x8", spp=1)
    libc = " ".join([*platform.libc_ver(), instruction_set()])
    return " | ".join([report["device"], report["driver"] or "-", compiler, libc])


def load_table():
    return json.loads(TABLE.read_text()) if TABLE.exists() else {}


def record_command(arguments):
    icd = ["--icd", str(arguments.icd)] if arguments.icd else []
    return shlex.join(["python3", __file__, "record", "--program", str(arguments.program), "--compiler",
                       arguments.compiler, *icd])


def options(film):
    return " ".join(f"--{name} {value}" for name, value in film.items())


def film_problem(renderer, scene, film, expected):
    """A message if a film does not have its recorded hash, else an empty one."""
    try:
        found = renderer.hash(scene, film)
    except RenderError as error:
        return f"{scene.name} {options(film)}: {error}"
    if found == expected:
        return ""
    return f"{scene.name} {options(film)}: the film's hash is {found}, not {expected} as recorded"


def compare_film(renderer, hashes, film):
    """Compares one film of every scene with its hash: the number of films compared, and of those that differ."""
    compared = problems = 0
    for scene in scene_files():
        name = entry_name(scene, film)
        if name not in hashes:  # entry_problems() prints it
            continue
        try:
            problem = film_problem(renderer, scene, film, hashes[name])
        except NotApplicable as reason:
            print(f"not applicable: {reason}", flush=True)
            continue
        compared += 1
        if problem:
            problems += 1
            print(f"FAILED: {problem}", flush=True)
    if compared == 0:
        problems += 1
        print(f"FAILED: {options(film)}: no scene was rendered with these options")
    return compared, problems


def entry_problems(hashes, arguments):
    """Prints which films have no entry, and which entries no film: their number."""
    command = record_command(arguments)
    missing = sorted(entry_names() - hashes.keys())
    stale = sorted(hashes.keys() - entry_names())
    for name in missing:
        print(f"FAILED: {name}: no hash is recorded")
    for name in stale:
        print(f"FAILED: {name}: a hash is recorded, but there is no such film")
    if missing or stale:
        replace = " --replace" if stale else ""
        print(f"Record what is missing, and remove what is superfluous, with\n  {command}{replace}")
    return len(missing) + len(stale)


def check(arguments):
    renderer = Renderer(arguments.program, arguments.icd, arguments.emulator)
    key = table_key(renderer, arguments.compiler)
    hashes = load_table().get(key)
    if hashes is None:
        print(f"SKIPPED: no film was compared, because {TABLE} has no hashes for\n  {key}\n"
              f"Record them with a program whose films are known to be right:\n  {record_command(arguments)}")
        return SKIP
    films = [QUICK] if arguments.quick else FILMS
    if arguments.variants:
        films = films + (DEVICE_VARIANTS if arguments.icd else REFERENCE_VARIANTS)
    misplaced = entry_problems(hashes, arguments)
    counts = [compare_film(renderer, hashes, film) for film in films]
    compared, failed = (sum(column) for column in zip(*counts))
    print(f"{key}: {compared} films compared, {failed} failed; {misplaced} entries are missing or superfluous")
    return 1 if failed or misplaced else 0


def record(arguments):
    renderer = Renderer(arguments.program, arguments.icd, arguments.emulator)
    key = table_key(renderer, arguments.compiler)
    hashes = {entry_name(scene, film): renderer.hash(scene, film) for scene in scene_files() for film in FILMS}
    table = load_table()
    recorded = table.get(key, {})
    changed = sorted(name for name, value in recorded.items() if hashes.get(name) != value)
    if changed and not arguments.replace:
        print(f"{key}: these hashes would change or go; nothing is recorded without --replace:", *changed, sep="\n  ")
        return 1
    table[key] = hashes
    TABLE.write_text(json.dumps(table, indent=2, sort_keys=True) + "\n")
    print(f"{key}: {len(hashes)} hashes, {len(hashes.keys() - recorded.keys())} of them new, {len(changed)} replaced")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("record", "check"):
        command = commands.add_parser(name)
        command.add_argument("--program", type=Path, required=True, help="the candela program")
        command.add_argument("--compiler", required=True, help="that built it, e.g. \"GNU 12.2\"")
        command.add_argument("--icd", type=Path, help="manifest of a Vulkan driver; default: the reference tracer")
        command.add_argument("--emulator", default="", help="command that runs the program, where it is for another processor")
        if name == "record":
            command.add_argument("--replace", action="store_true", help="replace recorded hashes that differ")
        else:
            command.add_argument("--quick", action="store_true", help="render `path` with next-event estimation alone")
            command.add_argument("--variants", action="store_true", help="render other structures, layouts and kernels")
    arguments = parser.parse_args()
    try:
        return record(arguments) if arguments.command == "record" else check(arguments)
    except RenderError as error:
        print(f"FAILED: {error}")
        return 1


if __name__ == "__main__":
    sys.exit(main())
