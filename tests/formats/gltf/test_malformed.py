"""Malformed glTF files: each is refused by `candela check` with exit code 2 and the place of its error.

    python3 test_malformed.py CANDELA [--keep DIR]

One process checks all files. The files are made anew by malformed/cases.py; --keep writes them to a folder that stays.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "malformed"))
from base_file import base  # noqa: E402
from cases import cases  # noqa: E402

MIN_CASES = 150
SECONDS = 60  # of a few; a file may not take long, either
ANIMATED = ["--time", "0.5"]  # so that the animation is read


def write(folder: Path, all_cases):
    """Returns the files by name. A name may have slashes of its pointer."""
    files = {}
    for number, case in enumerate(all_cases):
        files[case.name] = folder / f"{number:03}{case.suffix}"
        files[case.name].write_bytes(case.content)
    return files


def check(candela, files):
    """Returns exit code and JSON report, or raises if the program dies by a signal or prints bytes that are not text."""
    result = subprocess.run([candela, "check", *map(str, files), *ANIMATED, "--json", "-", "-q"], capture_output=True,
                            text=True, timeout=SECONDS)
    if result.returncode < 0:
        raise RuntimeError(f"the program died by signal {-result.returncode}: {result.stderr[-2000:]}")
    return result.returncode, json.loads(result.stdout)["files"]


def place_of(error):
    """Returns the place that an error names: a pointer, "line" for a line and a column, or the container."""
    if error["line"] > 0:
        return "line"
    return error["message"].partition(": ")[0]


def complaint(case, entry):
    """Returns the error in the report on a file; empty if it is right."""
    if entry["valid"]:
        return "accepted"
    found = [place_of(error) for error in entry["errors"]]
    return "" if case.place in found else f"expected {case.place}, found {entry['errors'][:3]}"


def main(candela, folder: Path):
    good = [folder / "good.gltf", folder / "good.glb"]
    good[0].write_bytes(base().text())
    good[1].write_bytes(base().glb())
    code, entries = check(candela, good)
    if code != 0:
        sys.exit(f"the unchanged files are refused: {[entry['errors'] for entry in entries]}")

    all_cases = cases()
    assert len({case.name for case in all_cases}) == len(all_cases) >= MIN_CASES
    files = write(folder, all_cases)
    code, entries = check(candela, files.values())
    wrong = [(case, complaint(case, entry)) for case, entry in zip(all_cases, entries, strict=True)]
    wrong = [(case, text) for case, text in wrong if text]
    for case, text in wrong:
        print(f"{case.name}: {text}")
    print(f"{len(all_cases)} files, {len(wrong)} not as expected, exit code {code}")
    return 0 if code == 2 and not wrong else 1


if __name__ == "__main__":
    if "--keep" in sys.argv:
        target = Path(sys.argv[sys.argv.index("--keep") + 1])
        target.mkdir(parents=True, exist_ok=True)
        sys.exit(main(sys.argv[1], target))
    with tempfile.TemporaryDirectory() as name:
        sys.exit(main(sys.argv[1], Path(name)))
