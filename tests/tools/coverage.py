"""Branches of the pipeline that tests take: coverage.py LEFT_OUT.txt PERCENT <export.json

Reads what llvm-cov exports. A file that is compiled several times, for widths of lanes or into files that
include it, counts once: a condition came out true if it did so anywhere. LEFT_OUT.txt lists what no test
can take, a line each: a file, a piece of the source line, and after a # why.

Prints each file with conditions that came out one way only, worst first, then the sum; the conditions
themselves go to stderr, as file:line. Exit status 1 where fewer than PERCENT are taken both ways, or where
what is left out is not there any more.
"""

import collections
import json
import sys


def read_left_out(path):
    rules = []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            rule = line.split("#", 1)[0].strip()
            if rule:
                file, piece = rule.split(None, 1)
                rules.append((file, piece))
    return rules


def conditions(export):
    """{(file, line, column): [times true, times false]} of the pipeline's own sources."""
    taken = collections.defaultdict(lambda: [0, 0])
    for function in export["data"][0]["functions"]:
        names = function["filenames"]
        for line, column, _, _, true, false, file_id, _, _ in function["branches"]:
            name = names[file_id]
            name = name[name.find("pipeline/"):] if "pipeline/" in name else ""
            if name:
                counts = taken[name, line, column]
                counts[0] += true
                counts[1] += false
    return taken


def main():
    rules = read_left_out(sys.argv[1])
    wanted = float(sys.argv[2])
    sources, used = {}, set()
    all_of, missed_of = collections.Counter(), collections.Counter()
    for (name, line, column), (true, false) in sorted(conditions(json.load(sys.stdin)).items()):
        if name not in sources:
            with open(name, encoding="utf-8") as text:
                sources[name] = text.read().split("\n")
        text = sources[name][line - 1]
        fitting = {rule for rule in rules if rule[0] == name and rule[1] in text}
        used |= fitting
        if fitting:
            continue
        all_of[name] += 2
        missed = (true == 0) + (false == 0)
        missed_of[name] += missed
        if missed:
            never = "ever" if missed == 2 else "true" if true == 0 else "false"
            print(f"{name}:{line}:{column}: never {never}: {text.strip()}", file=sys.stderr)
    for name, missed in sorted(missed_of.items(), key=lambda item: -item[1]):
        if missed:
            print(f"{name:<55}{all_of[name] - missed:6} of {all_of[name]}")
    total, missed = sum(all_of.values()), sum(missed_of.values())
    percent = 100 * (total - missed) / total if total else 0
    print(f"{total - missed} of {total} branches taken: {percent:.1f} % (at least {wanted:g} wanted)")
    for rule in set(rules) - used:
        print(f"left out, but not there: {rule[0]} {rule[1]}")
    sys.exit(percent < wanted or len(used) < len(set(rules)))


main()
