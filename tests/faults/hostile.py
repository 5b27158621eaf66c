#!/usr/bin/env python3
"""Bombs (files whose counts and sizes go far beyond their length) and attacks on paths.

    hostile.py --program candela

A bomb must be refused with exit code 2 or 6 (the comment of text.png may be skipped instead), a message, at most one second of processor time and 200 MB of memory. An
attack on paths must be refused, or be harmless: it ends within the time limit, reads nothing outside the scene's folder,
and changes no file but the output that was named."""
import argparse
import base64
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import zlib

SCENE = """v
from 0 -4 1
at 0 0 0
up 0 0 1
angle 40
hither 1
resolution 8 6
f 0.8 0.6 0.4 1 0 0 0 0 1 1 1
s 0 0 0 0.5
f 1 1 1 1 0 0 0 0 1 1 1 4 4 4
s 1 -1 2 0.4
"""
SECRET = b"this content must not be read"
MAX_SECONDS, MAX_BYTES, TIMEOUT = 1.0, 200e6, 60


def run(program, folder, words, stdin=subprocess.DEVNULL):
    """Exit code (None: blocked), stderr, processor seconds and peak memory in bytes."""
    log = pathlib.Path(tempfile.mkstemp()[1])
    with open(log, "wb") as err:
        process = subprocess.Popen([program, *words], cwd=folder, stdin=stdin, stdout=subprocess.DEVNULL, stderr=err,
                                   env=dict(os.environ, ASAN_OPTIONS="detect_leaks=0"))
        end = time.monotonic() + TIMEOUT
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                process.kill()
                os.wait4(process.pid, 0)
                log.unlink()
                return None, "", 0, 0
            time.sleep(0.01)
    process.returncode = os.waitstatus_to_exitcode(status)
    text = log.read_text(errors="replace")
    log.unlink()
    return process.returncode, text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, bits=8, colour=2, data=b"\0" * 64, extra=b""):
    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


def exr(width, height, compression, extra=b""):
    def attribute(name, kind, data, size=None):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(data) if size is None else size) + data
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(c + b"\0" + struct.pack("<iBBBBii", 2, 0, 0, 0, 0, 1, 1) for c in (b"B", b"G", b"R")) + b"\0"
    return (struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels) +
            attribute(b"compression", b"compression", bytes([compression])) + attribute(b"dataWindow", b"box2i", box) +
            attribute(b"displayWindow", b"box2i", box) + attribute(b"lineOrder", b"lineOrder", b"\0") +
            attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) +
            attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)) +
            attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + extra + b"\0" + b"\0" * 64)


def gltf(**more):
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
                "bufferViews": [{"buffer": 0, "byteLength": 36}],
                "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," +
                             base64.b64encode(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)).decode()}]}
    return json.dumps(document | more).encode()


def glb(json_length, total):
    return struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", json_length, b"JSON") + b"{}  "


def zeros(megabytes):
    """This number of million zeros, compressed in pieces, since a child's peak memory begins with that of its parent."""
    packer = zlib.compressobj(9)
    return b"".join(packer.compress(bytes(10**6)) for _ in range(megabytes)) + packer.flush()


