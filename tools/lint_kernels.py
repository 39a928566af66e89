#!/usr/bin/env python3
"""Names each call in kernels/ of a function that may give other bytes elsewhere, as file:line: why and what to use.

A call is fine when kernels/ defines the function, or when EXACT lists it: IEEE 754 and OpenCL leave those no choice.
Everything else differs between processors, compilers and libraries, if only in the last bit, and so do pictures. Also
named: a file that does not reach the pragma against contraction, as a * b + c may then be rounded once or twice.
"""

import pathlib
import re
import sys

# Exact, or no arithmetic at all. Patterns of whole names.
EXACT = [
    "fma|sqrt|floor|fabs|copysign|min|max|clamp|select|isnan|popcount|upsample",
    "as_[a-z]+[0-9]*|convert_[a-z]+[0-9]*|vload[0-9]+|vstore[0-9]+|get_(global|local|group)_(id|size)|barrier",
    "if|for|while|switch|return|sizeof|defined|__has_warning|__attribute__|aligned|alignas|static_assert",
    "INTEGRATE",  # a function of kernels/integrators
]

# What to write instead, by patterns of whole names; the first that fits.
INSTEAD = [
    ("(fast_)?length|(fast_)?distance|hypot", "sqrt(dot_product(v, v)) (math/vector.clh)"),
    ("(fast_)?normalize", "unit_vector (math/vector.clh)"),
    ("dot", "dot_product (math/vector.clh)"),
    ("cross", "cross_product (math/vector.clh)"),
    ("mad", "fma, or a * b + c"),
    ("mix", "fma(t, b - a, a)"),
    ("fmin|fmax", "min_of, max_of (math/vector.clh)"),
    ("(native_|half_)?(pow|powr|pown|rootn)|cbrt", "pow_of (shared/math.h)"),
    ("(native_|half_)?exp(2|10|m1)?", "exp_of (shared/math.h)"),
    ("(native_|half_)?log(2|10|1p|b)?", "log_of (shared/math.h)"),
    ("(native_|half_)?(sin|cos|tan|sincos)(pi)?", "sin_and_cos_of (shared/math.h)"),
    ("atan2?(pi)?", "atan2_of (shared/math.h)"),
    ("a(sin|cos)(pi)?", "acos_of (shared/math.h)"),
    ("(native_|half_)?rsqrt", "1 / sqrt(x)"),
    ("(native_|half_)sqrt", "sqrt"),
    ("(native_|half_)(recip|divide)", "a / b"),
    ("fmod|remainder|fract|modf", "x - y * floor(x / y)"),
    ("ceil|round|rint|trunc", "floor"),
]
PRAGMA = "#pragma OPENCL FP_CONTRACT OFF"


def without_comments(text):
    """The same lines, without comments and what stands between quotes."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group())
    return re.sub(r'/\*.*?\*/|//[^\n]*|"[^"\n]*"', blank, text, flags=re.DOTALL)


def functions_of(texts):
    """What kernels define: functions (a type stands before the name, at the start of a line), macros, and parameters of
    macros, which may be macros."""
    names = set()
    for text in texts:
        for name, parameters in re.findall(r"^\s*#\s*define\s+(\w+)\(([^)]*)\)", text, re.MULTILINE):
            names.update([name, *re.findall(r"\w+", parameters)])
        names.update(re.findall(r"^(?:\w[\w \*]*[ \*])(\w+)\(", text, re.MULTILINE))
    return names


def calls_in(text):
    """(line, name) of what looks like a call."""
    for number, line in enumerate(text.split("\n"), start=1):
        line = re.sub(r"^\s*#\s*define\s+\w+", "", line)  # which parentheses may follow
        for match in re.finditer(r"(?<![\w.])([A-Za-z_]\w*)\s*\(", line):
            yield number, match.group(1)


def is_one_of(patterns, name):
    return any(re.fullmatch(pattern, name) for pattern in patterns)


def reaches_pragma(path, sources, kernels, seen):
    """Whether a file or one that it includes, directly or not, has the pragma."""
    if path in seen or path not in sources:
        return False
    seen.add(path)
    if PRAGMA in sources[path]:
        return True
    included = re.findall(r'^#include "([^"]+)"', sources[path], re.MULTILINE)
    return any(reaches_pragma(kernels / name, sources, kernels, seen) for name in included)


def main():
    kernels = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "kernels")
    paths = sorted(path for path in kernels.rglob("*") if path.suffix in (".cl", ".clh", ".h"))
    sources = {path: path.read_text() for path in paths}
    texts = {path: without_comments(source) for path, source in sources.items()}
    own = functions_of(texts.values())
    for path in paths:
        for number, name in calls_in(texts[path]):
            if name in own or is_one_of(EXACT, name):
                continue
            instead = next((text for pattern, text in INSTEAD if re.fullmatch(pattern, name)),
                           "an exact operation, or a function of our own in shared/math.h")
            print(f"{path}:{number}: {name} is rounded differently by other processors and libraries: "
                  f"use {instead}")
        if "{" in texts[path] and functions_of([texts[path]]) and not reaches_pragma(path, sources, kernels, set()):
            print(f"{path}:1: compilers may contract a * b + c here: include shared/types.h, which forbids it")


if __name__ == "__main__":
    main()
