#!/usr/bin/env python3
"""Fails every Vulkan function that candela calls, at several calls, with each error that it may return, and requires
that the program neither crashes nor hangs, ends with a documented exit code and a message, and leaves no damaged file.

    sweep.py --program candela --layers DIR --icd lvp_icd.json [--part default|whole] [--only TEXT]

DIR has the manifest of the layer (layer.cpp). Each fault goes into one run of `render` with a checkpoint, `verify` or
`bench`, with the validation layer on, which also reports objects that are not destroyed. A render that goes on after
the fault, or is resumed, must end with the bytes of a render without faults."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

MEMORY = ["VK_ERROR_OUT_OF_HOST_MEMORY", "VK_ERROR_OUT_OF_DEVICE_MEMORY"]
LOST = MEMORY + ["VK_ERROR_DEVICE_LOST"]
RESULTS = {
    "vkCreateInstance": MEMORY + ["VK_ERROR_INITIALIZATION_FAILED", "VK_ERROR_LAYER_NOT_PRESENT",
                                  "VK_ERROR_EXTENSION_NOT_PRESENT", "VK_ERROR_INCOMPATIBLE_DRIVER"],
    "vkEnumeratePhysicalDevices": MEMORY + ["VK_ERROR_INITIALIZATION_FAILED"],
    "vkEnumerateDeviceExtensionProperties": MEMORY + ["VK_ERROR_LAYER_NOT_PRESENT"],
    "vkCreateDevice": LOST + ["VK_ERROR_INITIALIZATION_FAILED", "VK_ERROR_EXTENSION_NOT_PRESENT",
                              "VK_ERROR_FEATURE_NOT_PRESENT", "VK_ERROR_TOO_MANY_OBJECTS"],
    "vkWaitForFences": LOST,
    "vkQueueSubmit": LOST,
    "vkDeviceWaitIdle": LOST,
    "vkAllocateMemory": MEMORY + ["VK_ERROR_TOO_MANY_OBJECTS"],
    "vkMapMemory": MEMORY + ["VK_ERROR_MEMORY_MAP_FAILED"],
    "vkCreateDescriptorPool": MEMORY + ["VK_ERROR_FRAGMENTATION"],
    "vkAllocateDescriptorSets": MEMORY + ["VK_ERROR_FRAGMENTED_POOL", "VK_ERROR_OUT_OF_POOL_MEMORY"],
}
CODES = {0: "done", 4: "no device", 5: "device lost", 6: "out of memory"}
TIMEOUT_SECONDS = 900  # a loaded machine is slow
SCENE = """v
from 0 -4 1
at 0 0 0
up 0 0 1
angle 40
hither 1
resolution 16 12
b 0.1 0.2 0.3
f 0.8 0.6 0.4 1 0 0 0 0 1 1 1
s 0 0 0 0.5
p 4
-3 -3 -0.5
3 -3 -0.5
3 3 -0.5
-3 3 -0.5
f 1 1 1 1 0 0 0 0 1 1 1 4 4 4
s 1 -1 2 0.4
"""
RENDER = ["--size", "32x24", "--spp", "24", "--max-depth", "5", "--tile", "16x8", "--checkpoint-every", "0.02s", "--no-cache"]
COMMANDS = {
    "render": ["{scene}", *RENDER, "--checkpoint", "{folder}/film.exr", "-o", "{folder}/picture.png"],
    "verify": ["verify", "{scene}", "--test", "independent", "--bias", "0.5", "--size", "8x6", "--no-cache", "--json", "{folder}/verdict.json"],
    "bench": ["bench", "{scene}", "--spp", "2", "--repeat", "1", "--no-cache", "--json", "{folder}/bench.json"],
}


class Sweep:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.scene = folder / "scene.p3f"
        self.scene.write_text(SCENE)
        self.environment = dict(os.environ, VK_ICD_FILENAMES=options.icd, VK_DRIVER_FILES=options.icd,
                                CANDELA_CACHE_DIR=str(folder / "cache"), ASAN_OPTIONS="detect_leaks=0",
                                LP_NUM_THREADS="1")
        paths = [options.layers] + [str(p) for p in map(pathlib.Path, [
            "/usr/share/vulkan/explicit_layer.d", "/usr/local/share/vulkan/explicit_layer.d",
            "/etc/vulkan/explicit_layer.d"]) if p.is_dir()]
        self.layer = {"VK_LAYER_PATH": ":".join(paths), "VK_INSTANCE_LAYERS": "VK_LAYER_CANDELA_faults",
                      "CANDELA_VALIDATION": "1"}

    def run(self, words, folder, more=None):
        command = [self.options.program] + [w.format(scene=self.scene, folder=folder) for w in words]
        return subprocess.run(command, env=self.environment | (more or {}), capture_output=True, text=True,
                              errors="replace", timeout=TIMEOUT_SECONDS)

    def counts(self, command):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        file = folder / "counts"
        result = self.run(COMMANDS[command], folder, self.layer | {"CANDELA_FAULT_COUNTS": str(file)})
        if result.returncode != 0:
            sys.exit(f"{command} fails without a fault, with {result.returncode}: {result.stderr}")
        if command == "render":
            self.whole = (folder / "film.exr").read_bytes()
        return {name: int(count) for name, count in map(str.split, file.read_text().splitlines())}

    def requireFilm(self, folder, code):
        """The film is complete, or the render is resumed from it; in the end it has the bytes of a run without faults."""
        film = folder / "film.exr"
        if code == 0 and film.read_bytes() != self.whole:
            return "the film has other bytes than without the fault"
        if code == 0:
            return None
        resume = ["--resume", str(film)] if film.exists() else []
        more = self.run(["{scene}", *RENDER, "--checkpoint", str(film), *resume], folder)
        if more.returncode != 0:
            return f"the film cannot be resumed: {more.stderr}"
        return None if film.read_bytes() == self.whole else "the resumed film has other bytes"

    def problem(self, command, fault):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        try:
            log = folder / "log"
            result = self.run(COMMANDS[command], folder, self.layer | {"CANDELA_FAULT": fault, "CANDELA_FAULT_LOG": str(log)})
            if result.returncode not in CODES:
                return result.returncode, log.exists(), f"exit code {result.returncode}: {result.stderr[-2000:]}"
            if result.returncode != 0 and "candela: " not in result.stderr:
                return result.returncode, log.exists(), "no message"
            for name in ("verdict.json", "bench.json"):
                if (folder / name).exists():
                    json.loads((folder / name).read_text())
            leftover = [p.name for p in folder.iterdir() if "part" in p.name]
            if leftover:
                return result.returncode, log.exists(), f"left {leftover}"
            film = self.requireFilm(folder, result.returncode) if command == "render" else None
            return result.returncode, log.exists(), film
        except subprocess.TimeoutExpired:
            return None, True, "it hangs"
        except ValueError as error:
            return None, True, f"a report is damaged: {error}"
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def cases(self):
        """Every function, error and command, at the first and the last call and some between them."""
        cases = []
        for command in COMMANDS:
            for name, count in self.counts(command).items():
                if count == 0 and name != "vkDeviceWaitIdle":
                    continue
                for result in RESULTS.get(name, MEMORY) + ["VK_ERROR_UNKNOWN"]:
                    steps = sorted({1, 2, 3, count // 4, count // 2, 3 * count // 4, count - 1, count} & set(range(1, count + 1)))
                    for number in steps:
                        cases.append((command, f"{name}:{number}:{result}"))
                    if name == "vkDeviceWaitIdle":  # it is called after a wait that failed
                        for wait in (2, 9):
                            cases.append((command, f"vkWaitForFences:{wait}:VK_ERROR_OUT_OF_HOST_MEMORY,{name}:1:{result}"))
                    if name in ("vkQueueSubmit", "vkWaitForFences", "vkAllocateMemory"):
                        cases.append((command, f"{name}:{max(1, count // 2)}+:{result}"))
        random.Random(1).shuffle(cases)
        cases = [case for case in cases if self.options.only in " ".join(case)]
        return cases if self.options.part == "whole" else cases[:self.options.count]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--layers", required=True)
    parser.add_argument("--icd", required=True)
    parser.add_argument("--part", choices=["default", "whole"], default="default")
    parser.add_argument("--count", type=int, default=40, help="faults of the default part")
    parser.add_argument("--only", default="", help="cases that contain this text")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="candela-faults-") as name:
        sweep = Sweep(options, pathlib.Path(name))
        cases = sweep.cases()
        codes, problems, injected = {}, 0, 0
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            results = pool.map(lambda case: sweep.problem(*case), cases)
            for number, (case, (code, hit, problem)) in enumerate(zip(cases, results), 1):
                if number % 50 == 0:
                    print(f"{number} of {len(cases)} runs", flush=True)
                codes[code] = codes.get(code, 0) + 1
                injected += hit
                if problem:
                    problems += 1
                    print(f"{case[0]} {case[1]}: {problem}", flush=True)
    shown = ", ".join(f"{count} x {code} ({CODES.get(code, 'wrong')})" for code, count in sorted(codes.items(), key=str))
    print(f"{len(cases)} runs, {injected} with an injected fault, {problems} problems; exit codes: {shown}")
    sys.exit(1 if problems or injected < 0.9 * len(cases) else 0)


if __name__ == "__main__":
    main()
