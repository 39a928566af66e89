#!/usr/bin/env python3
"""report_coverage.py LINES.json: what gcovr counted, in all, by folder, and which lines of poorly tested files do not run."""

import collections
import json
import os
import sys

POOR = 0.8


def ranges(numbers):
    """1, 2, 3, 7 as '1-3 7'."""
    runs = []
    for number in sorted(numbers):
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return " ".join(str(first) if first == last else f"{first}-{last}" for first, last in runs)


def main():
    counts = collections.defaultdict(dict)  # of each file, for each line, how often it ran
    with open(sys.argv[1], encoding="utf-8") as file:
        for entry in json.load(file)["files"]:
            for line in entry["lines"]:
                if not line.get("gcovr/noncode"):
                    times = counts[entry["file"]]
                    times[line["line_number"]] = times.get(line["line_number"], 0) + line["count"]
    folders = collections.defaultdict(lambda: [0, 0])
    poor = []
    for path, times in sorted(counts.items()):
        missed = [number for number, count in times.items() if count == 0]
        folder = folders[os.path.dirname(path)]
        folder[0] += len(times) - len(missed)
        folder[1] += len(times)
        if len(missed) > (1 - POOR) * len(times):
            poor.append((path, missed, len(times)))
    for folder, (run, lines) in sorted(folders.items()):
        print(f"{folder:<28}{100 * run / lines:6.1f} % of {lines:6}")
    run, lines = (sum(values) for values in zip(*folders.values()))
    print(f"{'all':<28}{100 * run / lines:6.1f} % of {lines:6}")
    if poor:
        print(f"\nFiles of which less than {100 * POOR:.0f} % run, and the lines that do not:")
    for path, missed, lines in poor:
        print(f"  {path} ({100 * (lines - len(missed)) / lines:.0f} %): {ranges(missed)}")


if __name__ == "__main__":
    main()
