#!/usr/bin/env python3
"""tools/make_animation.py [FRAMES] > wave.sdf: an animation for lichtraum, written by a program.

A scene language has no loops, so a program writes the scene: 49 spheres on which a wave runs outwards. In eSDF a `render`
draws everything as it is defined up to its line, so a frame is: move what moves, render. Transforms add to what was
before; the program therefore writes by how much a sphere rises or falls from one frame to the next.

    python3 tools/make_animation.py 40 > wave.sdf
    lichtraum render wave.sdf -o wave.mp4

tools/make_animation.cpp does the same in C++ and writes the same text.
"""

import math
import sys

SIDE = 7  # spheres along x and along z
SPACING = 1.1


def height(x, z, phase):
    """Where the centre of the sphere at (x, z) is; the phase goes from 0 to 1 and then starts again."""
    distance = math.hypot(x, z)
    return 0.9 + 0.4 * math.sin(2 * math.pi * (distance / 4 - phase))


def places():
    for row in range(SIDE):
        for column in range(SIDE):
            yield SPACING * (column - SIDE // 2), SPACING * (row - SIDE // 2)


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    print("define material floor 0.25 0.25 0.3  0.45 0.45 0.5  0.2 0.2 0.2  20  reflect=0.25")
    for i in range(SIDE):
        share = i / (SIDE - 1)
        red, green, blue = 0.85 - 0.7 * share, 0.3 + 0.2 * share, 0.15 + 0.75 * share
        print(f"define material m{i} {red:.3f} {green:.3f} {blue:.3f}  {red:.3f} {green:.3f} {blue:.3f}  0.6 0.6 0.6  60")
    print("define shape box ground -200 -0.2 -200  200 0 200  floor")
    for i, (x, z) in enumerate(places()):
        print(f"define shape sphere s{i} {x:.4f} {height(x, z, 0):.4f} {z:.4f} 0.5 m{i % SIDE}")
    print("define light ambient sky 0.35 0.35 0.4")
    print("define light diffuse sun -8 14 9  0.75 0.7 0.6")
    print("define light diffuse lamp 10 6 4  0.15 0.2 0.3")
    print("define background 0.55 0.65 0.8")
    print("define camera eye 42 640 360")
    print("transform eye rotate -30 1 0 0")
    print("transform eye translate 0 8.4 13.6")
    print("transform eye rotate 30 0 1 0")
    for frame in range(frames):
        if frame > 0:
            before, now = (frame - 1) / frames, frame / frames
            for i, (x, z) in enumerate(places()):
                print(f"transform s{i} translate 0 {height(x, z, now) - height(x, z, before):.4f} 0")
        print(f"render eye wave_{frame:04d}.png")


main()
