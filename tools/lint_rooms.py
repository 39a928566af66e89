#!/usr/bin/env python3
"""Names each #include of a room that its row of docs/ARCHITECTURE.md does not allow, as file:line: what.

The table under "Modules" is the rule: a row's first column names folders (or files), its third the rooms that they may
include from, besides themselves: by the last part of their path, "anything", or nothing. Also named: a circle in what
the table allows, a room that is none, and a folder of src/ or kernels/ without a row.
"""

import pathlib
import re

DOCUMENT = "docs/ARCHITECTURE.md"
INCLUDE_ROOTS = ["include", "src", "kernels"]
ANYTHING = "anything"


def read_table():
    """[(line number, [paths], [names of rooms])]"""
    rows = []
    lines = pathlib.Path(DOCUMENT).read_text().split("\n")
    for number, line in enumerate(lines[lines.index("## Modules"):], start=lines.index("## Modules") + 1):
        if line.startswith("## ") and rows:
            break
        if line.startswith("| `"):
            folders, _, may_use = [cell.strip() for cell in line.strip("|").split(" | ", 2)]
            names = [name.strip(" `") for name in may_use.rstrip("| ").split(",") if name.strip(" `")]
            rows.append((number, [path.rstrip("/") for path in re.findall(r"`([^`]+)`", folders)], names))
    return rows


def row_of(path, rows):
    """The index of the row with the longest path that `path` is or is in; None without one."""
    fitting = [(len(room), i) for i, (_, rooms, _) in enumerate(rows) for room in rooms
               if path == room or path.startswith(room + "/")]
    return max(fitting)[1] if fitting else None


def row_named(name, user, rows):
    """The index of the row with a room of that name; of two, the one beside the user's rooms. None without one."""
    top = pathlib.PurePath(user[1][0]).parts[0]
    fitting = [(pathlib.PurePath(room).parts[0] != top, i) for i, (_, rooms, _) in enumerate(rows) for room in rooms
               if pathlib.PurePath(room).name == name]
    return min(fitting)[1] if fitting else None


def resolve(include):
    return next((f"{root}/{include}" for root in INCLUDE_ROOTS if pathlib.Path(root, include).exists()), None)


def circle(allowed):
    """A list of rows that may use one another in turn, or []."""
    done = set()

    def visit(row, way):
        if row in way:
            return way[way.index(row):] + [row]
        if row in done:
            return []
        for other in allowed[row]:
            if found := visit(other, way + [row]):
                return found
        done.add(row)
        return []

    return next((found for row in allowed if (found := visit(row, []))), [])


def main():
    rows = read_table()
    allowed = {}
    for i, (number, _, names) in enumerate(rows):
        known = {name: row_named(name, rows[i], rows) for name in names if name != ANYTHING}
        for name in [name for name, row in known.items() if row is None]:
            print(f"{DOCUMENT}:{number}: no row is about '{name}'")
        allowed[i] = [row for row in known.values() if row is not None]
    if found := circle(allowed):
        print(f"{DOCUMENT}:{rows[found[0]][0]}: rooms may use one another in a circle: "
              + " -> ".join(rows[i][1][0] for i in found))
    folders = [path for root in ("src", "kernels") for path in sorted(pathlib.Path(root).iterdir()) if path.is_dir()]
    for folder in folders:
        if row_of(str(folder), rows) is None:
            print(f"{DOCUMENT}: no row is about {folder}")
    for root in INCLUDE_ROOTS:
        for path in sorted(pathlib.Path(root).rglob("*")):
            if path.suffix not in (".cpp", ".hpp", ".h", ".clh", ".cl"):
                continue
            own = row_of(str(path), rows)
            if own is None:
                print(f"{path}: no row of {DOCUMENT} is about it")
                continue
            for number, line in enumerate(path.read_text().split("\n"), start=1):
                included = re.match(r'#include "([^"]+)"', line)
                target = resolve(included.group(1)) if included else None
                other = row_of(target, rows) if target else None
                if other not in (None, own, *allowed[own]) and ANYTHING not in rows[own][2]:
                    print(f"{path}:{number}: {rows[own][1][0]} may not use {target}")


if __name__ == "__main__":
    main()
