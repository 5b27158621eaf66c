"""The plan of a distributed render: frames, each divided into shards by ranges of samples.

A plan is stored as plan.json in the folder of the job, which every machine sees. Shards and films have fixed names in
that folder, so that the files alone show the progress.
"""
import json
import os
import subprocess
from dataclasses import asdict, dataclass, field
from pathlib import Path

FORMAT = 1
UNUSABLE = 2  # of candela: an invalid or unreadable file
PICTURE_OPTIONS = ("--tonemap", "--exposure")  # of `candela film`, which makes the pictures
REFUSED_OPTIONS = ("--checkpoint", "--resume", "--resume-anyway", "--samples", "--crop", "--time-limit", "--json",
                   "--checkpoint-every")


class PlanError(Exception):
    """A wrong request: a message for the user."""


@dataclass
class Frame:
    render: list  # arguments of `candela render` that decide the image
    pictures: list  # pairs of option and value for `candela film`

    def outputs(self):
        return [value for option, value in self.pictures if option == "-o"]


@dataclass
class Plan:
    candela: str
    frames: list
    samples: int  # per pixel
    shards: int  # of each frame
    minutes: int  # time limit of a shard
    checkpoint_every: str  # of candela: minimum time between two writes of a shard's film
    sbatch: list = field(default_factory=list)
    running: int = 0  # maximum number of shards at a time; 0: no limit

    def task_count(self):
        return len(self.frames) * self.shards

    def range_of(self, shard):
        """Returns the samples of a shard: ranges differ in length by at most 1."""
        return shard * self.samples // self.shards, (shard + 1) * self.samples // self.shards

    def save(self, folder: Path):
        text = json.dumps({"format": FORMAT, **asdict(self)}, indent=1)
        temporary = folder / f"plan.json.{os.getpid()}"
        temporary.write_text(text)
        temporary.replace(folder / "plan.json")

    @staticmethod
    def load(folder: Path):
        """Raises PlanError if the folder has no plan of this format."""
        try:
            content = json.loads((folder / "plan.json").read_text())
            if content.pop("format") != FORMAT:
                raise PlanError(f"{folder}/plan.json: written by another version of this program")
            return Plan(**{**content, "frames": [Frame(**frame) for frame in content["frames"]]})
        except FileNotFoundError:
            raise PlanError(f"{folder}: has no plan.json") from None
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise PlanError(f"{folder}/plan.json: is damaged ({error}); delete it and submit again") from None


def frame_of(arguments):
    """Divides the arguments of one `candela` command into those that render and those that make pictures."""
    render, pictures = [], []
    position = 0
    while position < len(arguments):
        option, equals, value = arguments[position].partition("=")
        if option in REFUSED_OPTIONS:
            raise PlanError(f"{option}: is set for each shard; leave it out")
        position += 1
        if option not in ("-o", "--output", *PICTURE_OPTIONS):
            render.append(arguments[position - 1])
            continue
        if not equals:
            if position == len(arguments):
                raise PlanError(f"{option}: needs a value")
            value = arguments[position]
            position += 1
        pictures.append(["-o" if option == "--output" else option, value])
    return Frame(render, pictures)


def check_outputs(frames):
    """Raises PlanError if two frames would write the same file, or a file has no folder."""
    seen = set()
    for output in (Path(value).resolve() for frame in frames for value in frame.outputs()):
        if output in seen:
            raise PlanError(f"{output}: is the output of two frames")
        if not output.parent.is_dir():
            raise PlanError(f"{output}: its folder does not exist")
        seen.add(output)


def folder_of(job: Path, frame: int):
    return job / f"frame-{frame:05}"


def shard_file(job: Path, frame: int, shard: int):
    return folder_of(job, frame) / f"shard-{shard:05}.exr"


def film_file(job: Path, frame: int):
    return folder_of(job, frame) / "film.exr"


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


def covers_shard(plan: Plan, shard: int, description):
    """Returns whether a film with this description has all samples of the shard. `description` may be None."""
    if description is None:
        return False
    first, end = plan.range_of(shard)
    return f"samples {first}:{end} of crop {description['crop']}" in description["covered"]


def is_shard_done(plan: Plan, job: Path, frame: int, shard: int):
    return covers_shard(plan, shard, describe(plan.candela, shard_file(job, frame, shard)))


def is_film_done(plan: Plan, job: Path, frame: int):
    description = describe(plan.candela, film_file(job, frame))
    return description is not None and description["complete"]


def has_pictures(plan: Plan, frame: int):
    return all(Path(output).exists() for output in plan.frames[frame].outputs())
