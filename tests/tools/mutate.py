"""Whether the tests notice a wrong operator: mutate.py COUNT [SEED [FILE...]]

Changes one operator at a time, of COUNT that chance (by SEED) takes out of pipeline/units and
pipeline/fast, or out of the files that are named; builds, runs the tests until one fails, and puts the file
back. Prints a line for each: who noticed it, or that it survived. Exit status 1 where fewer than 95 of 100
were noticed. What does not compile does not count, nor what the compiler makes the same code of.

Works in the checkout that it is run in, where nothing else may be built or changed meanwhile; BUILD=out, as
make has it. A mutant takes some seconds to be built and noticed, and as long as all the tests to survive.
"""

import glob
import hashlib
import os
import random
import re
import subprocess
import sys

OTHER = {
    "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
    "+": "-", "-": "+", "*": "+", "/": "*", "<<": ">>", ">>": "<<", "&": "|", "|": "&",
}
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|&&|\|\||<<|>>|[-+*/<>&|])(?= )")
# Quick ones that see much come first; then all others.
FIRST = ["golden.lanes4", "golden.lanes8", "test_raster", "test_blend", "test_depth_stencil", "differential"]


def operators(path):
    """(line number, column, operator) of code: neither comments, directives nor assertions."""
    inside_comment, inside_directive = False, False
    with open(path, encoding="utf-8") as text:
        for number, line in enumerate(text):
            directive = inside_directive or line.lstrip().startswith("#")
            inside_directive = directive and line.rstrip().endswith("\\")
            skip = inside_comment or directive or line.lstrip().startswith(("/*", "*", "_Static_assert"))
            if "/*" in line:
                inside_comment = "*/" not in line[line.index("/*"):]
            elif inside_comment and "*/" in line:
                inside_comment = False
            if skip:
                continue
            code = line.split("/*", 1)[0]
            for match in OPERATOR.finditer(code):
                yield number, match.start(), match.group()


def run(*command, seconds=600):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=seconds, check=False).returncode
    except subprocess.TimeoutExpired:
        return -1


def library_hash():
    """Of the code of all objects, so that mutants which change none are known."""
    result = hashlib.sha256()
    for path in sorted(glob.glob("out/lib/libglasspipe.a")):
        text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", path], capture_output=True,
                              check=True).stdout
        result.update(re.sub(rb"^.*file format.*$", b"", text, flags=re.M))
    return result.hexdigest()


def failed(result):
    """Whether a test's result tells of a failure; one that ran out of time does."""
    with open(result, encoding="utf-8", errors="replace") as text:
        lines = text.read().split("\n")
    return any(line.startswith("not ok") for line in lines) or "# exit status 0" not in lines


def noticed(targets):
    """The first test that fails, or None."""
    for target in targets:
        result = f"out/test/{target}.tap"
        if os.path.exists(result):
            os.remove(result)
        if run("make", "-s", result, "SEEDS=0..199", seconds=900) != 0 or failed(result):
            return target
    return None


def all_tests():
    names = [os.path.basename(path)[:-4] for path in sorted(glob.glob("out/test/*.tap"))]
    slow = {"library", "headers", "snippets", "inspect"}
    rest = [name for name in names if name not in FIRST and name not in slow]
    rest.sort(key=lambda name: (not name.startswith("test_"), name.startswith("test_cli"), name))
    return [name for name in FIRST if name in names] + rest


def main():
    count = int(sys.argv[1])
    chance = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    files = sys.argv[3:] or sorted(
        path for room in ("pipeline/units", "pipeline/fast")
        for path in glob.glob(room + "/**/*.[ch]", recursive=True))
    places = [(path, *place) for path in files for place in operators(path)]
    chance.shuffle(places)
    if run("make", "-s", "test") != 0:
        sys.exit("the tests fail as it is")
    tests, original = all_tests(), library_hash()
    done = survived = 0
    for path, number, column, operator in places:
        if done == count:
            break
        with open(path, encoding="utf-8") as text:
            lines = text.readlines()
        line = lines[number]
        changed = line[:column] + OTHER[operator] + line[column + len(operator):]
        try:
            with open(path, "w", encoding="utf-8") as text:
                text.writelines(lines[:number] + [changed] + lines[number + 1:])
            compiles = run("make", "-s", "all") == 0
            if not compiles or library_hash() == original:
                continue
            who = noticed(tests)
        finally:
            with open(path, "w", encoding="utf-8") as text:
                text.writelines(lines)
        done += 1
        survived += who is None
        print(f"{path}:{number + 1}: {operator} to {OTHER[operator]}: "
              f"{'noticed by ' + who if who else 'SURVIVED: ' + line.strip()}", flush=True)
    run("make", "-s", "all")
    print(f"{done - survived} of {done} noticed")
    sys.exit(done == 0 or (done - survived) * 100 < 95 * done)


main()
