"""Branches of the pipeline that tests take: coverage.py LEFT_OUT.txt PERCENT TESTS.json [FAULTS.json]

Reads what llvm-cov exports, of the tests, and of runs in which calls fail one at a time. A file that is
compiled several times, for widths of lanes or into files that include it, counts once: a condition came out
true if it did so anywhere. LEFT_OUT.txt lists what no test can take, a line each: a file, a piece of the
source line, and after a # why.

Prints each file with conditions that came out one way only, worst first, what is left out by reason, and the
sums; the conditions themselves go to stderr, as file:line. Exit status 1 where fewer than PERCENT are taken
both ways, or where what is left out is not there any more.
"""

import collections
import json
import sys


def read_left_out(path):
    rules = []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            rule, _, reason = line.partition(" # ")
            if reason and not line.startswith("#"):
                file, piece = rule.split(None, 1)
                rules.append((file, piece.strip(), reason.strip()))
    return rules


def conditions(path):
    """{(file, line, column): [times true, times false]} of the pipeline's own sources."""
    taken = collections.defaultdict(lambda: [0, 0])
    with open(path, encoding="utf-8") as export:
        functions = json.load(export)["data"][0]["functions"]
    for function in functions:
        names = function["filenames"]
        for line, column, _, _, true, false, file_id, _, _ in function["branches"]:
            name = names[file_id]
            name = name[name.find("pipeline/"):] if "pipeline/" in name else ""
            if name:
                counts = taken[name, line, column]
                counts[0] += true
                counts[1] += false
    return taken


class Sources:
    """Lines of source files."""

    def __init__(self):
        self.lines = {}

    def line(self, name, number):
        if name not in self.lines:
            with open(name, encoding="utf-8") as text:
                self.lines[name] = text.read().split("\n")
        return self.lines[name][number - 1].strip()


def main():
    rules, wanted = read_left_out(sys.argv[1]), float(sys.argv[2])
    tests = conditions(sys.argv[3])
    faults = conditions(sys.argv[4]) if len(sys.argv) > 4 else {}
    all_of, missed_of, out = collections.Counter(), collections.Counter(), collections.Counter()
    sources, gone, by_faults = Sources(), set(rules), 0
    for place, counts in sorted(tests.items()):
        name, line, column = place
        text = sources.line(name, line)
        failing = faults.get(place, (0, 0))
        by_faults += sum(not tested and failed > 0 for tested, failed in zip(counts, failing))
        never = [tested + failed == 0 for tested, failed in zip(counts, failing)]
        fitting = [rule for rule in rules if rule[0] == name and rule[1] in text]
        gone -= set(fitting)
        all_of[name] += 2
        if fitting:
            all_of[name] -= sum(never)
            out[fitting[0][2]] += sum(never)
            continue
        missed_of[name] += sum(never)
        if any(never):
            ways = "ever" if all(never) else "true" if never[0] else "false"
            print(f"{name}:{line}:{column}: never {ways}: {text}", file=sys.stderr)
    for name, missed in sorted(missed_of.items(), key=lambda item: -item[1]):
        if missed:
            print(f"{name:<55}{all_of[name] - missed:6} of {all_of[name]}")
    for reason, branches in out.most_common():
        print(f"left out {branches:4}: {reason}")
    total, left_out = sum(all_of.values()), sum(out.values())
    taken = total - sum(missed_of.values())
    percent = 100 * taken / max(total, 1)
    print(f"{taken - by_faults} branches taken by tests, {by_faults} more where a call fails, of {total}: "
          f"{percent:.1f} % (at least {wanted:g} wanted)")
    print(f"{left_out} are left out: by tests alone {taken - by_faults} of {total + left_out}, "
          f"{100 * (taken - by_faults) / max(total + left_out, 1):.1f} %")
    for file, piece, _ in sorted(gone):
        print(f"left out, but not there: {file} {piece}")
    sys.exit(percent < wanted or bool(gone))


main()
