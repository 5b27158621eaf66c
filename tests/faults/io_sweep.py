#!/usr/bin/env python3
"""Makes every call fail that writes, syncs, closes or renames a file of candela's, with each error that it may have.

    io_sweep.py --program candela --library libio_faults.so

Required of each run: it succeeds with all files as without the fault, or it ends with exit code 2 and a message that
names a file that was not written. Every file has its old content or its complete new one, and nothing is left over."""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FULL = ["ENOSPC", "EIO", "EDQUOT"]
ERRORS = {
    "open": FULL + ["EROFS", "EACCES", "EMFILE"],
    "write": FULL + ["EINTR", "SHORT"],
    "pwrite": FULL + ["EINTR", "SHORT"],
    "fsync": FULL + ["EROFS"],
    "close": FULL,
    "rename": FULL + ["EROFS", "EACCES"],
    "linkat": FULL + ["EROFS", "EACCES"],
    "unlink": ["EROFS", "EACCES"],
    "lock": ["ENOLCK", "EOPNOTSUPP"],
}
SCENE = """v
from 0 -4 1
at 0 0 0
up 0 0 1
angle 40
hither 1
resolution 16 12
f 0.8 0.6 0.4 1 0 0 0 0 1 1 1
s 0 0 0 0.5
f 1 1 1 1 0 0 0 0 1 1 1 4 4 4
s 1 -1 2 0.4
"""
RENDER = ["{in}/scene.p3f", "--device", "cpu", "--spp", "8", "--checkpoint", "{out}/film.exr"]
COMMANDS = {
    "render": RENDER + ["--resume", "{out}/film.exr", "-o", "{out}/a.png", "-o", "{out}/a.exr", "--json", "{out}/a.json"],
    "sequence": ["{in}/scene.p3f", "--device", "cpu", "--spp", "2", "--turntable", "3", "-o", "{out}/f#.png", "--checkpoint",
                 "{out}/film#.exr"],
    "merge": ["merge", "{in}/a.exr", "{in}/b.exr", "-o", "{out}/merged.exr"],
    "film": ["film", "{in}/a.exr", "-o", "{out}/a.jpg", "-o", "{out}/a.hdr", "-o", "{out}/a.pfm"],
    "generate": ["generate", "tetra", "-o", "{out}/tetra.nff"],
    "compare": ["compare", "{in}/a.exr", "{in}/b.exr", "--report", "{out}/page.html", "--diff", "{out}/diff.png"],
}
# Files whose content differs from run to run; they must be complete.
VARYING = {"a.json", "film.exr.json", "merged.exr.json", "page.html", *(f"film{frame}.exr.json" for frame in range(3))}
# The files that stay behind if they cannot be removed, or if the lock cannot be taken again to remove them.
LOCKS = {f"{name}.exr.candela-lock" for name in ("film", "merged", "film#", "film0", "film1", "film2")}
REMOVED_LAST = {"unlink": LOCKS, "lock": LOCKS}
STEPS = 3


def run(options, folder, words, environment=None):
    command = [options.program] + [w.format(**{"in": folder / "in", "out": folder / "out"}) for w in words]
    return subprocess.run(command, env=dict(os.environ, ASAN_OPTIONS="detect_leaks=0", **(environment or {})),
                          capture_output=True, text=True, timeout=120)


class Case:
    """A folder with inputs, and with old outputs that a command replaces."""

    def __init__(self, options, template, name):
        self.options, self.name = options, name
        self.template = template
        self.old = {p.name: p.read_bytes() for p in (template / "out").iterdir()}
        with tempfile.TemporaryDirectory(prefix="candela-io-") as folder:
            folder = self.fresh(folder)
            counts = folder / "counts"
            result = self.run(folder, {"CANDELA_IO_COUNTS": str(counts)})
            self.code = result.returncode
            if self.code not in (0, 3):
                sys.exit(f"{name} fails without a fault: {result.stderr}")
            written = {p.name: p.read_bytes() for p in (folder / "out").iterdir()}
            self.new = {name: content for name, content in written.items() if content != self.old.get(name)}
            self.counts = {k: int(v) for k, v in map(str.split, counts.read_text().splitlines())}

    def fresh(self, folder):
        target = pathlib.Path(folder) / "files"
        shutil.copytree(self.template, target)
        return target

    def run(self, folder, environment):
        return run(self.options, folder, COMMANDS[self.name],
                   environment | {"LD_PRELOAD": self.options.library, "CANDELA_IO_PATH": str(folder / "out")})

    def isNew(self, name, content):
        if name not in VARYING:
            return content == self.new[name]
        if name.endswith(".html"):
            return content.rstrip().endswith(b"</html>")
        return content != self.old.get(name) and bool(json.loads(content))

    def problem(self, fault):
        with tempfile.TemporaryDirectory(prefix="candela-io-") as folder:
            folder = self.fresh(folder)
            log = folder / "log"
            result = self.run(folder, {"CANDELA_IO_FAULT": fault, "CANDELA_IO_LOG": str(log)})
            if not log.exists():
                return "the fault was not injected"
            now = {p.name: p.read_bytes() for p in (folder / "out").iterdir()}
            extra = sorted(set(now) - set(self.new) - set(self.old) - REMOVED_LAST.get(fault.split(":")[0], set()))
            if extra:
                return f"left {extra}"
            stale = [n for n in self.new if n not in now or not self.isNew(n, now[n])]
            damaged = [n for n in stale if n in now and now[n] != self.old.get(n)]
            if damaged:
                return f"damaged {damaged}"
            if result.returncode == self.code:
                return f"success, but without {stale}" if stale else None
            if result.returncode != 2:
                return f"exit code {result.returncode}: {result.stderr}"
            if not any(str(folder / "out" / name) in result.stderr for name in stale or self.new):
                return f"no file is named: {result.stderr}"
            return None


def makeTemplate(options, folder):
    (folder / "in").mkdir()
    (folder / "out").mkdir()
    (folder / "in" / "scene.p3f").write_text(SCENE)
    for name, samples in (("a", "0:4"), ("b", "4:8")):
        run(options, folder, RENDER[:-1] + ["{in}/" + name + ".exr", "--samples", samples]).check_returncode()
    run(options, folder, RENDER + ["--samples", "0:4"]).check_returncode()
    for name in ("a.png", "a.exr", "a.json", "merged.exr", "a.jpg", "a.hdr", "a.pfm", "tetra.nff", "diff.png"):
        (folder / "out" / name).write_text("what was there before")


def faults(counts):
    for function, count in counts.items():
        steps = {1 + i * (count - 1) // (STEPS - 1) for i in range(STEPS)} if count else set()
        for error in ERRORS[function]:
            for number in sorted(steps):
                yield f"{function}:{number}:{error}"
            if count and (error in FULL or function == "lock"):
                yield f"{function}:1+:{error}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--library", required=True)
    parser.add_argument("--commands", default=",".join(COMMANDS))
    options = parser.parse_args()
    total, problems = 0, 0
    with tempfile.TemporaryDirectory(prefix="candela-io-") as folder:
        template = pathlib.Path(folder)
        makeTemplate(options, template)
        for name in options.commands.split(","):
            case = Case(options, template, name)
            for fault in faults(case.counts):
                total += 1
                problem = case.problem(fault)
                if problem:
                    problems += 1
                    print(f"{name} {fault}: {problem}", flush=True)
    print(f"{total} faults, {problems} problems")
    sys.exit(1 if problems or total < 40 else 0)


if __name__ == "__main__":
    main()
