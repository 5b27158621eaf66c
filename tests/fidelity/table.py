#!/usr/bin/env python3
"""Compares pictures of the fidelity scenarios with the published ones of path tracers, and prints tables in Markdown.

    python3 tests/fidelity/render.py --config CONFIG.json [...] -o OURS --measure --verify 64
    python3 tests/fidelity/table.py --config CONFIG.json --ours OURS --published DIR [--sheets DIR]

--published is test/goldens of KhronosGroup/glTF-Render-Fidelity-Generator, or public/thumbnails/goldens of
KhronosGroup/glTF-Render-Fidelity, which has the same pictures 512 pixels wide. Differences are ours minus theirs, in
per cent of the range of a channel: mean / root mean square over the pixels that one of both covers. `among them` is the
mean of the root mean squares of all pairs of published path tracers. Noise is the root mean square of the standard
error, from the second picture of render.py --measure. remarks.json has a sentence for each picture, the scenarios that
need features which Candela lacks, and those whose files were not available. Needs NumPy and Pillow (Debian:
python3-numpy, python3-pil).
"""
import argparse
import itertools
import json
import math
import statistics
from pathlib import Path

import pictures
from render import NOISE_FRACTION, NOISE_NAME, PICTURE_NAME, REPORT_NAME, VERDICT_NAME

PATH_TRACERS = {"vray": "V-Ray", "blender-cycles": "Cycles", "three-gpu-pathtracer": "three-gpu-pathtracer",
                "stellar": "STELLAR", "dspbr-pt": "dspbr-pt"}
REMARKS = Path(__file__).with_name("remarks.json")
NONE = ""


def short(name):
    return name.removeprefix("khronos-")


def published(folder, scenario):
    """Returns {renderer: picture} of the path tracers whose picture of a scenario is published."""
    found = {}
    for renderer in PATH_TRACERS:
        for suffix in (".png", ".thumb.webp"):
            file = folder / scenario / f"{renderer}-golden{suffix}"
            if file.is_file():
                found[renderer] = pictures.read(file)
                break
    return found


def noise_of(folder, picture):
    """Returns the standard error of a picture's levels: root mean square, in per cent of their range."""
    if not (folder / NOISE_NAME).is_file():
        return None
    found = pictures.difference(picture, pictures.read(folder / NOISE_NAME))
    return found and found[1] / math.sqrt(1 + NOISE_FRACTION)


def json_of(file):
    return json.loads(file.read_text()) if file.is_file() else None


def spread_of(theirs):
    """Returns the mean of the root mean squares of all pairs, or None if there is no pair."""
    pairs = [pictures.difference(a, b) for a, b in itertools.combinations(theirs.values(), 2)]
    return statistics.mean(pair[1] for pair in pairs if pair) if any(pairs) else None


def verdict_cells(report):
    """Returns the cells of the verdict of candela verify and of the difference of means that it would have detected."""
    if report is None or report["interrupted"]:
        return NONE, NONE
    verdict = "not decided" if report["undecided"] else "same light" if report["agrees"] else "**differs**"
    detectable = report["sameLight"]["regions"][0]["detectableBias"]  # The first region is the whole image.
    return verdict, NONE if detectable is None else number(100 * detectable, 2)


def number(value, digits=1):
    return NONE if value is None else f"{value:.{digits}f}"


def measured(scenario, options):
    """Returns what the tables say of a scenario that was rendered."""
    folder = options.ours / scenario
    ours, theirs = pictures.read(folder / PICTURE_NAME), published(options.published, scenario)
    if options.sheets:
        options.sheets.mkdir(parents=True, exist_ok=True)
        pictures.write_sheet(options.sheets / f"{scenario}.png", [("Candela", ours), *(
            (PATH_TRACERS[name], image) for name, image in theirs.items())])
    report = json_of(folder / REPORT_NAME)
    return {"name": scenario, "differences": {name: pictures.difference(ours, image) for name, image in theirs.items()},
            "spread": spread_of(theirs), "noise": noise_of(folder, ours), "verdict": json_of(folder / VERDICT_NAME),
            "seconds": report and report["phaseSeconds"]["total"]}


def row_of(result, remarks):
    pairs = [result["differences"].get(name) for name in PATH_TRACERS]
    cells = [short(result["name"]), remarks.get(short(result["name"]), NONE),
             *(f"{pair[0]:+.1f} / {pair[1]:.1f}" if pair else NONE for pair in pairs), number(result["spread"]),
             number(result["noise"], 2), number(result["seconds"], 0), *verdict_cells(result["verdict"])]
    return "| " + " | ".join(cells) + " |"


def summary(results):
    """Returns rows over all scenarios: medians for each path tracer."""
    rows = []
    for name, label in PATH_TRACERS.items():
        pairs = [r["differences"][name] for r in results if r["differences"].get(name)]
        if pairs:
            rows.append(f"| {label} | {len(pairs)} | {statistics.median(p[0] for p in pairs):+.1f} "
                        f"| {statistics.median(p[1] for p in pairs):.1f} |")
    return rows


def tables(scenarios, results, remarks):
    """Returns the lines of the tables: medians, scenarios, scenarios without a picture."""
    yield from ("| path tracer | pictures | median of the mean differences | median of the RMS differences |",
                "|---|---:|---:|---:|", *summary(results), "")
    heads = ["scenario", "picture", *PATH_TRACERS.values(), "among them", "noise", "seconds", "verify", "bias in %"]
    yield "| " + " | ".join(heads) + " |"
    yield "|---|---|" + "---:|" * (len(PATH_TRACERS) + 3) + "---|---:|"
    yield from (row_of(result, remarks["scenarios"]) for result in results)
    rendered = {result["name"] for result in results}
    reasons = {**remarks["unavailable"], **remarks["lacking"]}
    yield from ("", "| scenario without a picture | reason |", "|---|---|")
    without = [short(name) for name in scenarios if name not in rendered]
    without.sort(key=lambda name: name not in remarks["lacking"])
    yield from (f"| {name} | {reasons.get(name, 'not rendered')} |" for name in without)
    seconds = [result["seconds"] for result in results if result["seconds"] is not None]
    if seconds:
        yield from ("", f"{len(results)} of {len(scenarios)} scenarios have a picture; "
                    f"{sum(seconds) / 60:.0f} minutes, median {statistics.median(seconds):.0f} s.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--config", type=Path, required=True, help="configuration with the list of scenarios")
    parser.add_argument("--ours", type=Path, required=True, help="folder of render.py -o")
    parser.add_argument("--published", type=Path, required=True, help="folder of the published pictures")
    parser.add_argument("--sheets", type=Path, help="also write sheets with our picture beside the published ones")
    options = parser.parse_args()
    scenarios = [scenario["name"] for scenario in json.loads(options.config.read_text())["scenarios"]]
    remarks = json_of(REMARKS)
    results = [measured(name, options) for name in scenarios
               if short(name) not in remarks["lacking"] and (options.ours / name / PICTURE_NAME).is_file()]
    print("\n".join(tables(scenarios, results, remarks)))


if __name__ == "__main__":
    main()
