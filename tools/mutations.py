"""Small changes of source text, and a run that tries them one by one: what mutate_kernels and mutate_sources share.

A change is an operator, a comparison, a constant, or a statement that is dropped. The same seed gives the same changes. What
the log holds is not run again, so that a run can be stopped and resumed.
"""

import argparse
import pathlib
import random
import re

SWAPS = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " + ": " - ",
         " - ": " + ", " * ": " / ", " / ": " * ", " && ": " || ", " || ": " && ", "fmin(": "fmax(", "fmax(": "fmin(",
         "std::min(": "std::max(", "std::max(": "std::min("}
SWAP = re.compile("|".join(re.escape(text) for text in sorted(SWAPS, key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.'])(\d+\.\d*|\.\d+|\d+)(e[-+]?\d+)?([fu]?)(?![\w.'])")
STATEMENT = re.compile(r"^\s+(?!return|case|break|continue|default|typedef|using|const )[\w.>\[\]-]+(?: [-+*/|&^]?= |\().*;$")
COMMENT = re.compile(r"/\*.*?\*/|(?<!:)//[^\n]*", re.S)


def other_number(match):
    digits, exponent, suffix = match[1], match[2] or "", match[3]
    if "." not in digits and not exponent and suffix != "f":
        return f"{int(digits) + 1}{suffix}"
    return f"1.{suffix}" if float(digits) == 0 else f"{2 * float(digits)}{exponent}{suffix}"


def mutations_of(line):
    """Every changed form of a line of code."""
    changed = [line[:m.start()] + SWAPS[m[0]] + line[m.end():] for m in SWAP.finditer(line)]
    changed += [line[:m.start()] + other_number(m) + line[m.end():] for m in NUMBER.finditer(line)]
    if STATEMENT.match(line):
        changed.append(line[:len(line) - len(line.lstrip())] + ";")
    return changed


def mutations_in(root, names):
    """[(file, line number from 0, new line)] of these files of `root`, comments and the preprocessor's lines left out."""
    found = []
    for name in names:
        text = COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), (root / name).read_text())
        for number, line in enumerate(text.split("\n")):
            if not line.lstrip().startswith("#") and not line.endswith("\\"):
                found += [(name, number, changed.rstrip()) for changed in mutations_of(line.rstrip())]
    return found


def parse_options(doc, files, build):
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=30, help="changes that compile (30)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="*", help=f"files, as in '{files}'")
    parser.add_argument("--build", type=pathlib.Path, default=build, help=f"({build.name})")
    parser.add_argument("--log", type=pathlib.Path, default=pathlib.Path("mutations.log"), help="(mutations.log)")
    return parser.parse_args()


def run(root, names, verdict_on, options):
    """Tries `options.count` changes of the files `names` of `root`, and prints what became of each.

    verdict_on(name, text) says what the tests say of a file that has this text instead: 'does not compile', 'survived', or
    'caught: ' and by what.
    """
    mutations = mutations_in(root, [name for name in names if pathlib.PurePath(name).match(options.only)])
    random.Random(options.seed).shuffle(mutations)

    known = {}
    if options.log.exists():
        known = dict(line.split("\t", 1)[::-1] for line in options.log.read_text().splitlines())
    verdicts = []
    for name, number, line in mutations:
        if len(verdicts) == options.count:
            break
        lines = (root / name).read_text().split("\n")
        change = f"{name}:{number + 1}: {lines[number].strip()}  ->  {line.strip()}"
        if change not in known:
            lines[number] = line
            known[change] = verdict_on(name, "\n".join(lines))
            with options.log.open("a") as log:
                log.write(f"{known[change]}\t{change}\n")
        if known[change] == "does not compile":
            continue
        verdicts.append(known[change])
        print(f"{len(verdicts):4} {known[change]}\n     {change}", flush=True)
    caught = sum(verdict != "survived" for verdict in verdicts)
    print(f"{caught} of {len(verdicts)} caught ({100 * caught / max(len(verdicts), 1):.0f} %)")


def failed_test(output):
    """The name of the last test case of which Catch2 reports a failure, or None. Long names are printed in several lines."""
    names = re.findall(r"^-{79}\n(\S.*?)\n-{79}\n", output, re.M | re.S)
    return " ".join(names[-1].split()) if names else None
