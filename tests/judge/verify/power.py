#!/usr/bin/env python3
"""Measures the smallest albedo error that `candela verify` finds, prints a table, and draws the detection rate.

    python3 tests/judge/verify/power.py [--build build/release] [--icd FILE] [--seeds N] [--bias FRACTION] [--time-limit S]
                                  --work results.jsonl [--svg FILE]

The device renders the scene with all albedos multiplied by 1 + error, and the reference without. Verdicts are appended to
--work, and those that it has are not repeated. Each distinct pair of --bias and --time-limit is a curve of its own, so that
several calls fill one file. Times are processor times, which other programs on the machine change little; --time-limit is
elapsed time.
"""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd"]
LEFT, TOP, WIDTH, HEIGHT = 60, 20, 520, 240  # of the plot, in pixels


def measured(options, known):
    """Appends the verdicts that are missing."""
    icd = {"VK_DRIVER_FILES": options.icd, "VK_ICD_FILENAMES": options.icd} if options.icd else {}
    program = options.build / "tests/judge/verify/measure_power"
    done_before = {(one["seed"], one["error"], one["bias"], one["limit"]) for one in known}
    for seed in range(1, options.seeds + 1):
        for error in options.errors:
            if (seed, error, options.bias, options.time_limit) in done_before:
                continue
            words = [program, ROOT / options.scene, options.side, seed, options.bias, options.time_limit, error]
            done = subprocess.run([str(word) for word in words], env=os.environ | icd, capture_output=True, text=True, check=True)
            verdict = {**json.loads(done.stdout), "error": error, "bias": options.bias, "limit": options.time_limit}
            known.append(verdict)
            with options.work.open("a") as file:
                file.write(json.dumps(verdict) + "\n")


def rate(verdicts, *questions):
    return sum(any(verdict[question] for question in questions) for verdict in verdicts) / len(verdicts)


def curves(verdicts):
    """Returns the verdicts of each setting by error: {(bias, limit): {error: [verdict]}}."""
    settings = {}
    for verdict in sorted(verdicts, key=lambda one: (one["limit"], one["bias"], one["error"])):
        settings.setdefault((verdict["bias"], verdict["limit"]), {}).setdefault(verdict["error"], []).append(verdict)
    return settings


def name_of(setting):
    words = [f"--bias {100 * setting[0]:g}%"] if setting[0] else []
    words += [f"--time-limit {setting[1]:g}s"] if setting[1] else []
    return " ".join(words) or "default"


def print_table(settings):
    print("| options | albedo error | verdicts | found by question 1 | by question 2 | by either | samples per pixel "
          "| processor time |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for setting, errors in settings.items():
        for error, verdicts in errors.items():
            shares = " | ".join(f"{100 * rate(verdicts, *questions):.0f} %" for questions in (
                ("foundByPaths",), ("foundByLight",), ("foundByPaths", "foundByLight")))
            samples = statistics.median(verdict["samplesPerPixel"] for verdict in verdicts)
            seconds = statistics.median(verdict["processorSeconds"] for verdict in verdicts)
            print(f"| {name_of(setting)} | {100 * error:.4f} % | {len(verdicts)} | {shares} | {samples:g} | {seconds:.0f} s |")


def svg(settings):
    errors = sorted({error for curve in settings.values() for error in curve if error > 0})
    low, high = math.log10(errors[0]), math.log10(errors[-1])

    def x(error):
        return LEFT + WIDTH * (math.log10(error) - low) / (high - low)

    def y(share):
        return TOP + HEIGHT * (1 - share)

    height = TOP + HEIGHT + 55 + 18 * len(settings)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 30}" height="{height}" '
             'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    for share in (0, 0.25, 0.5, 0.75, 1):
        parts.append(f'<line x1="{LEFT}" x2="{LEFT + WIDTH}" y1="{y(share)}" y2="{y(share)}" stroke="#ddd"/>'
                     f'<text x="{LEFT - 8}" y="{y(share) + 4}" text-anchor="end">{100 * share:.0f} %</text>')
    for error in errors:
        parts.append(f'<line x1="{x(error):.1f}" x2="{x(error):.1f}" y1="{TOP}" y2="{TOP + HEIGHT}" stroke="#eee"/>'
                     f'<text x="{x(error):.1f}" y="{TOP + HEIGHT + 16}" text-anchor="middle" font-size="10">'
                     f'{100 * error:.4g} %</text>')
    for index, (setting, curve) in enumerate(settings.items()):
        colour = COLOURS[index % len(COLOURS)]
        for questions, dash in ((("foundByPaths", "foundByLight"), ""), (("foundByPaths",), ' stroke-dasharray="5 4"')):
            points = [(x(error), y(rate(verdicts, *questions))) for error, verdicts in curve.items() if error > 0]
            parts.append(f'<polyline fill="none" stroke="{colour}" stroke-width="2"{dash} points="' +
                         " ".join(f"{a:.1f},{b:.1f}" for a, b in points) + '"/>')
            parts += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3.5" fill="{colour}"/>' for a, b in points]
        seconds = statistics.median(verdict["processorSeconds"] for verdicts in curve.values() for verdict in verdicts)
        parts.append(f'<text x="{LEFT + WIDTH / 2}" y="{y(0) + 58 + 18 * index}" text-anchor="middle" '
                     f'fill="{colour}">{name_of(setting)} (dashed: question 1 alone), {seconds:.0f} s of processor time</text>')
    parts.append(f'<text x="{LEFT + WIDTH / 2}" y="{TOP + HEIGHT + 40}" text-anchor="middle">'
                 'error of all albedos of the device</text></svg>')
    return "\n".join(parts) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--icd", help="driver file for VK_ICD_FILENAMES")
    parser.add_argument("--scene", default="scenes/cornell.p3f")
    parser.add_argument("--side", type=int, default=512, help="of the square image, in pixels")
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--errors", type=float, nargs="+", default=[2e-6, 3e-6, 5e-6, 1e-5])
    parser.add_argument("--bias", type=float, default=0, help="verify's --bias; 0: its default")
    parser.add_argument("--time-limit", type=float, default=0, help="verify's --time-limit in seconds; 0: none")
    parser.add_argument("--work", type=Path, required=True, metavar="FILE", help="verdicts as JSON, one a line")
    parser.add_argument("--svg", type=Path, metavar="FILE")
    options = parser.parse_args()
    verdicts = [json.loads(line) for line in options.work.read_text().splitlines()] if options.work.exists() else []
    measured(options, verdicts)
    settings = curves(verdicts)
    print_table(settings)
    if options.svg:
        options.svg.write_text(svg(settings))
    return 0


if __name__ == "__main__":
    sys.exit(main())
