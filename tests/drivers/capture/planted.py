"""Plants faults in a compiler, one at a time, and requires that `candela conformance` finds each in a related case.

The layer of miscompiler.cpp changes modules on their way to the driver. A mutant is a name, the change, the cases that run,
and a pattern: at least one case that fails must match it. With --table, docs/planted-compiler-faults.md is printed.
"""
import argparse
import fnmatch
import json
import os
import pathlib
import re
import subprocess
import sys

INTEGER, SAMPLER, FLOAT = "leaf.integer.*", "leaf.sampler.*", "leaf.float.*"
MEMORY = "memory.*"
CONTROL = "control.*"
CORNELL = "kernel.megakernel.layout.cwbvh.texel.cornell"
PRIMITIVES = "kernel.megakernel.scene.primitives"

# Opcodes: the SPIR-V specification; 12/K: GLSL.std.450.
MUTANTS = [
    ("remainder instead of quotient", "134:all:137", INTEGER, "leaf.integer.divide"),
    ("quotient instead of remainder", "137:all:134", INTEGER, "leaf.integer.divide"),
    ("operands of a division of integers exchanged", "134:all:swap", INTEGER, "leaf.integer.divide"),
    ("shift to the right extends the sign", "194:all:195", INTEGER, "leaf.integer.shift"),
    ("arithmetic shift does not extend the sign", "195:all:194", INTEGER, "leaf.integer.shift"),
    ("shift to the wrong side", "196:0:194", INTEGER, "leaf.integer.shift"),
    ("borrow instead of carry", "149:all:150", INTEGER, "leaf.integer.add_carry"),
    ("carry instead of borrow", "150:all:149", INTEGER, "leaf.integer.add_carry"),
    ("extended product of signed numbers", "151:all:152", INTEGER, "leaf.integer.multiply_extended"),
    ("extended product of unsigned numbers", "152:all:151", INTEGER, "leaf.integer.multiply_extended"),
    ("inverted instead of reversed bits", "204:all:200", INTEGER, "leaf.integer.count_bits"),
    ("bits reversed instead of counted", "205:all:204", INTEGER, "leaf.integer.count_bits"),
    ("bit field without its sign", "202:all:203", INTEGER, "leaf.integer.bitfield"),
    ("bit field with a sign", "203:all:202", INTEGER, "leaf.integer.bitfield"),
    ("maximum instead of minimum", "12/38:all:41", INTEGER, "leaf.integer.min_max"),
    ("minimum of signed numbers as of unsigned ones", "12/39:all:38", INTEGER, "leaf.integer.min_max"),
    ("highest instead of lowest bit", "12/73:all:75", INTEGER, "leaf.integer.count_bits"),
    ("difference instead of exclusive or", "198:all:130", SAMPLER, "leaf.sampler.*"),
    ("difference instead of sum", "129:all:131", FLOAT, "leaf.float.add"),
    ("sum instead of product", "133:all:129", FLOAT, "leaf.float.multiply"),
    ("operands of a division exchanged", "136:all:swap", FLOAT, "leaf.float.divide"),
    ("inverse of the square root", "12/31:all:32", FLOAT, "leaf.float.sqrt"),
    ("rounded up instead of down", "12/8:all:9", FLOAT, "leaf.float.floor"),
    ("rounded down instead of to zero", "12/3:all:8", FLOAT, "leaf.float.trunc"),
    ("rounded to zero instead of to the nearest", "12/2:all:3", FLOAT, "leaf.float.round_even"),
    ("cosine instead of sine", "12/13:all:14", FLOAT, "leaf.float.sin"),
    ("natural instead of binary exponential", "12/29:all:27", FLOAT, "leaf.float.exp2"),
    ("binary instead of natural logarithm", "12/28:all:30", FLOAT, "leaf.float.log"),
    ("less or equal instead of less", "184:all:188", FLOAT, "leaf.float.compare"),
    ("greater instead of greater or equal", "190:all:186", FLOAT, "leaf.float.compare"),
    ("signed integer converted as an unsigned one", "111:all:112", FLOAT, "leaf.float.from_int"),
    ("unsigned integer converted as a signed one", "112:all:111", FLOAT, "leaf.float.from_uint"),
    ("barrier of a workgroup left out", "224:1:drop", MEMORY, "memory.s*"),
    ("all barriers of workgroups left out", "224:all:drop", MEMORY, "memory.shared.*"),
    ("atomic difference instead of sum", "234:all:235", MEMORY, "memory.atomic.*"),
    ("atomic maximum instead of minimum", "237:all:239", MEMORY, "memory.atomic.combine"),
    ("atomic or instead of and", "240:all:241", MEMORY, "memory.atomic.combine"),
    ("atomic or instead of exclusive or", "242:all:241", MEMORY, "memory.atomic.combine"),
    ("atomic sum instead of exchange", "229:all:234", MEMORY, "memory.atomic.exchange"),
    ("operands of a selection exchanged", "169:all:swap", CONTROL, "control.*"),
    ("bound of a loop off by one", "176:0:178", CONTROL, "control.loop.*"),
    ("condition of a branch inverted", "250:2:swap", CONTROL, "control.*"),
    ("or instead of and of conditions", "167:all:166", CONTROL, "control.*"),
    ("equal instead of not equal", "171:all:170", CONTROL, "control.*"),
    ("component of a vector off by one", "81:0:plus", CONTROL, "control.*"),
    ("kernel: sum instead of a product", "133:40:129", CORNELL, CORNELL),
    ("kernel: operands of a difference exchanged", "131:12:swap", CORNELL, CORNELL),
    ("kernel: operands of a division exchanged", "136:9:swap", CORNELL, CORNELL),
    ("kernel: operands of a selection exchanged", "169:5:swap", CORNELL, CORNELL),
    ("kernel: condition of a branch inverted", "250:19:swap", PRIMITIVES, PRIMITIVES),
    ("kernel: greater instead of less", "184:6:186", PRIMITIVES, PRIMITIVES),
    ("kernel: sums instead of differences", "131:all:129", PRIMITIVES, PRIMITIVES),
]