def bombs():
    """Name of the file, its bytes, and the command before it."""
    big = 10**9
    view = {"bufferView": 0, "componentType": 5126, "type": "VEC3"}
    check, compare = ["check"], ["compare"]
    yield "sides.png", png(65535, 65535), compare
    yield "pixels.png", png(16384, 16384), compare
    yield "deep.png", png(16384, 16384, 16, 6), compare
    yield "text.png", png(4, 4, extra=chunk(b"zTXt", b"a\0\0" + zeros(400))), compare
    yield "sides.jpg", b"\xff\xd8\xff\xc0\0\x11\x08" + struct.pack(">HH", 65500, 4000) + b"\x03\1\x22\0\2\x11\1\3\x11\1" + b"\xff\xda\0\x0c\3\1\0\2\x11\3\x11\0\x3f\0" + b"\0" * 64, compare
    yield "sides.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n" + b"\2\2\x40\0" * 16, compare
    yield "sides.pfm", b"PF\n16384 16384\n-1.0\n" + b"\0" * 64, compare
    for name, compression in (("none", 0), ("zip", 3), ("piz", 4), ("dwaa", 8)):
        yield f"{name}.exr", exr(16384, 16384, compression), compare
    yield "attribute.exr", exr(4, 4, 3, b"a\0string\0" + struct.pack("<I", 0x7FFFFFF0)), compare
    yield "long.exr", exr(2**31 - 1, 4, 3), compare
    yield "film.exr", exr(16384, 16384, 3), ["film"]
    yield "zeros.gltf", gltf(accessors=[{"componentType": 5126, "count": big, "type": "VEC3"}]), check
    yield "count.gltf", gltf(accessors=[view | {"count": big}]), check
    yield "sparse.gltf", gltf(accessors=[{"componentType": 5126, "count": big, "type": "VEC3", "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5125}, "values": {"bufferView": 0}}}]), check
    yield "buffer.gltf", gltf(buffers=[{"byteLength": 10**18, "uri": "data:application/octet-stream;base64,AAAA"}]), check
    yield "instances.gltf", gltf(accessors=[view | {"count": 3}, {"componentType": 5126, "count": 10**8, "type": "VEC3"}], nodes=[{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}]), check
    yield "meshopt.gltf", gltf(bufferViews=[{"buffer": 0, "byteLength": 256 * big, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteLength": 36, "byteStride": 256, "count": big, "mode": "ATTRIBUTES"}}}]), check
    yield "nesting.gltf", b'{"asset":' + b"[" * 10**6, check
    yield "chunk.glb", glb(0xFFFFFFF0, 0xFFFFFFFF), check
    yield "total.glb", glb(4, 0xFFFFFFFF), check
    for encoding in ("ascii", "binary_little_endian"):
        vertices = b"element vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
        face = b"element face %d\nproperty list int int vertex_indices\nend_header\n"
        magic = f"ply\nformat {encoding} 1.0\n".encode()
        yield f"vertices.{encoding}.ply", magic + vertices.replace(b"3", b"%d" % big) + face % 1 + b"0 " * 50, check
        yield f"faces.{encoding}.ply", magic + vertices + face % big + b"0 " * 50, check
        yield f"list.{encoding}.ply", magic + vertices + face % 1 + (b"0 " * 9 + b"2000000000 0 1 2" if encoding == "ascii" else b"\0" * 9 + b"\xff\xff\xff\x7f"), check
    yield "face.obj", b"v 0 0 0\n" + b"f" + b" 1" * 400000 + b"\n", check
    yield "corners.obj", b"v 0 0 0\n" + b"vt 0 0\n" * 60000 + b"".join(b"f 1/%d 1/%d 1/%d\n" % (i, i + 1, i + 2) for i in range(1, 59999)) + b"f 1\n", check
    yield "groups.obj", b"v 0 0 0\n" + b"".join(b"s %d\nf 1 1 1\n" % i for i in range(1, 60000)) + b"f 1\n", check
    scene = b'<scene version="3.0.0">%s</scene>'
    yield "nesting.xml", scene % (b'<bsdf type="mask">' * 10**5), check
    yield "tags.xml", scene % (b"<a/>" * 3 * 10**6), check
    yield "attributes.xml", scene % (b"<a" + b' b=""' * 10**5 + b"/>"), check
    yield "doubling.xml", scene % (b'<default name="a0" value="0123456789"/>' + b"".join(b'<default name="a%d" value="$a%d $a%d"/>' % (i, i - 1, i - 1) for i in range(1, 60))), check
    yield "entities.xml", b'<!DOCTYPE scene [<!ENTITY a "0">' + b"".join(b'<!ENTITY a%d "&a%d;&a%d;">' % (i + 1, i, i) for i in range(60)) + b"]>" + scene % b"&a60;", check
    yield "wrong.xml", scene % (b"<wrong/>\n" * 10**5), check
    yield "polygon.nff", (SCENE + "p 4000000000\n0 0 0\n1 0 0\n0 1 0\n").encode(), check
    yield "image.p3f", SCENE.replace("8 6", "65535 65535").encode(), ["render", "--device", "cpu", "--stats"]
    yield "memory.p3f", SCENE.replace("8 6", "16384 16384").encode(), ["render", "--device", "cpu", "--stats", "--memory", "200MiB"]
    yield "nesting.json", b"[" * 10**6, ["bench", "compare", "{file}"]


def try_bomb(program, folder, name, content, command):
    file = folder / name
    file.write_bytes(content)
    words = [w.format(file=file) for w in command] + [str(file)] * (2 if command == ["compare"] else 1)
    code, err, seconds, size = run(program, folder, words)
    file.unlink()
    problem = None
    if (code not in (2, 6) or "candela: " not in err) and not (name == "text.png" and code == 0):
        problem = f"exit code {code}: {err[-500:]}"
    elif seconds > MAX_SECONDS or size > MAX_BYTES:
        problem = f"{seconds:.2f} s, {size / 1e6:.0f} MB"
    return problem, seconds, size


def attacks(folder):
    """Name, command, whether it must fail, and what its message must not contain."""
    inside, outside = folder / "inside", folder / "outside"
    inside.mkdir()
    outside.mkdir()
    secret = outside / "secret.bin"
    secret.write_bytes(SECRET)
    (inside / "scene.p3f").write_text(SCENE)
    (inside / "link.bin").symlink_to(secret)
    (inside / "up").symlink_to(outside)
    (inside / "zero").symlink_to("/dev/zero")
    os.mkfifo(inside / "pipe")
    (inside / "pipe.exr").symlink_to("pipe")
    (inside / "dangling.png").symlink_to(outside / "new.png")
    uris = {"parent": "../outside/secret.bin", "absolute": str(secret), "escaped": "%2e%2e/outside/secret.bin",
            "url": "file://" + str(secret), "link": "link.bin", "linked folder": "up/secret.bin", "pipe": "pipe",
            "device": "zero", "device by path": "/dev/zero", "folder": ".", "nul": "a%00b", "newline": "a%0ab",
            "control": "a%1b[2Jb", "long": "a" * 100_000, "backslash": "..\\outside\\secret.bin",
            "http": "http://127.0.0.1:1/secret.bin", "share": "//localhost/secret.bin", "proc": "/proc/self/environ"}
    for name, uri in uris.items():
        file = inside / f"{name.replace(' ', '-')}.gltf"
        file.write_bytes(gltf(buffers=[{"byteLength": 36, "uri": uri}]))
        yield f"glTF buffer: {name}", ["check", str(file)], True
    for name, path in {"parent": "../outside/secret.bin", "pipe": "pipe", "device": "zero", "link": "link.bin"}.items():
        file = inside / f"sky-{name}.p3f"
        file.write_text(SCENE + "".join(f"env {path}\n" for _ in range(1)))
        yield f"sky box: {name}", ["check", str(file)], name not in ("pipe", "device", "link")
    scene, film = str(inside / "scene.p3f"), str(inside / "film.exr")
    yield "scene is a pipe", ["check", str(inside / "pipe")], True
    yield "scene is a device", ["check", "/dev/zero"], True
    yield "scene is a folder", ["check", str(inside)], True
    yield "scene with control characters", ["check", str(inside / "a\x1b[2J\nb.p3f")], True
    yield "image is a pipe", ["compare", str(inside / "pipe"), str(inside / "pipe")], True
    yield "image is a device", ["compare", "/dev/zero", "/dev/zero"], True
    yield "film is a pipe", ["film", str(inside / "pipe.exr")], True
    yield "film is a device", ["film", "/dev/zero"], True
    yield "shard is a pipe", ["merge", str(inside / "pipe"), "-o", film], True
    yield "report is a device", ["bench", "compare", "/dev/zero", "/dev/zero"], True
    yield "resume from a pipe", [scene, "--device", "cpu", "--resume", str(inside / "pipe")], True
    render = [scene, "--device", "cpu", "--spp", "1"]
    yield "output is a pipe without a reader", render + ["-o", str(inside / "pipe.exr")], True
    yield "output into /proc", render + ["-o", "/proc/self/a.png"], True
    yield "output in /proc that exists", render + ["--json", "/proc/self/comm"], False
    yield "report over the scene", render + ["--json", scene], True
    yield "output is full", render + ["--json", "/dev/full"], True
    yield "output is a folder", render + ["-o", str(inside / "up") + "/.png/../"], True
    yield "checkpoint over the scene", render + ["--checkpoint", scene], True
    yield "output with control characters", render + ["-o", str(inside / "a\x1b[2J\nb.png")], False
    yield "output through a link", render + ["-o", str(inside / "dangling.png")], False


def content_of(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file() and not p.is_symlink()}


def try_attack(program, folder, name, words, must_fail):
    before = content_of(folder)
    code, err, seconds, size = run(program, folder, words)
    after = content_of(folder)
    changed = [k for k in before if after.get(k) != before[k]]
    if code is None:
        return "it blocks"
    if code < 0 or code == 70:
        return f"exit code {code}: {err[-500:]}"
    if must_fail and (code not in (1, 2) or "candela: " not in err):
        return f"it is not refused, exit code {code}: {err[-500:]}"
    if SECRET.decode() in err or changed:
        return f"changed {changed}, says {err[-300:]}"
    if any(ord(c) < 32 and c not in "\n\t" for c in err):
        return "control characters in the message"
    return None


def race(program, folder):
    """Two processes write the same picture repeatedly: it is always one of the two."""
    (folder / "scene.p3f").write_text(SCENE)
    picture = folder / "race.png"
    def command(seed):
        return [program, "scene.p3f", "--device", "cpu", "--spp", "1", "--seed", str(seed), "-q", "-o", str(picture)]
    wanted = []
    for seed in (1, 2):
        subprocess.run(command(seed), cwd=folder, check=True)
        wanted.append(picture.read_bytes())
    for _ in range(10):
        both = [subprocess.Popen(command(seed), cwd=folder) for seed in (1, 2)]
        while any(p.poll() is None for p in both):
            if picture.read_bytes() not in wanted:
                return "a mixture"
        if [p.returncode for p in both] != [0, 0] or picture.read_bytes() not in wanted:
            return "a run failed"
    left = [p.name for p in folder.iterdir() if p.name not in ("scene.p3f", "race.png")]
    return f"left {left}" if left else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--any-cost", action="store_true", help="do not limit time and memory, as for sanitizers")
    options = parser.parse_args()
    if options.any_cost:
        global MAX_SECONDS, MAX_BYTES
        MAX_SECONDS, MAX_BYTES = 1e9, 1e18
    options.program = os.path.abspath(options.program)
    counts, problems, slowest, largest = {"bombs": 0, "attacks": 0}, 0, 0, 0
    with tempfile.TemporaryDirectory(prefix="candela-hostile-") as name:
        folder = pathlib.Path(name)
        for file, content, command in bombs():
            problem, seconds, size = try_bomb(options.program, folder, file, content, command)
            slowest, largest = max(slowest, seconds), max(largest, size)
            counts["bombs"] += 1
            if problem:
                problems += 1
                print(f"{file}: {problem}", flush=True)
        for attack, words, must_fail in attacks(folder):
            problem = try_attack(options.program, folder, attack, words, must_fail)
            counts["attacks"] += 1
            if problem:
                problems += 1
                print(f"{attack}: {problem}", flush=True)
    with tempfile.TemporaryDirectory(prefix="candela-hostile-") as name:
        problem = race(options.program, pathlib.Path(name))
        if problem:
            problems += 1
            print(f"two processes: {problem}")
    print(f"{counts['bombs']} bombs (at most {slowest:.2f} s and {largest / 1e6:.0f} MB), {counts['attacks']} attacks on "
          f"paths, {problems} problems")
    sys.exit(1 if problems or counts["bombs"] < 20 or counts["attacks"] < 30 else 0)


if __name__ == "__main__":
    main()
