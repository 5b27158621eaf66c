"""The commands of Slurm that submit, list and requeue jobs."""
import os
import re
import subprocess
from pathlib import Path


class Refused(Exception):
    """Slurm is not installed, or refused a command: a message for the user."""


def run(*command):
    """Returns what a command of Slurm prints. Raises Refused if it fails."""
    try:
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        raise Refused(f"{command[0]} is not installed; run this on a node that submits jobs") from None
    if ended.returncode != 0:
        cause = ended.stderr.strip() or f"ended with exit code {ended.returncode}, without a message"
        raise Refused(f"{command[0]}: {cause}")
    return ended.stdout.strip()


def submit(text, job: Path, *options):
    """Submits a script whose output goes to the logs of the job. Returns the number of the Slurm job."""
    path = job / f"submit-{os.getpid()}.sh"
    path.write_bytes(os.fsencode(text))
    try:
        return run("sbatch", "--parsable", f"--output={job}/logs/%x-%A_%a.log", "--open-mode=append", *options,
                   str(path)).split(";")[0]
    finally:
        path.unlink()


def compact(indices):
    """Returns indices in sbatch's notation: 0-3,5."""
    spans = []
    for index in indices:
        if spans and spans[-1][1] == index - 1:
            spans[-1][1] = index
        else:
            spans.append([index, index])
    return ",".join(str(first) if first == last else f"{first}-{last}" for first, last in spans)


def max_array_size():
    found = re.search(r"MaxArraySize\s*=\s*(\d+)", run("scontrol", "show", "config"))
    return int(found.group(1)) if found else 1001


def queued(numbers):
    """Returns those of the jobs of this user that have not ended."""
    if not numbers:
        return []
    listed = run("squeue", "--noheader", "--me", "--format=%F").split()
    return [number for number in numbers if number in listed]


def requeue_this_task():
    """Requeues the task that runs this process, which Slurm ends soon after. Prints why if Slurm refuses."""
    name = f"{os.environ['SLURM_ARRAY_JOB_ID']}_{os.environ['SLURM_ARRAY_TASK_ID']}"
    print(f"{name}: the time limit is near; the film is written, and Slurm is asked to requeue the task", flush=True)
    try:
        run("scontrol", "requeue", name)
    except Refused as error:
        print(f"{name}: is not requeued ({error}); the command that submitted it submits the shard again", flush=True)
