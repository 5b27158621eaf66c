"""The plan of a distributed render: frames, each divided into shards by ranges of samples.

A plan is stored as plan.json in the folder of the job, which every machine sees. Shards and films have fixed names in
that folder, so that the files alone show the progress.
"""
import json
import os
import subprocess
from bisect import bisect_right
from dataclasses import asdict, dataclass, field
from itertools import accumulate
from pathlib import Path

from frames import Frame, PlanError

FORMAT = 2
UNUSABLE = 2  # of candela: an invalid or unreadable file


def write_json(path: Path, content):
    """Replaces the file at once: other processes read either the old or the new content."""
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.write_text(json.dumps(content, indent=1))
    temporary.replace(path)


@dataclass
class Plan:
    candela: str
    folder: str  # absolute; relative names of files in the frames are those of this folder
    frames: list
    samples: list  # per pixel, of each frame
    shards: list  # number of shards of each frame
    division: str  # the option that decided the number of shards, with its value
    minutes: int  # time limit of a shard
    checkpoint_every: str  # of candela: minimum time between two writes of a shard's film
    sbatch: list = field(default_factory=list)
    running: int = 0  # maximum number of shards at a time; 0: no limit

    def tasks(self):
        """Returns pairs of frame and shard. The index of a task is its position in this list."""
        return [(frame, shard) for frame, count in enumerate(self.shards) for shard in range(count)]

    def task(self, index):
        """Returns the frame and the shard of a task."""
        ends = list(accumulate(self.shards))
        frame = bisect_right(ends, index)
        return frame, index - ends[frame] + self.shards[frame]

    def range_of(self, frame, shard):
        """Returns the samples of a shard: the ranges of a frame differ in length by at most 1."""
        samples, shards = self.samples[frame], self.shards[frame]
        return shard * samples // shards, (shard + 1) * samples // shards

    def save(self, folder: Path):
        write_json(folder / "plan.json", {"format": FORMAT, **asdict(self)})

    @staticmethod
    def load(folder: Path):
        """Raises PlanError if the folder has no plan of this format."""
        try:
            content = json.loads((folder / "plan.json").read_text())
            if content.pop("format") != FORMAT:
                raise PlanError(f"{folder}/plan.json: was written by another version of this program; let that version "
                                "finish the job, or choose another --job")
            return Plan(**{**content, "frames": [Frame(**frame) for frame in content["frames"]]})
        except FileNotFoundError:
            raise PlanError(f"{folder}: has no plan.json") from None
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise PlanError(f"{folder}/plan.json: is damaged ({error}); delete it and submit again") from None


def folder_of(job: Path, frame: int):
    return job / f"frame-{frame:05}"


def shard_file(job: Path, frame: int, shard: int):
    return folder_of(job, frame) / f"shard-{shard:05}.exr"


def film_file(job: Path, frame: int):
    return folder_of(job, frame) / "film.exr"


def pictures_mark(job: Path, frame: int):
    """An empty file that exists while the pictures are those of the film."""
    return folder_of(job, frame) / "pictures.done"


def describe(candela, film: Path):
    """Returns the report of `candela film`, or None if the file is missing or not a film.

    Raises PlanError if the program fails for another reason, for example without memory or by a signal, and OSError if
    the file cannot be read: a good film must not be taken for a damaged one. The program has a session of its own, so
    that signals to the group of this process do not end it.
    """
    if not film.exists():
        return None
    run = subprocess.run([candela, "film", str(film), "--json", "-", "-q"], capture_output=True, text=True, check=False,
                         start_new_session=True)
    if run.returncode == 0:
        return json.loads(run.stdout)
    if run.returncode != UNUSABLE:
        cause = run.stderr.strip() or f"candela film ended with {run.returncode}"
        raise PlanError(f"{film}: cannot be examined: {cause}")
    read_whole(film)
    return None


def read_whole(file: Path):
    """Reads the file to its end. Raises OSError if it cannot be read."""
    with open(file, "rb") as stream:
        while stream.read(1 << 24):
            pass


def covers_shard(plan: Plan, frame: int, shard: int, description):
    """Returns whether a film with this description has all samples of the shard. `description` may be None."""
    if description is None:
        return False
    first, end = plan.range_of(frame, shard)
    return f"samples {first}:{end} of crop {description['window']}" in description["covered"]


def is_shard_done(plan: Plan, job: Path, frame: int, shard: int):
    return covers_shard(plan, frame, shard, describe(plan.candela, shard_file(job, frame, shard)))


def is_film_done(plan: Plan, job: Path, frame: int):
    description = describe(plan.candela, film_file(job, frame))
    return description is not None and description["complete"]


def has_pictures(plan: Plan, job: Path, frame: int):
    """Returns whether the pictures were made from the film. Files that only have their names are not pictures of it."""
    files = [Path(plan.folder) / output for output in plan.frames[frame].outputs()]
    return not files or (pictures_mark(job, frame).exists() and all(file.exists() for file in files))
