#!/usr/bin/env python3
"""Adds up what Catch2 programs run by ctest reported, and names every failure and every skipped test.

usage: summarize_tests.py LastTest.log...

A test case counts as skipped when it printed a line `SKIPPED: <reason>` (tests/support/skip.hpp): then it does not count
as passed. A program that ends without Catch2's own summary (it crashed, hung or was never built) is one failure.
Exits with 0 when nothing failed and something passed.
"""
import re
import sys

TEST = re.compile(r'^\d+/\d+ Testing: (?P<name>.*?)\n(?P<head>.*?)^Output:\n-+\n(?P<output>.*?)^<end of output>\n(?P<tail>.*?)'
                  r'^"(?P=name)" end time', re.M | re.S)
ALL_PASSED = re.compile(r'^All tests passed \(.* in (\d+) test cases?\)', re.M)
SOME_FAILED = re.compile(r'^test cases: +(\d+)(.*)$', re.M)
NOTHING_RAN = re.compile(r'^(No tests ran|No test cases matched)', re.M)
SKIPPED = re.compile(r'^SKIPPED: (.*)$', re.M)
# Catch2 writes the test's name between two rules, and under them where each assertion failed.
HEADING = re.compile(r'^-{79}\n(?P<name>\S.*?)\n-{79}\n', re.M | re.S)
FAILED = re.compile(r'^(?P<place>\S+:\d+): FAILED:', re.M)


def failed_assertions(output):
    """[(test case, place)] in the order of the output."""
    headings = [(m.start(), ' / '.join(line.strip() for line in m['name'].splitlines())) for m in HEADING.finditer(output)]
    found = []
    for failure in FAILED.finditer(output):
        above = [name for start, name in headings if start < failure.start()]
        found.append((above[-1] if above else '?', failure['place']))
    return found


def count(name, output, ended_well):
    """(passed, failed, skipped, [a line for each failure]) of one program's run."""
    skipped = len(SKIPPED.findall(output))
    if all_passed := ALL_PASSED.search(output):
        if ended_well:
            return int(all_passed[1]) - skipped, 0, skipped, []
        return int(all_passed[1]) - skipped, 1, skipped, [f'{name}: every test passed, but the program failed']
    if some_failed := SOME_FAILED.search(output):
        total = int(some_failed[1])
        counts = {what: int(number) for number, what in re.findall(r'(\d+) (failed as expected|\w+)', some_failed[2])}
        failed = counts.get('failed', 0)
        skipped += counts.get('skipped', 0)  # Catch2 3 has a SKIP of its own
        lines = [f'{name}: {test} ({place})' for test, place in failed_assertions(output)]
        if not failed and not ended_well:
            return total - skipped, 1, skipped, [f'{name}: every test passed, but the program failed']
        return total - failed - skipped, failed, skipped, lines if failed else []
    if ended_well and (skipped or NOTHING_RAN.search(output)):
        return 0, 0, skipped, []
    return 0, 1, skipped, [f'{name}: ended without a summary']


def main(paths):
    passed, failed, skipped, failures, reasons = 0, 0, 0, [], []
    for path in paths:
        with open(path, encoding='utf-8', errors='replace') as log:
            text = log.read()
        build = path.split('/')[-4] if path.count('/') >= 3 else path
        finished = set()
        for test in TEST.finditer(text):
            finished.add(test['name'])
            name = f'{build}/{test["name"]}'
            some = count(name, test['output'], 'Test Passed.' in test['tail'])
            passed, failed, skipped = passed + some[0], failed + some[1], skipped + some[2]
            failures += some[3]
            reasons += [f'{name}: {reason}' for reason in SKIPPED.findall(test['output'])]
        for name in sorted(set(re.findall(r'^\d+/\d+ Testing: (.*)$', text, re.M)) - finished):
            failed += 1
            failures.append(f'{build}/{name}: did not run to its end')
    print()
    for reason in reasons:
        print(f'skipped  {reason}')
    for failure in failures:
        print(f'FAILED   {failure}')
    print(f'{passed} passed, {failed} failed, {skipped} skipped')
    return 0 if passed and not failed else 1


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
