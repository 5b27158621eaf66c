"""Frames of a distributed render: the arguments of one `candela` command each, divided into rendering and pictures."""
import re
import shlex
from dataclasses import dataclass
from pathlib import Path

PICTURE_OPTIONS = ("--tonemap", "--exposure")  # of `candela film` and `candela denoise`, which make the pictures
FILTER_OPTIONS = ("--device", "--hang-timeout", "--memory")  # of `candela render` that `candela denoise` has, too
PER_SHARD = "is set for each shard; leave it out"
REFUSED_OPTIONS = {
    **dict.fromkeys(("--checkpoint", "--resume", "--resume-anyway", "--samples", "--crop", "--time-limit", "--json",
                     "--checkpoint-every"), PER_SHARD),
    "--frames": "belongs before --, with the options of this program",
    "--noise-threshold": "decides by all samples of a pixel, and a shard has only some of them; leave it out",
}


class PlanError(Exception):
    """A wrong request: a message for the user."""


def words_of(line):
    """Returns the words of a line of a list of frames. Quotes, backslashes and comments are those of a shell, where # begins
    a comment only at the beginning of a word. Raises ValueError if a quote is not closed."""
    previous = " "
    for part in re.finditer(r"""'[^']*'|"(?:\\.|[^"\\])*"|\\.|.""", line):
        if part.group() == "#" and previous.isspace():
            return shlex.split(line[:part.start()])
        previous = part.group()
    return shlex.split(line)


def split_word(word):
    """Returns the option, "=" or nothing, and the value of `--option=value`, `-o=value` and `-ovalue`."""
    if word.startswith("-o") and word[2:3] not in ("", "="):
        return "-o", "=", word[2:]
    return word.partition("=")


def values_of(arguments, names):
    """Returns pairs of option and value, in their order, for the options in `names`. The last value may be missing."""
    words = iter(arguments)
    pairs = []
    for word in words:
        option, equals, value = split_word(word)
        if option in names:
            pairs.append([option, value if equals else next(words, "")])
    return pairs


@dataclass
class Frame:
    render: list  # arguments of `candela render` that decide the image
    pictures: list  # pairs of option and value for `candela film` or `candela denoise`

    def outputs(self):
        return [value for option, value in self.pictures if option == "-o"]

    def stated_samples(self):
        """Returns the samples per pixel of --spp, or None without this option. Raises PlanError if it is no number."""
        for _, value in reversed(values_of(self.render, ("--spp",))):
            if not (value.isascii() and value.isdigit()):
                raise PlanError(f"--spp {value}: is not a number of samples")
            return max(1, int(value))  # --spp 0 is one sample without antialiasing
        return None

    def picture_command(self, candela, film: Path):
        """Returns the command that makes the pictures from the film."""
        pictures = [word for pair in self.pictures for word in pair]
        if "--denoise" not in self.render:
            return [candela, "film", str(film), *pictures]
        execution = [word for pair in values_of(self.render, FILTER_OPTIONS) for word in pair]
        return [candela, "denoise", str(film), *execution, *(["--no-cache"] if "--no-cache" in self.render else []),
                *pictures]

    def has_relative_files(self, folder: Path):
        """Returns whether an output, or an argument that is the name of a file of this folder, is relative."""
        words = [split_word(word)[2] or word for word in self.render]
        files = self.outputs() + [word for word in words if word and (folder / word).exists()]
        return any(not Path(file).is_absolute() for file in files)


def frame_of(arguments):
    """Divides the arguments of one `candela` command into those that render and those that make pictures."""
    render, pictures = [], []
    position = 0
    while position < len(arguments):
        option, equals, value = split_word(arguments[position])
        if option in REFUSED_OPTIONS:
            raise PlanError(f"{option}: {REFUSED_OPTIONS[option]}")
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
    if not render:
        raise PlanError("a scene is missing")
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
