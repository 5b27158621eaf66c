"""Prints docs/conformance-cases.md: all cases of `candela conformance`, with the result and the seconds on each driver.

Each argument is a report of `candela conformance --json`. The first lines of the page are the commands that made it.
"""
import argparse
import json

HEAD = """# The cases of `candela conformance`

[Conformance](conformance.md) explains the names, and [drivers](drivers.md) the failures. The columns are the seconds that each case took on two
cores of an AMD EPYC, which other programs used at the same time (load average {load}), without a cache of the driver. Cases of one group share
kernels, so that the first one of a group includes their compilation. `ExpectedFail` is a known failure of the driver. `Skip` means that the driver
lacks a feature, or that the case is in its list of skips. This page is made by

    export MESA_SHADER_CACHE_DISABLE=1
    VK_DRIVER_FILES=LAVAPIPE.json candela conformance --jobs 2 --timeout 240s --baseline lavapipe-22.3.6-fails.txt --json lavapipe.json
    VK_DRIVER_FILES=SWIFTSHADER.json candela conformance --jobs 2 --timeout 240s --baseline swiftshader-fails.txt \\
      --skips swiftshader-skips.txt --json swiftshader.json
    python3 tests/drivers/conformance/case_table.py --load {load} lavapipe.json swiftshader.json > docs/conformance-cases.md

with the files of `host/drivers/conformance/baselines`.
"""


def cell(case):
    """The seconds of a case, after its result if that is not Pass."""
    if case is None:
        return "not run"
    if case["result"] == "Skip":
        return "Skip"
    seconds = f"{case['seconds']:.2f}"
    return seconds if case["result"] == "Pass" else f"{case['result']}, {seconds}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("reports", nargs="+", help="files of `candela conformance --json`")
    parser.add_argument("--load", required=True, help="load average during the runs")
    options = parser.parse_args()
    reports = []
    for file in options.reports:
        with open(file, encoding="utf-8") as opened:
            reports.append(json.load(opened))
    results = [{case["name"]: case for case in report["cases"]} for report in reports]
    print(HEAD.format(load=options.load))
    print("| case | " + " | ".join(report["driver"] for report in reports) + " |")
    print("|---" * (len(reports) + 1) + "|")
    for name in sorted(set().union(*results)):
        print(f"| `{name}` | " + " | ".join(cell(result.get(name)) for result in results) + " |")


if __name__ == "__main__":
    main()
