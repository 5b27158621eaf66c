"""Sequences: one `candela` command for many frames of an animation or a turntable becomes one command for each frame."""
import math
import re

from frames import PlanError, frame_of, split_word

RANGE = re.compile(r"([0-9]+):([0-9]+)")  # frames, half-open
DEFAULT_FPS = 24
VARYING = ("--fps", "--turntable", "--orbit", "--seed", "--time")  # options that differ between the frames


def range_of(text):
    """Returns the frames of a range A:B, or None for any other text, the name of a list. Raises PlanError if A is not below
    B."""
    match = RANGE.fullmatch(text)
    if match is None:
        return None
    first, end = map(int, match.groups())
    if first >= end:
        raise PlanError(f"--frames {text}: the first frame is not below the end")
    return range(first, end)


def frame_file(pattern, frame):
    """Returns the file of a frame: the last run of # in the name of the pattern is replaced by the number of the frame."""
    folder, slash, name = pattern.rpartition("/")
    runs = list(re.finditer("#+", name))
    if not runs:
        raise PlanError(f"-o {pattern}: the name lacks a place for the number of the frame, as in frame.####.png")
    run = runs[-1]
    return f"{folder}{slash}{name[:run.start()]}{frame:0{len(run.group())}}{name[run.end():]}"


def divided(arguments):
    """Returns the values of the varying options, by their names, and all other arguments."""
    values, others = {}, []
    words = iter(arguments)
    for word in words:
        option, equals, value = split_word(word)
        if option in VARYING:
            values[option] = value if equals else next(words, "")
        else:
            others.append(word)
    return values, others


def number(values, option, kind, default, lowest=-math.inf):
    """Returns the value of an option. Raises PlanError if it is no number, or below `lowest`."""
    try:
        value = kind(values.get(option, default))
        if option not in values or value >= lowest:
            return value
    except ValueError:
        pass
    raise PlanError(f"{option} {values[option]}: is not a number that this option accepts")


def options_of(values, frame):
    """Returns the options of one frame, with the numbers that `candela render --frames` computes."""
    turn = number(values, "--turntable", int, 0, 1)
    options = []
    if not turn or "--fps" in values:
        if "--time" in values:
            raise PlanError("--time: each frame of the sequence has its own; leave it out")
        options += ["--time", repr(frame / number(values, "--fps", float, DEFAULT_FPS, 1e-3))]
    elif "--time" in values:
        options += ["--time", values["--time"]]
    orbit = number(values, "--orbit", float, 0)
    if turn:
        orbit = math.fmod(orbit + 360.0 * (frame % turn) / turn, 360)
    if orbit:
        options += ["--orbit", repr(orbit)]
    if "--seed" in values:
        options += ["--seed", str(frame) if values["--seed"] == "frame" else values["--seed"]]
    return options


def sequence_of(frames, arguments):
    """Returns the frames of a sequence, given the arguments of the command that renders all of them. `frames` is a range, or
    None for those of --turntable; without that option, there is one frame."""
    values, others = divided(arguments)
    if frames is None:
        if "--turntable" not in values:
            return [frame_of(arguments)]
        frames = range(number(values, "--turntable", int, 0, 1))
    result = []
    for frame in frames:
        one = frame_of([*others, *options_of(values, frame)])
        one.pictures = [[option, frame_file(value, frame) if option == "-o" else value] for option, value in one.pictures]
        result.append(one)
    return result
