#!/usr/bin/env python3
"""Simulates a render on many nodes that may be preempted at any time, and prints its cost.

    simulate.py [--nodes 1000] [--node-hours 2000] [--shards 4000] [--preemptions-per-day 6] ...

A node renders one shard at a time and writes its film every --checkpoint seconds, but only in 1 % of its time, as
candela does. Preemptions of a node are a Poisson
process; the shard loses what it rendered since its last checkpoint, waits in the queue, and goes on where a node is
free. When all shards are done they are merged, as a tree: groups of --fan-in at a time on as many nodes. See
docs/farm.md for what was found.
"""
import argparse
import heapq
import math
import random
from dataclasses import dataclass


@dataclass
class Outcome:
    finished: float = 0  # seconds until the last shard was done
    merged: float = 0  # seconds until the film was complete
    lost: float = 0  # node seconds whose samples were lost
    preemptions: int = 0
    written: float = 0  # bytes of checkpoints and merged films
    read: float = 0  # bytes of films that were resumed or merged


def write_time(options):
    return options.film_bytes / options.bandwidth


def checkpoint_interval(options):
    """Returns the seconds of work between two checkpoints: the next one waits for a hundred times the last one."""
    return max(options.checkpoint, 100 * write_time(options))


def checkpoints_in(work, options):
    return math.floor(work / checkpoint_interval(options))


def duration_of_attempt(work, options):
    """Returns the time that rendering `work` seconds takes if nothing happens: start and films included."""
    return options.startup + work + (checkpoints_in(work, options) + 1) * write_time(options)


def work_saved(elapsed, options):
    """Returns how much of the work is in the last checkpoint after `elapsed` seconds of an attempt."""
    interval = checkpoint_interval(options)
    return max(0, math.floor((elapsed - options.startup) / (interval + write_time(options)))) * interval


def render(options, random_numbers, outcome):
    """Simulates the nodes event by event."""
    per_shard = options.node_hours * 3600 / options.shards
    waiting = [per_shard * random_numbers.lognormvariate(0, options.spread) for _ in range(options.shards)]
    free_at = [(0.0, node) for node in range(options.nodes)]  # when a node can take a shard
    heapq.heapify(free_at)
    returned = []  # shards whose node was taken away: when, and the work left
    rate = options.preemptions_per_day / 86400
    while waiting or returned:
        now, node = heapq.heappop(free_at)
        if not waiting and returned[0][0] > now:
            heapq.heappush(free_at, (returned[0][0], node))
            continue
        if returned and returned[0][0] <= now:
            work, is_resumed = heapq.heappop(returned)[1], True
        else:
            work, is_resumed = waiting.pop(), False
        outcome.read += options.film_bytes if is_resumed else 0
        needed = duration_of_attempt(work, options)
        until_preemption = random_numbers.expovariate(rate) if rate > 0 else math.inf
        if until_preemption >= needed:
            outcome.written += (checkpoints_in(work, options) + 1) * options.film_bytes
            outcome.finished = max(outcome.finished, now + needed)
            heapq.heappush(free_at, (now + needed, node))
            continue
        saved = min(work, work_saved(until_preemption, options))
        outcome.preemptions += 1
        outcome.lost += until_preemption - saved
        outcome.written += checkpoints_in(saved, options) * options.film_bytes
        heapq.heappush(returned, (now + until_preemption + options.requeue, work - saved))
        heapq.heappush(free_at, (now + until_preemption + options.absence, node))


def merge(options, outcome):
    """Adds the time of merging: each step reads its films, writes one, and waits for the step before."""
    films, seconds = options.shards, 0.0
    while films > 1:
        groups = math.ceil(films / options.fan_in)
        inputs = math.ceil(films / groups)
        rounds = math.ceil(groups / options.nodes)
        seconds += rounds * (options.startup + (inputs + 1) * options.film_bytes / options.merge_rate)
        outcome.read += films * options.film_bytes
        outcome.written += groups * options.film_bytes
        films = groups
    outcome.merged = outcome.finished + seconds


def simulate(options):
    outcome = Outcome()
    render(options, random.Random(options.seed), outcome)
    merge(options, outcome)
    return outcome


def parse(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    add = parser.add_argument
    add("--nodes", type=int, default=1000)
    add("--node-hours", type=float, default=2000, help="rendering time of the whole film on one node")
    add("--shards", type=int, default=4000)
    add("--spread", type=float, default=0.1, help="standard deviation of the logarithm of a shard's time")
    add("--preemptions-per-day", type=float, default=6, help="of each node")
    add("--absence", type=float, default=600, help="seconds until a node that was taken away is back")
    add("--requeue", type=float, default=120, help="seconds that a shard waits before it is started again")
    add("--startup", type=float, default=20, help="seconds for loading the scene and compiling kernels")
    add("--checkpoint", type=float, default=60, help="seconds between two checkpoints")
    add("--film-bytes", type=float, default=60e6, help="size of a film: some 60 MB at 1920x1080")
    add("--bandwidth", type=float, default=30e6, help="bytes per second at which a node writes its film")
    add("--merge-rate", type=float, default=50e6, help="bytes per second at which a merge adds films")
    add("--fan-in", type=int, default=64, help="films that one task merges")
    add("--seed", type=int, default=0)
    return parser.parse_args(arguments)


def main():
    options = parse()
    outcome = simulate(options)
    ideal = options.node_hours * 3600 / options.nodes
    print(f"ideal           {ideal / 60:9.1f} min: no losses, no start, perfectly even")
    print(f"shards done     {outcome.finished / 60:9.1f} min: {outcome.finished / ideal:.2f} times the ideal")
    print(f"film complete   {outcome.merged / 60:9.1f} min: {outcome.merged / ideal:.2f} times the ideal")
    print(f"preemptions     {outcome.preemptions:9}")
    print(f"lost            {outcome.lost / 3600:9.1f} node hours, {outcome.lost / 36 / options.node_hours:.2f} %")
    print(f"written         {outcome.written / 1e9:9.1f} GB")
    print(f"read            {outcome.read / 1e9:9.1f} GB")


if __name__ == "__main__":
    main()
