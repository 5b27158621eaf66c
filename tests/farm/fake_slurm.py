"""Programs with the names of Slurm's, for tests: jobs are submitted at once, and run when a test runs them."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

SBATCH = """
if number == os.environ.get("FAKE_REFUSES"):
    sys.exit("sbatch: error: QOSMaxSubmitJobPerUserLimit")
(folder / f"{number}.json").write_text(json.dumps([sys.argv[1:], os.fsdecode(pathlib.Path(sys.argv[-1]).read_bytes())]))
print(number)
if "--wait" in sys.argv:
    log = next(word.partition("=")[2] for word in sys.argv if word.startswith("--output="))
    log = log.replace("%x-%A_%a", f"candela-probe-{number}_4294967294")
    with open(log, "w") as file:
        sys.exit(subprocess.run(["sh", sys.argv[-1]], stdout=file, stderr=file).returncode)
"""
SCONTROL = """
if sys.argv[1] == "requeue":
    sys.exit(os.environ.get("FAKE_REQUEUE", 0))
print("MaxArraySize            = 1001")
"""
SQUEUE = """
sys.exit(7) if "FAKE_SQUEUE_FAILS" in os.environ else print(os.environ.get("FAKE_QUEUE", ""))
"""
START = """#!{python}
import json, os, pathlib, subprocess, sys
folder = pathlib.Path({folder!r})
number = str(1 + sum(1 for _ in folder.glob("*.json")))
"""


class FakeSlurm:
    def __init__(self, folder: Path):
        self.folder = folder
        self.jobs = folder / "jobs"
        self.programs = folder / "bin"
        self.jobs.mkdir(parents=True)
        self.programs.mkdir()
        for name, text in (("sbatch", SBATCH), ("scontrol", SCONTROL), ("squeue", SQUEUE)):
            program = self.programs / name
            program.write_text(START.format(python=sys.executable, folder=str(self.jobs)) + text)
            program.chmod(0o755)

    def environment(self, **variables):
        """Variables: FAKE_REFUSES, number of the job that sbatch refuses; FAKE_QUEUE, jobs that squeue lists;
        FAKE_SQUEUE_FAILS; FAKE_REQUEUE, text of a refusal of scontrol requeue."""
        return {**os.environ, **variables, "PATH": f"{self.programs}:{os.environ['PATH']}"}

    def submitted(self):
        """Returns the numbers of all jobs."""
        return sorted((file.stem for file in self.jobs.glob("*.json")), key=int)

    def run(self, number, **variables):
        """Runs the tasks of an array one after the other, in a folder of its own. Returns their exit codes."""
        options, text = json.loads((self.jobs / f"{number}.json").read_text())
        script = self.folder / "script"
        script.write_bytes(os.fsencode(text))
        spans = next(word.partition("=")[2] for word in options if word.startswith("--array="))
        codes = []
        for first, last in re.findall(r"(\d+)(?:-(\d+))?", spans):
            for index in range(int(first), int(last or first) + 1):
                task = self.environment(SLURM_ARRAY_JOB_ID=number, SLURM_ARRAY_TASK_ID=str(index), **variables)
                codes.append(subprocess.run(["sh", script], cwd=self.folder, env=task, stdout=subprocess.DEVNULL,
                                            stderr=subprocess.DEVNULL, check=False).returncode)
        return codes
