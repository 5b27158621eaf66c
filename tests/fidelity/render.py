#!/usr/bin/env python3
"""Renders the scenarios of Khronos' glTF Render Fidelity comparison with Candela.

    python3 tests/fidelity/render.py --config CONFIG.json --root DIR -o DIR [--scenario TEXT]... [-- OPTION...]
    python3 tests/fidelity/render.py [...] '{"scenario": {...}, "outputFile": "FILE.png"}'

The configuration is test/config.json of KhronosGroup/glTF-Render-Fidelity-Generator (or of render-fidelity-tools in
google/model-viewer, where it comes from). The second form is that of the comparison's `command` renderers, which pass
one scenario with all of its defaults as the last argument. Options behind -- go to candela.

As the comparison prescribes, pictures have twice the stated size, three.js' ACES curve, the camera on the stated orbit
with the stated vertical field of view, and alpha instead of the environment unless renderSkybox is set. The backs of
single-sided surfaces are not seen, as glTF prescribes and some models test. --measure and --verify write what table.py
makes tables of. Exit code: 0 every scenario was rendered, 1 some were not.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from wrapped_model import wrap

PIXEL_RATIO = 2  # pixels of a picture per pixel of a scenario
NOISE_FRACTION = 4  # samples of a picture per sample of the second picture, which --measure renders
RENDERER_NAME = "candela"  # in the generator's list of renderers and in the lists `exclude` of its scenarios
PICTURE_NAME, REPORT_NAME = "candela-golden.png", "candela-report.json"
NOISE_NAME, VERDICT_NAME = "candela-noise.png", "candela-verdict.json"
DEFAULTS = {"lighting": "../../../environments/lightroom_14b.hdr",
            "dimensions": {"width": 768, "height": 768},
            "target": {"x": 0, "y": 0, "z": 0},
            "orbit": {"theta": 0, "phi": 90, "radius": 1},
            "verticalFoV": 45,
            "renderSkybox": False}


class Missing(Exception):
    """A file of a scenario that is not there: a message for the user."""


def completed(scenario):
    """Returns the scenario with the defaults of the comparison."""
    result = {**DEFAULTS, **scenario}
    for key in ("dimensions", "target", "orbit"):
        result[key] = {**DEFAULTS[key], **scenario.get(key, {})}
    return result


def below(root: Path, path: str):
    """Configurations name files from the folder of a renderer, by leading `../`, which mean the root."""
    while path.startswith("../"):
        path = path[3:]
    return root / path


def find_model(scenario, options):
    """Returns the model's file: at its place below the root, or of its name anywhere in the folder --models."""
    model = below(options.root, scenario["model"])
    if model.is_file():
        return model
    if options.models:
        for suffix in (model.suffix, ".glb", ".gltf"):
            for found in sorted(options.models.rglob(model.stem + suffix)):
                if found.is_file():
                    return found
    raise Missing(f"{scenario['model']}: the model is not there; see --root and --models")


def environment_of(scenario, options):
    if options.env:
        return options.env
    lighting = below(options.root, scenario["lighting"])
    if lighting.is_file():
        return str(lighting)
    raise Missing(f"{scenario['lighting']}: the environment is not there; see --root and --env")


def size_of(scenario, width=None):
    """Returns a size as candela takes it: that of the comparison, or one of this width with the same proportions."""
    whole = [PIXEL_RATIO * scenario["dimensions"][side] for side in ("width", "height")]
    if width is None:
        return f"{whole[0]}x{whole[1]}"
    return f"{width}x{max(1, round(width * whole[1] / whole[0]))}"


def scene_of(scenario, model: Path, camera, copy: Path, options):
    """Returns the arguments that name the scene: a copy of the model, its camera and its environment."""
    return [str(copy), "--allow-path", str(model.parent.resolve()), "--camera", str(camera),
            "--env", environment_of(scenario, options), "--one-sided"]


