#!/usr/bin/env python3
"""Renders the scenarios of Khronos' glTF Render Fidelity comparison with Candela.

    python3 tests/fidelity/render.py --config CONFIG.json --root DIR -o DIR [--scenario TEXT]... [-- OPTION...]
    python3 tests/fidelity/render.py [...] '{"scenario": {...}, "outputFile": "FILE.png"}'

The configuration is test/config.json of KhronosGroup/glTF-Render-Fidelity-Generator (or of render-fidelity-tools in
google/model-viewer, where it comes from). The second form is that of the comparison's `command` renderers, which pass
one scenario with all of its defaults as the last argument. Options behind -- go to candela.

As the comparison prescribes, pictures have twice the stated size, three.js' ACES curve, the camera on the stated orbit
with the stated vertical field of view, and alpha instead of the environment unless renderSkybox is set. Exit code: 0
every scenario was rendered, 1 some were not.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from wrapped_model import wrap

PIXEL_RATIO = 2  # pixels of a picture per pixel of a scenario
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


def command_of(scenario, model: Path, camera, copy: Path, output: Path, options):
    """Returns the command that renders a copy of the model."""
    size = [PIXEL_RATIO * scenario["dimensions"][side] for side in ("width", "height")]
    return [options.candela, str(copy), "--allow-path", str(model.parent.resolve()), "--camera", str(camera),
            "--size", f"{size[0]}x{size[1]}", "--env", environment_of(scenario, options),
            "--background", "env" if scenario["renderSkybox"] else "none", "--tonemap", "aces-hill",
            "--spp", str(options.spp), "-o", str(output), *options.candela_options]


def render(scenario, output: Path, options):
    """Renders a scenario. Returns whether the picture was written."""
    name = scenario["name"]
    try:
        model = find_model(scenario, options)
        output.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as folder:
            copy, camera = wrap(model, scenario, Path(folder))
            code = subprocess.run(command_of(scenario, model, camera, copy, output, options)).returncode
    except (Missing, OSError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return False
    print(f"{name}: {output}" if code == 0 else f"{name}: candela ended with exit code {code}")
    return code == 0


def jobs_of(options):
    """Returns pairs of a scenario and its picture."""
    if options.request:
        request = json.loads(options.request)
        return [(completed(request["scenario"]), Path(request["outputFile"]))]
    scenarios = json.loads(options.config.read_text())["scenarios"]
    wanted = [text.lower() for text in options.scenario]
    chosen = [s for s in scenarios if not wanted or any(text in s["name"].lower() for text in wanted)]
    return [(completed(s), options.output / s["name"] / "candela-golden.png") for s in chosen]


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("request", nargs="?", help="one scenario and its output file, as JSON")
    parser.add_argument("--config", type=Path, help="configuration with the list of scenarios")
    parser.add_argument("--scenario", action="append", default=[], metavar="TEXT", help="part of a name; repeatable")
    parser.add_argument("--root", type=Path, default=Path("."), help="folder that leading ../ of the files stand for")
    parser.add_argument("--models", type=Path, help="folder with models that are not below the root")
    parser.add_argument("--env", help="environment instead of the scenarios' own, as candela --env takes it")
    parser.add_argument("--spp", type=int, default=256, help="samples per pixel (default: 256)")
    parser.add_argument("--candela", default="build/release/candela", help="the program")
    parser.add_argument("-o", "--output", type=Path, default=Path("goldens"), help="folder of the pictures")
    split = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:split])
    options.candela_options = words[split + 1:]
    if bool(options.request) == bool(options.config):
        parser.error("state either --config or one scenario as JSON")
    return options


def main():
    options = parse(sys.argv[1:])
    jobs = jobs_of(options)
    if not jobs:
        sys.exit("no scenario has this name")
    done = [render(scenario, output, options) for scenario, output in jobs]
    return 0 if all(done) else 1


if __name__ == "__main__":
    sys.exit(main())
