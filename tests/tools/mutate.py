"""Whether the tests notice a wrong operator: mutate.py LOG COUNT [SEED [FILE...]]

Changes one operator at a time, of COUNT that chance (by SEED) takes out of pipeline/units and
pipeline/fast, or out of the files that are named; builds, runs tests until one fails, and puts the file
back. Prints a line for each: who noticed it, or that it survived. Exit status 1 where fewer than 95 of 100
were noticed. What does not compile does not count, nor what the compiler makes the same code of, nor what
mutants_alike.txt explains.

Works in the checkout that it is run in, where nothing may be edited meanwhile, with a build of its own in
out/mutants, of the narrowest lanes. A mutant meets the tests of the rooms that the files are of, pipeline or
apps/ROOM (of the pipeline those of readers and writers only where one of these is among the files), those that
noticed most in the least time before others, and one that is explained only quick ones; what survives them meets, in
the end, the techniques' tests and the stored pictures.

LOG ("" for none) gets the lines as well. Places that it has lines of, though they moved, count as judged, but for
what survived: that is asked again.
"""

import collections
import glob
import os
import platform
import random
import re
import signal
import subprocess
import sys
import time

BUILD = "out/mutants"
MAKE = ["make", "-s", "BUILD=" + BUILD, "OPT=-O1", "CFLAGS=-g0"] + (
    ["ISAS=4:sse2:"] if platform.machine() == "x86_64" else [])
OTHER = {
    "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
    "+": "-", "-": "+", "*": "+", "/": "*", "<<": ">>", ">>": "<<", "&": "|", "|": "&",
}
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|&&|\|\||<<|>>|[-+*/<>&|])(?= )")
TOLD = re.compile(r"(\S+?):\d+:(\d+): (\S+) to \S+: (noticed by ([^:]+)|[^:]+): (.*)")
SEEDS = "0..99"  # of differential
NO_CODE = "no other code"
LONG = 1  # seconds of a test that what is explained does not meet


def operators(path):
    """(line number, column, operator) of code: neither comments, directives nor assertions."""
    inside_comment, inside_directive = False, False
    with open(path, encoding="utf-8") as text:
        for number, line in enumerate(text):
            directive = inside_directive or line.lstrip().startswith("#")
            inside_directive = directive and line.rstrip().endswith("\\")
            skip = inside_comment or directive or line.lstrip().startswith(
                ("/*", "*", "_Static_assert", "GP_ASSERT"))
            if "/*" in line:
                inside_comment = "*/" not in line[line.index("/*"):]
            elif inside_comment and "*/" in line:
                inside_comment = False
            if skip:
                continue
            code = line.split("/*", 1)[0]
            for match in OPERATOR.finditer(code):
                yield number, match.start(), match.group()


