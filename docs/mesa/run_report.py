#!/usr/bin/env python3
"""Runs the kernels of a report in this folder, and counts the instructions that lavapipe executes in them.

    run_report.py REPORT [--listings FOLDER] [--folder FOLDER] [--prefix COMMAND]

REPORT is `nested_conditions`, `empty_branches` or `uniform_loads`. glslangValidator compiles each kernel, which is written to FOLDER (default: a
temporary one) in the form of `candela capture`: the C program reproduce.c dispatches it. Its options and exit code are described there.

To count instructions, a thread of the program is stopped in the code that the driver generated, and executes single instructions. The number of
instructions of an iteration, or of a workgroup if the kernel has no loop, is the distance between two visits of the address that is visited least
often. It does not depend on the speed or the load of the machine, and needs no hardware counters, but x86-64 and permission to trace a child process.

With --listings, objdump writes the executed instructions of each kernel to a file. VK_DRIVER_FILES selects the driver. COMMAND precedes the program's own, for a driver in another system root:

    --folder /srv/newer/tmp/kernel --prefix 'chroot /srv/newer env -C /tmp/kernel VK_DRIVER_FILES=/usr/share/vulkan/icd.d/lvp_icd.json'
"""
import argparse
import ctypes
import os
import platform
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPRODUCE = HERE.parents[1] / "host" / "drivers" / "capture" / "reproduce.c"

# sys/ptrace.h and, for the offset of the instruction pointer, sys/user.h of x86-64
PEEK_USER, SINGLE_STEP, ATTACH, DETACH = 3, 9, 16, 17
INSTRUCTION_POINTER = 16 * 8
ALL_THREADS = 0x40000000  # __WALL

STEPS = 12000
DISPATCHES = (1, 4_000_000)  # numbers of workgroups; one with a single iteration is for what a driver postpones to the first execution
ROUNDS = 60000  # lavapipe 22.3.6 ends loops after 65,535 iterations
WORDS = 1024    # of buffer 0
RECORDS = 512   # of 16 bytes, of buffer 1

libc = ctypes.CDLL(None, use_errno=True)
libc.ptrace.restype = ctypes.c_long
libc.ptrace.argtypes = [ctypes.c_long, ctypes.c_long, ctypes.c_void_p, ctypes.c_void_p]


def header(title, texels, push, groups):
    second = "USE_TEXEL" if texels else "USE_STORAGE"
    commands = ", ".join(f"{{.kind = COMMAND_DISPATCH, .module = 0, .buffers = {{0, 1}}, .push = {{{min(push[0], 1) if count == 1 else push[0]}u, {push[1]}u}}, .groups = {{{count}, 1, 1}}}}"
                         for count in groups)
    return f"""#define CAPTURE_TITLE "{title}"
#define CAPTURE_DEVICE "llvmpipe"
#define CAPTURE_ROBUST_ACCESS 0
#define CAPTURE_SUBGROUP_SIZE 0
static const struct module capture_modules[] = {{{{"module_0.spv", 8, 2, {{USE_STORAGE, {second}}}}}}};
static const struct buffer capture_buffers[] = {{{{NULL, {4 * WORDS}, USE_STORAGE, 1}}, {{NULL, {16 * RECORDS}, USE_STORAGE | USE_TEXEL, 1}}}};
static const struct command capture_commands[] = {{{commands}}};
"""


def write_program(folder, kernel, defines, push=(0, 0), groups=(1,), zeros=0):
    """Writes and compiles a program that dispatches a kernel, and expects that the first `zeros` words of buffer 0 are 0 then."""
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["glslangValidator", "--quiet", "--target-env", "vulkan1.2", *[f"-D{name}" for name in defines], "-o",
                    folder / "module_0.spv", HERE / f"{kernel}.comp"], check=True)
    (folder / "capture.h").write_text(header(" ".join([kernel, *defines]), "TEXELS" in defines, push, groups))
    (folder / "expected.bin").write_bytes(b"".join(struct.pack("<4I2d", 0, 0, word, 0, 0, 0) for word in range(zeros)))
    shutil.copy(REPRODUCE, folder)
    subprocess.run(["cc", "-std=c99", "-o", folder / "reproduce", folder / "reproduce.c", "-lvulkan"], check=True)


def ptrace(request, thread, address=0):
    ctypes.set_errno(0)
    result = libc.ptrace(request, thread, address, None)
    if ctypes.get_errno():
        raise OSError(ctypes.get_errno(), f"ptrace: {os.strerror(ctypes.get_errno())}")
    return result


def generated_code(pid):
    """The ranges of executable memory that belong to no file."""
    ranges = []
    with open(f"/proc/{pid}/maps") as maps:
        for line in maps:
            addresses, permissions, _, _, inode, *name = line.split(None, 5)
            if "x" in permissions and inode == "0" and not name:
                ranges.append(tuple(int(address, 16) for address in addresses.split("-")))
    return ranges


def thread_in_generated_code(pid):
    """Stops the threads of a process one after the other until one is in generated code, and returns that one; None: none is."""
    for thread in map(int, os.listdir(f"/proc/{pid}/task")):
        try:
            ptrace(ATTACH, thread)
        except OSError:
            continue  # it has ended
        os.waitpid(thread, ALL_THREADS)
        address = ptrace(PEEK_USER, thread, INSTRUCTION_POINTER)
        if any(start <= address < end for start, end in generated_code(pid)):
            return thread
        ptrace(DETACH, thread)
    return None


