"""The program `lichtraum`, which is part of the package: `python -m lichtraum render hello.sdf`."""

import os
import sys
from typing import NoReturn


PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "lichtraum")


def main() -> NoReturn:
    os.execv(PROGRAM, ["lichtraum", *sys.argv[1:]])


if __name__ == "__main__":
    main()
