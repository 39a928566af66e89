"""The program `lichtraum`, which is part of the package: `python -m lichtraum render hello.sdf`."""

import os
import sys
from typing import NoReturn


def main() -> NoReturn:
    program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "lichtraum")
    os.execv(program, ["lichtraum", *sys.argv[1:]])


if __name__ == "__main__":
    main()
