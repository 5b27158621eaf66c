#!/usr/bin/env python3
"""Prints the expected values of test_sampler.cpp, calculated from docs/light-transport.md section 1 in Python's integers."""

M = 0xFFFFFFFF


def pcg4d(v):
    x, y, z, w = [(c * 1664525 + 1013904223) & M for c in v]
    for turn in range(2):
        x = (x + y * w) & M
        y = (y + z * x) & M
        z = (z + x * y) & M
        w = (w + y * z) & M
        if turn == 0:
            x, y, z, w = [c ^ (c >> 16) for c in (x, y, z, w)]
    return [x, y, z, w]


def reverse(x):
    return int(format(x, "032b")[::-1], 2)


def owen(x, k):
    x = (x + k) & M
    for c in (0x6C50B47C, 0xB82F1E52, 0xC7AFE638, 0x8D22F6E6):
        x ^= (x * c) & M
    return x


def directions(slot):
    if slot == 0:
        return [1 << (31 - b) for b in range(32)]
    s, a, m = [(1, 0, [1]), (2, 1, [1, 3]), (3, 1, [1, 3, 1])][slot - 1]
    m = list(m)
    for i in range(s, 32):  # Joe and Kuo's own form, on the odd integers m
        value = m[i - s] ^ (m[i - s] << s)
        for k in range(1, s):
            if (a >> (s - 1 - k)) & 1:
                value ^= m[i - k] << k
        m.append(value)
    return [m[b] << (31 - b) for b in range(32)]


DIRECTIONS = [directions(slot) for slot in range(4)]


def sobol(i, slot):
    point = 0
    for b in range(32):
        if (i >> b) & 1:
            point ^= DIRECTIONS[slot][b]
    return point


def independent(seed, pixel, sample, group):
    return pcg4d([pixel, sample, group, seed])


def scrambled(seed, pixel, sample, group):
    s = pcg4d([pixel, 0, group, seed ^ 0x5F356495])
    i = reverse(owen(reverse(sample), s[0] ^ s[1] ^ s[2] ^ s[3]))
    return [reverse(owen(reverse(sobol(i, slot)), s[slot])) for slot in range(4)]


def permute(i, l, p):
    w = l - 1
    for shift in (1, 2, 4, 8, 16):
        w |= w >> shift
    for _ in range(32):
        i ^= p
        i = i * 0xE170893D & M
        i ^= p >> 16
        i ^= (i & w) >> 4
        i ^= p >> 8
        i = i * 0x0929EB3F & M
        i ^= p >> 23
        i ^= (i & w) >> 1
        i = i * (1 | p >> 27) & M
        i = i * 0x6935FA69 & M
        i ^= (i & w) >> 11
        i = i * 0x74DCB303 & M
        i ^= (i & w) >> 2
        i = i * 0x9E501CC3 & M
        i ^= (i & w) >> 2
        i = i * 0xC860A3DF & M
        i &= w
        i ^= i >> 5
        if i < l:
            break
    return (i % l + p & M) % l


def stratum(c, count, jitter):
    q, r = divmod(1 << 32, count)
    start = lambda k: k * q + k * r // count
    return (start(c) + (jitter * (start(c + 1) - start(c)) >> 32)) & M


def stratified(seed, pixel, sample, group, n, pairs):
    """`pairs`: (first slot, second slot) of each pair in the group."""
    jitter = pcg4d([pixel, sample, group, seed])
    keys = pcg4d([pixel, 1, group, seed ^ 0x5F356495])
    words = [stratum(permute(sample, n * n, keys[s]), n * n, jitter[s]) for s in range(4)]
    for first, second in pairs:
        cell = permute(sample, n * n, keys[first])
        words[first] = stratum(cell % n, n, jitter[first])
        words[second] = stratum(cell // n, n, jitter[second])
    return words


def show(title, words):
    print(f"{title}: {{" + ", ".join(f"0x{w:08x}u" for w in words) + "}")


show("pcg4d 0 0 0 0", pcg4d([0, 0, 0, 0]))
show("pcg4d 1 2 3 4", pcg4d([1, 2, 3, 4]))
show("independent seed 7 pixel (3, 2) sample 5 group 1", independent(7, 3 + 65536 * 2, 5, 1))
show("sobol seed 7 pixel (3, 2) sample 5 group 1", scrambled(7, 3 + 65536 * 2, 5, 1))
show("sobol seed 4294967295 pixel (65534, 65534) sample 70000 group 9999", scrambled(M, 65534 + 65536 * 65534, 70000, 9999))
show("stratified n 3 seed 7 pixel (3, 2) sample 5 group 0", stratified(7, 3 + 65536 * 2, 5, 0, 3, [(0, 1), (2, 3)]))
show("stratified n 3 seed 7 pixel (3, 2) sample 5 group 2", stratified(7, 3 + 65536 * 2, 5, 2, 3, [(1, 2)]))
show("stratified n 3 seed 7 pixel (3, 2) sample 5 group 3", stratified(7, 3 + 65536 * 2, 5, 3, 3, [(0, 1)]))
show("permute 0..9 of 10, key 12345", [permute(i, 10, 12345) for i in range(10)])