TABLE_HEAD = """# Planted faults of compilers

Each row is a change that a Vulkan layer makes in the SPIR-V modules on their way to the driver, as a faulty compiler would, and the first
cases of [`candela conformance`](conformance.md#planted-faults) that find it, at most two. A change is `OPCODE:WHICH:HOW`: the opcode of the SPIR-V
specification (`12/K`: instruction K of GLSL.std.450), which of its instructions is changed, counting from 0 (or all), and the new opcode, or `swap`
(the last two operands exchanged), `drop` (the instruction left out) or `plus` (the last operand increased by 1). The page is printed by the command
below, with the lavapipe of the tests, and a test requires that each change is found.

    python3 tests/drivers/capture/planted.py --program build/release/candela --layers build/release/tests/drivers/capture/layers --icd LAVAPIPE.json --table

| fault | change | found by |
|---|---|---|"""


def run(options, cases, change):
    environment = dict(os.environ, VK_DRIVER_FILES=options.icd, VK_ICD_FILENAMES=options.icd, VK_LAYER_PATH=options.layers,
                       VK_INSTANCE_LAYERS="VK_LAYER_CANDELA_miscompiler")
    if change:
        environment["CANDELA_MISCOMPILE"] = change
    words = [options.program, "conformance", "--cases", cases, "--jobs", "2", "--timeout", "20s", "--json", "-"]
    result = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=600)
    if result.returncode not in (0, 3):
        sys.exit(f"candela conformance ends with {result.returncode}: {result.stderr}")
    return {case["name"] for case in json.loads(result.stdout)["cases"] if case["result"] in ("Fail", "Crash", "Timeout")}


def unlisted():
    """The mutants that the page lacks, or states differently."""
    page = pathlib.Path(__file__).resolve().parents[3] / "docs/planted-compiler-faults.md"
    rows = page.read_text(encoding="utf-8").splitlines()
    return [name for name, change, _, _ in MUTANTS if not any(row.startswith(f"| {name} | `{change}` | `") for row in rows)]


def main():
    parser = argparse.ArgumentParser()
    for name in ("program", "layers", "icd"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--only", default="", help="regular expression of names")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="plant the first of each N of them")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    chosen = [mutant for mutant in MUTANTS if re.search(options.only, mutant[0])][::options.every]
    sound = {cases: run(options, cases, None) for cases in {mutant[2] for mutant in chosen}}
    missed = []
    if options.table:
        print(TABLE_HEAD)
    for name, change, cases, culprit in chosen:
        failed = sorted(run(options, cases, change) - sound[cases])
        found = [case for case in failed if fnmatch.fnmatch(case, culprit)]
        if options.table:
            print(f"| {name} | `{change}` | {', '.join(f'`{case}`' for case in (found or failed)[:2]) or 'nothing'} |")
        else:
            print(f"{'found ' if found else 'MISSED'} {name} ({change}): {len(failed)} cases fail, e.g. {(found or failed)[:2]}")
        sys.stdout.flush()
        if not found:
            missed.append(name)
    if missed or not options.table:
        print(f"{len(missed)} missed: {missed}")
    if not options.table and unlisted():
        print(f"docs/planted-compiler-faults.md lacks {unlisted()}; print it again with --table")
        return 1
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