def next_addresses(thread, count):
    """The addresses of the next instructions of a stopped thread, which executes them."""
    found = []
    for _ in range(count):
        found.append(ptrace(PEEK_USER, thread, INSTRUCTION_POINTER))
        ptrace(SINGLE_STEP, thread)
        os.waitpid(thread, ALL_THREADS)
    return found


def disassembly(pid, start, end):
    """The instructions of a part of a process's memory, by their addresses."""
    with open(f"/proc/{pid}/mem", "rb") as memory, tempfile.NamedTemporaryFile() as file:
        memory.seek(start)
        file.write(memory.read(end - start))
        file.flush()
        text = subprocess.run(["objdump", "-D", "-b", "binary", "-m", "i386:x86-64", f"--adjust-vma={start}", file.name], capture_output=True,
                              text=True, check=True).stdout
    parts = (line.split("\t") for line in text.splitlines())
    return {int(part[0].strip(" :"), 16): part[2].strip() for part in parts if len(part) == 3}


def listing(pid, addresses):
    """The generated code at these addresses; the others are in functions of libraries."""
    code = {}
    for start, end in generated_code(pid):
        visited = [address for address in addresses if start <= address < end]
        if visited:
            code |= disassembly(pid, min(visited), min(max(visited) + 16, end))
    return "".join(f"{address:x}  {code.get(address, 'in a library')}\n" for address in addresses)


def period(addresses):
    """The median distance between visits of the address that is visited least often, but more than once."""
    visits = {}
    for index, address in enumerate(addresses):
        visits.setdefault(address, []).append(index)
    rarest = min((indices for indices in visits.values() if len(indices) > 1), key=len)
    distances = sorted(after - before for before, after in zip(rarest, rarest[1:]))
    return distances[len(distances) // 2]


class Runner:
    def __init__(self, folder, prefix, listings=None):
        self.folder, self.prefix, self.listings = folder, prefix, listings

    def count(self, kernel, defines, push):
        """The number of instructions of an iteration or of a workgroup. The dispatch takes so long that it is always found in execution."""
        write_program(self.folder, kernel, defines, push, groups=DISPATCHES)
        program = subprocess.Popen([*self.prefix, "./reproduce", "--timeout", "600"], cwd=self.folder, stdout=subprocess.DEVNULL)
        try:
            deadline = time.monotonic() + 60
            while program.poll() is None and time.monotonic() < deadline:
                time.sleep(0.2)
                thread = thread_in_generated_code(program.pid)
                if thread is not None:
                    addresses = next_addresses(thread, STEPS)
                    if self.listings is not None:
                        name = "_".join([kernel, *defines, *map(str, push)]).replace("=", "")
                        (self.listings / f"{name}.txt").write_text(listing(program.pid, addresses[-period(addresses):]))
                    ptrace(DETACH, thread)
                    return period(addresses)
            raise RuntimeError("the kernel was not found in execution")
        finally:
            if program.poll() is None:
                os.kill(program.pid, signal.SIGKILL)
            program.wait()

    def check(self, kernel, defines):
        """The last line that the program prints; it expects zeros."""
        write_program(self.folder, kernel, defines, groups=(WORDS // 8,), zeros=WORDS)
        program = subprocess.run([*self.prefix, "./reproduce"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        if program.returncode < 0:
            return f"ended by {signal.Signals(-program.returncode).name}"
        return (program.stdout.splitlines() or ["no output"])[-1]


def nested_conditions(runner):
    return ("form", "result"), [("nested", runner.check("nested_conditions", [])), ("unrolled", runner.check("nested_conditions", ["UNROLLED"]))]


def empty_branches(runner):
    """The instructions of an iteration whose branch is taken by 0, 1 and 8 lanes."""
    without = runner.count("empty_branches", ["CONDITION=0", "WITHOUT_BODY"], (ROUNDS, 0))
    rows = [("no branch", without, without, without)]
    for condition, name in enumerate(("of each lane", "subgroupAny()", "of push constants")):
        rows.append((name, *(runner.count("empty_branches", [f"CONDITION={condition}"], (ROUNDS, lanes)) for lanes in (0, 1, 8))))
    return ("condition", "0 lanes", "1 lane", "8 lanes"), rows


def uniform_loads(runner):
    """The instructions of a load outside and inside a loop: the difference between eight and four of them, divided by four."""
    rows = []
    for buffer in ([], ["TEXELS"]):
        for index, name in enumerate(("of each lane", "subgroupBroadcastFirst()", "of push constants and iteration")):
            row = []
            for loop in ([], ["LOOP"]):
                four, eight = (runner.count("uniform_loads", [f"INDEX={index}", f"LOADS={loads}u", *buffer, *loop], (ROUNDS, 0)) for loads in (4, 8))
                row.append((eight - four) / 4)
            rows.append(("texel" if buffer else "storage", name, *row))
    return ("buffer", "index", "outside", "in a loop"), rows


REPORTS = {"nested_conditions": nested_conditions, "empty_branches": empty_branches, "uniform_loads": uniform_loads}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report", choices=REPORTS)
    parser.add_argument("--listings", type=Path)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--prefix", type=shlex.split, default=[])
    options = parser.parse_args()
    if platform.machine() != "x86_64":
        sys.exit("run_report.py: the registers of other processors than x86-64 are not known")
    if options.listings is not None:
        options.listings.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        head, rows = REPORTS[options.report](Runner(options.folder or Path(folder), options.prefix, options.listings))
    for row in (head, ["---"] * len(head), *rows):
        print("| " + " | ".join(f"{cell:g}" if isinstance(cell, float) else str(cell) for cell in row) + " |")


if __name__ == "__main__":
    main()