def commands_of(scenario, scene, output: Path, options):
    """Returns the commands that a scenario needs: the picture, and what --measure and --verify add."""
    picture = [options.candela, *scene, "--size", size_of(scenario, options.width),
               "--background", "env" if scenario["renderSkybox"] else "none", "--tonemap", "aces-hill"]
    commands = [[*picture, "--spp", str(options.spp), "-o", str(output), *options.candela_options]]
    if options.measure:
        commands[0] += ["--json", str(output.with_name(REPORT_NAME))]
        commands.append([*picture, "--spp", str(max(1, options.spp // NOISE_FRACTION)), "--seed", "1",
                         "-o", str(output.with_name(NOISE_NAME)), *options.candela_options])
    if options.verify:
        commands.append([options.candela, "verify", *scene, "--size", size_of(scenario, options.verify),
                         "--allow-undecided", "--json", str(output.with_name(VERDICT_NAME)), "-q",
                         *options.candela_options])
    return commands[-1:] if options.verify_only else commands


def render(scenario, output: Path, options):
    """Renders a scenario. Returns whether the picture was written."""
    name = scenario["name"]
    try:
        model = find_model(scenario, options)
        output.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as folder:
            copy, camera = wrap(model, scenario, Path(folder))
            scene = scene_of(scenario, model, camera, copy, options)
            codes = [subprocess.run(command).returncode for command in commands_of(scenario, scene, output, options)]
            code = max(codes)
    except (Missing, OSError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return False
    print(f"{name}: {output}" if code == 0 else f"{name}: candela ended with exit code {code}")
    return code == 0


def jobs_of(options):
    """Returns pairs of a scenario and its picture, without the scenarios that exclude Candela."""
    if options.request:
        request = json.loads(options.request)
        return [(completed(request["scenario"]), Path(request["outputFile"]))]
    scenarios = json.loads(options.config.read_text())["scenarios"]
    wanted = [text.lower() for text in options.scenario]
    chosen = [s for s in scenarios if RENDERER_NAME not in s.get("exclude", [])
              and (not wanted or any(text in s["name"].lower() for text in wanted))]
    return [(completed(s), options.output / s["name"] / PICTURE_NAME) for s in chosen]


def peak_mebibytes():
    """Returns the maximum resident memory of the programs that were run; Linux reports KiB, macOS bytes."""
    import resource  # Python for Windows lacks it.
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    return peak / (2**20 if sys.platform == "darwin" else 2**10)


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("request", nargs="?", help="one scenario and its output file, as JSON")
    parser.add_argument("--config", type=Path, help="configuration with the list of scenarios")
    parser.add_argument("--scenario", action="append", default=[], metavar="TEXT", help="part of a name; repeatable")
    parser.add_argument("--root", type=Path, default=Path("."), help="folder that leading ../ of the files stand for")
    parser.add_argument("--models", type=Path, help="folder with models that are not below the root")
    parser.add_argument("--env", help="environment instead of the scenarios' own, as candela --env takes it")
    parser.add_argument("--spp", type=int, default=256, help="samples per pixel (default: 256)")
    parser.add_argument("--width", type=int, help="width of the pictures (default: twice the scenario's)")
    parser.add_argument("--measure", action="store_true",
                        help="also write candela's report, and a second picture of a quarter of the samples")
    parser.add_argument("--verify", type=int, metavar="WIDTH", help="also run candela verify at this width")
    parser.add_argument("--verify-only", action="store_true", help="with --verify: render no pictures")
    parser.add_argument("--candela", default="build/release/candela", help="the program")
    parser.add_argument("-o", "--output", type=Path, default=Path("goldens"), help="folder of the pictures")
    split = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:split])
    options.candela_options = words[split + 1:]
    if bool(options.request) == bool(options.config):
        parser.error("state either --config or one scenario as JSON")
    if options.verify_only and not options.verify:
        parser.error("--verify-only needs --verify WIDTH")
    return options


def main():
    options = parse(sys.argv[1:])
    jobs = jobs_of(options)
    if not jobs:
        sys.exit("no scenario has this name")
    done = [render(scenario, output, options) for scenario, output in jobs]
    if options.measure:
        print(f"{sum(done)} of {len(done)} scenarios; maximum memory of candela: {peak_mebibytes():.0f} MiB")
    return 0 if all(done) else 1


if __name__ == "__main__":
    sys.exit(main())
