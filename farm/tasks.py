"""The work of one task: rendering a shard, and merging the shards of a frame. This file is independent of schedulers."""
import fcntl
import os
import signal
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path

import plan as planning

SUCCESS = 0
USAGE = 1
INTERRUPTED = 7  # of candela: the film is written and can be resumed
STOPS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
LOCK_POLL_SECONDS = 1


def try_lock(file):
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return True
    except BlockingIOError:
        return False


@contextmanager
def exclusive(path: Path, child):
    """Holds a lock on `path`; waits until it is free, since a requeued task may overlap with its earlier run.

    Yields False, without the lock, if the task is stopped while it waits.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        is_locked = try_lock(file)
        if not is_locked:
            print(f"{path}: is locked by another task; waiting for its end", flush=True)
        while not is_locked and not child.is_stopped:
            time.sleep(LOCK_POLL_SECONDS)
            is_locked = try_lock(file)
        yield is_locked


class Child:
    """Runs a program and passes signals on to it, so that it can write its film.

    The program has a session of its own: a signal to the whole group of this process (Ctrl-C, `systemctl stop`) reaches
    it once. SIGUSR2 announces that the time of this task is nearly over; the program is stopped, as it is by SIGTERM.
    """

    def __init__(self):
        self.process = None
        self.is_stopped = False
        self.is_out_of_time = False
        for number in (*STOPS, signal.SIGUSR1, signal.SIGUSR2):
            signal.signal(number, self.forward)

    def forward(self, number, _frame):
        self.is_stopped = self.is_stopped or number != signal.SIGUSR1
        self.is_out_of_time = self.is_out_of_time or number == signal.SIGUSR2
        if self.process is not None and self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM if number == signal.SIGUSR2 else number)

    def run(self, command):
        """Returns the exit code, or 128 plus the number of the signal that ended the program; INTERRUPTED if it was
        stopped before it could write anything."""
        if self.is_stopped:
            return INTERRUPTED
        self.process = subprocess.Popen(command, start_new_session=True)
        if self.is_stopped:  # by a signal that came before there was a process to pass it on to
            self.process.send_signal(signal.SIGTERM)
        code = self.process.wait()
        if self.is_stopped and -code in STOPS:  # before it handled signals; its last film is still there
            return INTERRUPTED
        return code if code >= 0 else 128 - code


def shard_command(plan, job: Path, frame: int, shard: int):
    first, end = plan.range_of(frame, shard)
    film = planning.shard_file(job, frame, shard)
    command = [plan.candela, "render", *plan.frames[frame].render, "--samples", f"{first}:{end}", "--checkpoint", str(film),
               "--checkpoint-every", plan.checkpoint_every]
    return command + (["--resume", str(film)] if film.exists() else [])


def render_shard(plan, job: Path, frame: int, shard: int, child: Child):
    """Renders the missing samples of the shard. Returns candela's exit code, or SUCCESS if none were missing."""
    film = planning.shard_file(job, frame, shard)
    with exclusive(film.with_suffix(".lock"), child) as is_locked:
        if not is_locked:
            return INTERRUPTED
        description = planning.describe(plan.candela, film)
        if child.is_stopped:
            return INTERRUPTED
        if planning.covers_shard(plan, frame, shard, description):
            print(f"{film}: is complete", flush=True)
            return SUCCESS
        if film.exists() and description is None:
            aside = film.with_suffix(f".damaged-{os.getpid()}")
            film.rename(aside)
            print(f"{film}: is damaged; it is kept as {aside.name}, and the shard starts again", flush=True)
        return child.run(shard_command(plan, job, frame, shard))


def merge_shards(plan, job: Path, frame: int, child: Child):
    """Makes the film of a frame, unless it is complete. Returns candela's exit code."""
    if planning.is_film_done(plan, job, frame):
        return SUCCESS
    shards = [str(planning.shard_file(job, frame, shard)) for shard in range(plan.shards[frame])]
    return child.run([plan.candela, "merge", *shards, "-o", str(planning.film_file(job, frame))])


def make_pictures(plan, job: Path, frame: int, child: Child):
    if not plan.frames[frame].outputs():
        return SUCCESS
    code = child.run(plan.frames[frame].picture_command(plan.candela, planning.film_file(job, frame)))
    if code == SUCCESS:
        planning.pictures_mark(job, frame).touch()
    return code


def merge_frame(plan, job: Path, frame: int, child: Child):
    """Merges the shards of a frame and makes its pictures. Returns candela's exit code."""
    with exclusive(planning.film_file(job, frame).with_suffix(".lock"), child) as is_locked:
        if not is_locked:
            return INTERRUPTED
        planning.pictures_mark(job, frame).unlink(missing_ok=True)
        return merge_shards(plan, job, frame, child) or make_pictures(plan, job, frame, child)
