"""How frames are divided into shards: by the rate at which the first frame is rendered."""
import math

from frames import PlanError

DEFAULT_SHARD_MINUTES = 20
SAFETY = 3  # time limit of a shard, in multiples of the time that was predicted from the measured rate
STARTUP_MINUTES = 5  # reading the scene, compiling kernels, and writing the film


def stated_samples(frames):
    """Returns the samples per pixel of each frame; those of the first one may be None, since it is rendered.

    Raises PlanError if those of another frame are unknown: a scene may state them.
    """
    samples = [frame.stated_samples() for frame in frames]
    if None in samples[1:]:
        raise PlanError(f"frame {samples.index(None, 1) + 1} has no --spp; state it in every line of a list of frames")
    return samples


def seconds_per_frame(samples, description, probe_seconds):
    """Returns the time that one node needs for each frame, which is proportional to its samples per pixel."""
    if description["samples"] == 0:
        raise PlanError(f"no sample was rendered in {probe_seconds:g} s; ask for a longer --probe-time")
    width, height = map(int, description["size"].split("x"))
    rate = description["samples"] / max(description["work"]["phaseSeconds"]["trace"], 1e-3)
    print(f"{rate:.4g} samples per second: the first frame of {width}x{height} pixels and {samples[0]} samples per pixel "
          f"takes {width * height * samples[0] / rate / 60:.1f} min on one node")
    return [width * height * count / rate for count in samples]


def shard_counts(samples, seconds, shards=None, shard_minutes=None):
    """Returns the number of shards of each frame: `shards`, or as many as take `shard_minutes`, if its samples suffice."""
    minutes = shard_minutes or DEFAULT_SHARD_MINUTES
    wanted = [shards or math.ceil(one / (60 * minutes)) for one in seconds]
    return [max(1, min(count, available)) for count, available in zip(wanted, samples)]


def limit_of(seconds, counts):
    """Returns the time limit of a shard in minutes."""
    return STARTUP_MINUTES + math.ceil(SAFETY * max(one / count for one, count in zip(seconds, counts)) / 60)


def division_of(options):
    """Returns the option that was given to decide the number of shards, with its value, or None."""
    if options.shards:
        return f"--shards {options.shards}"
    return f"--shard-minutes {options.shard_minutes:g}" if options.shard_minutes else None
