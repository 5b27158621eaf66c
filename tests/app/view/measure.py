"""Measures how soon the window shows a picture, and how soon it answers the mouse, on a display without a screen.

    CANDELA_PROGRAM=build/release/candela python3 tests/app/view/measure.py [--runs 5] [--size 640x360] [SCENE]

Each run starts the viewer, drags the mouse across the picture for some seconds, and closes it. The driver is that of
VK_DRIVER_FILES. Printed are the seconds from the start to the first picture, and the milliseconds from a movement of the mouse
to the frame that shows the new view.
"""
import argparse
import pathlib
import tempfile

import support

DRAGS = 12


def measure(display, folder, scene, size):
    viewer = support.Viewer(display, folder, scene, "--size", size)
    viewer.wait_for_samples(1)
    x, y = (int(side) // 2 for side in size.split("x"))
    for drag in range(DRAGS):
        step = 80 if drag % 2 else -80
        viewer.drag((support.LEFT + x, y), (support.LEFT + x + step, y + step // 4), steps=20)
    return viewer.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", nargs="?", default=support.SOURCE / "scenes/cornell.p3f", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--size", default="640x360")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="candela-view-") as folder:
        display = support.Display(folder)
        try:
            for run in range(1, options.runs + 1):
                report = measure(display, folder, options.scene.resolve(), options.size)
                times = report["responses"]
                print(f"run {run}: first picture {report['firstPictureSeconds']:.2f} s; {times['count']} answers, median "
                      f"{1000 * times['medianSeconds']:.0f} ms, 90th percentile {1000 * times['p90Seconds']:.0f} ms", flush=True)
        finally:
            display.close()


if __name__ == "__main__":
    main()