def run(command, seconds=900, **environment):
    """Exit status, of a command that is given its time; -1 where it takes longer. Time is counted in steps, so
    that a while in which everything here is stopped is one step: no test is slow for that."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True, env={**os.environ, **environment})
    try:
        for _ in range(int(seconds) + 1):
            try:
                return process.wait(timeout=1)
            except subprocess.TimeoutExpired:
                pass
        return -1
    finally:
        if process.poll() is None:
            os.killpg(process.pid, 9)
            process.wait()


def make(*targets):
    return run(MAKE + list(targets)) == 0


class Objects:
    """The objects of what may be mutated, as they are without a mutant."""

    def __init__(self):
        self.kept = {path: self.read(path) for room in ("pipeline", "apps")
                     for path in glob.glob(f"{BUILD}/obj/{room}/**/*.o", recursive=True)}
        self.begun = time.time()

    @staticmethod
    def read(path):
        with open(path, "rb") as file:
            return file.read()

    def changed(self):
        return [path for path, kept in self.kept.items()
                if os.path.getmtime(path) > self.begun and self.read(path) != kept]

    def put_back(self):
        for path in self.changed():
            with open(path, "wb") as file:
                file.write(self.kept[path])
        time.sleep(0.02)
        self.begun = time.time()


class Test:
    """A test program, how long it takes, and how much it noticed."""

    def __init__(self, name, source):
        self.name, self.source, self.noticed = name, source, 0
        begun = os.times()
        self.passes = self.run(600) == 0
        ended = os.times()
        self.seconds = (ended.children_user + ended.children_system
                        - begun.children_user - begun.children_system)

    def run(self, seconds):
        arguments = [SEEDS] if self.name == "differential" else []
        return run([f"{BUILD}/test/{self.name}"] + arguments, seconds, CMOCKA_MESSAGE_OUTPUT="TAP",
                   GLASSPIPE_BIN=BUILD + "/bin/glasspipe")

    def notices(self):
        """A loop without end is noticed too."""
        failed = self.run(20 + 20 * self.seconds) != 0
        self.noticed += failed
        return failed

    def worth(self, mutated):
        stem = os.path.splitext(os.path.basename(mutated))[0]
        return ("test_" + stem == self.name, (self.noticed + 0.2) / (self.seconds + 0.05))


def test_names(folder):
    return [(os.path.basename(path)[:-2], path)
            for path in sorted(glob.glob(f"tests/unit/{folder}/**/test_*.c", recursive=True))]


def tests_of(files):
    """Those of the rooms that these files are of."""
    reads = any("/io/" in path for path in files)
    names = []
    for room in sorted({"/".join(path.split("/")[:1 + path.startswith("apps/")]) for path in files}):
        names += [name for name in test_names(room) if reads or "/io/" not in name[1]]
        names += [("golden", ""), ("differential", "")] if room == "pipeline" else []
    return names


def first_notice(tests, mutated):
    """The first test that fails, or None. The two programs that have their own copy of the pipeline are
    linked when their turn comes."""
    for test in sorted(tests, key=lambda test: test.worth(mutated), reverse=True):
        if not test.source and not make(f"{BUILD}/test/{test.name}"):
            return "the linker"
        if test.notices():
            return test.name
    return None


def pictures_differ():
    return not make("all") or run(["sh", "tests/tools/golden_pictures.sh", BUILD + "/bin/glasspipe"],
                                  1800) != 0


def mutate(place, objects, notice):
    """What `notice` says of an operator that is another; "" where it makes no other code."""
    path, number, column, operator = place
    with open(path, encoding="utf-8") as text:
        lines = text.readlines()
    line, stat = lines[number], os.stat(path)
    changed = line[:column] + OTHER[operator] + line[column + len(operator):]
    try:
        with open(path, "w", encoding="utf-8") as text:
            text.writelines(lines[:number] + [changed] + lines[number + 1:])
        if not make(f"{BUILD}/test/libtested.so") or not objects.changed():
            return ""
        return notice(path)
    finally:
        with open(path, "w", encoding="utf-8") as text:
            text.writelines(lines)
        os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
        objects.put_back()


def line_of(place):
    with open(place[0], encoding="utf-8") as text:
        return text.readlines()[place[1]].strip()


def explained(place):
    """Why a mutant makes nothing else; None: nobody says so."""
    with open(os.path.join(os.path.dirname(__file__), "mutants_alike.txt"), encoding="utf-8") as lines:
        for line in lines:
            rule, _, reason = line.partition(" # ")
            words = rule.split(None, 2)
            if reason and words[:2] == [place[0], place[3]] and words[2].strip() in line_of(place):
                return reason.strip()
    return None


def key_of(place):
    path, _, column, operator = place
    return path, column, operator, line_of(place)


def told(log):
    """What a log says of places: (who noticed it or None, the last verdict)."""
    if not log or not os.path.exists(log):
        return {}
    with open(log, encoding="utf-8") as lines:
        found = [match.groups() for match in map(TOLD.match, lines) if match]
    return {(path, int(column) - 1, operator, line): (who, what) for path, column, operator, what, who, line in found}


def tell(place, what, log):
    path, number, column, operator = place
    line = f"{path}:{number + 1}:{column + 1}: {operator} to {OTHER[operator]}: {what}: {line_of(place)}"
    print(line, flush=True)
    if log:
        with open(log, "a", encoding="utf-8") as lines:
            print(line, file=lines)


def made(names):
    """Tests that are built, and pass as it is."""
    if not make("all", *(f"{BUILD}/test/{name}" for name, _ in names)):
        sys.exit("the tests cannot be built")
    tests = [Test(*name) for name in names]
    broken = [test.name for test in tests if not test.passes]
    if broken:
        sys.exit("fail as it is: " + " ".join(broken))
    print(f"# {len(tests)} tests of {sum(test.seconds for test in tests):.0f} s: " + " ".join(
        f"{test.name} {test.seconds:.1f}" for test in tests if test.seconds > LONG), flush=True)
    return tests


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("stopped"))  # the file is put back first
    log, count = sys.argv[1], int(sys.argv[2])
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    files = sys.argv[4:] or sorted(
        path for room in ("pipeline/units", "pipeline/fast")
        for path in glob.glob(room + "/**/*.[ch]", recursive=True))
    places = [(path, *place) for path in files for place in operators(path)]
    chance.shuffle(places)
    known = told(log)
    places = list({key_of(place): place for place in places}.values())
    places.sort(key=lambda place: key_of(place) not in known)
    own = made(tests_of(files))
    for test in own:
        test.noticed = sum(who == test.name for who, _ in known.values())
    quick = [test for test in own if test.seconds <= LONG]
    objects, begun, verdicts, left = Objects(), time.time(), collections.Counter(), []
    for place in places:
        if verdicts["noticed"] + verdicts["alike"] + len(left) == count:
            break
        who, what = known.get(key_of(place), (None, ""))
        reason = explained(place)
        if who or what == NO_CODE or (reason and what == "alike"):
            verdicts["noticed" if who else what] += 1
            continue
        who = mutate(place, objects, lambda path: first_notice(quick if reason else own, path))
        verdict = NO_CODE if who == "" else "noticed" if who else "alike" if reason else "survives its rooms' tests"
        verdicts[verdict] += 1
        if verdict.startswith("survives"):
            left.append(place)
        tell(place, f"noticed by {who}" if who else verdict, log)
    late = 0
    if left:
        others = made(test_names("apps/techniques") + test_names("shaders_c"))
        objects = Objects()
        for place in left:
            who = mutate(place, objects, lambda path: first_notice(others, path) or (
                "pictures" if pictures_differ() else None))
            late += who is not None
            tell(place, f"noticed by {who}" if who else "SURVIVED", log)
    noticed, asked = verdicts["noticed"] + late, verdicts["noticed"] + len(left)
    print(f"{noticed} of {asked} noticed, {late} of them by techniques' tests and pictures alone; {verdicts['alike']} "
          f"more make nothing else, {verdicts[NO_CODE]} not even other code; {time.time() - begun:.0f} s")
    sys.exit(asked == 0 or noticed * 100 < 95 * asked)


main()
