#!/usr/bin/env python3
"""Opens lessons in a headless Chromium, and answers them:

    lesson_pages.py PROGRAM

Some of them; with $GP_TEST_INSPECT all. Each is opened from file://; its value is hidden, in its panel and in those that follow; a wrong answer, and
none, leave it so; the right one, in several spellings, shows it, and the reason. Giving up does too. The index
names every lesson and marks what was answered. No error in the console; all texts have the contrast of WCAG AA.
Says so in TAP.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from browser import Browser
from inspect_pages import FAINT

# What is typed: the right answer, found by hand, in spellings that count as one; wrong ones.
ANSWERS = {
    "01_three_vertices": (["0 2", "2, 0", "2 and 0"], ["0", "0 1", "0 1 2"]),
    "02_vertex_shader": (["2", "2.0", "0x2"], ["4", "two"]),
    "03_clipping": (["4", "+4"], ["3", "5"]),
    "04_viewport": (["845", "0x34d", "0X34D"], ["844", "844.8"]),
    "05_setup": (["-80", "\u221280", "-80.0"], ["80", "-40"]),
    "06_fill_rule": (["21"], ["18", "15"]),
    "07_interpolation": (["0.2", ".2", "0,20", "1/5", "2e-1"], ["0.5", "0.25"]),
    "08_levels": (["4"], ["16", "3"]),
    "09_pixel_shader": (["0.675", ".675", "27/40"], ["0.6", "0.68"]),
    "10_tests": (["6"], ["5", "3"]),
    "11_blending": (["96", "0x60"], ["95", "0.375"]),
    "12_deferred_four_targets": (["5.5", "11/2"], ["5", "6"]),
}

# Over all units: values that can be seen, of those that the lesson hides by their paths; and parts that are veiled.
SEEN = """
(async () => {
    const hides = (pattern, path) => {
        const wanted = pattern.split('.'), words = path.split('.');
        return wanted.length <= words.length && wanted.every((word, i) => word === '*' || word === words[i]);
    };
    let seen = 0, veiled = 0;
    for (const unit of [...window.inspector.units, %s]) {
        await window.inspector.choose({ unit });
        seen += [...document.querySelectorAll('[data-path]')].filter((one) =>
            %s.some((word) => hides(word, one.dataset.path)) && getComputedStyle(one).visibility !== 'hidden').length;
        veiled += document.querySelectorAll('.veiled, .veiled-part').length;
    }
    return [seen, veiled];
})()
"""

SAME = """
import('page/lesson.js').then(({ normal_form }) => %s.every((text) => normal_form(%s, text) === normal_form(%s, %s)))
"""

TYPE = """
(() => {
    const form = document.querySelector('#lesson form');
    form.querySelector('[name=answer]').value = %s;
    form.requestSubmit();
    return window.inspector.idle();
})()
"""

STATE = "document.querySelector('#lesson').dataset.state ?? 'asked'"


def visit(browser, path):
    """Any page, when it is there."""
    browser.events = []
    browser.ask("Page.navigate", url=path.as_uri())
    end = time.monotonic() + 60
    while not browser.evaluate(f"location.href.startsWith({json.dumps(path.as_uri())}) && document.readyState === 'complete'"):
        if time.monotonic() > end:
            raise RuntimeError(f"{path.name} does not open")
        time.sleep(0.02)


def describe(path):
    return json.loads(pathlib.Path(f"scenes/lessons/{path}.lesson.json").read_text())


def shows(browser, lesson):
    """How many of the hidden values can be seen, and how much is veiled."""
    return browser.evaluate(SEEN % (json.dumps(lesson["unit"]), json.dumps(lesson["hide"])))


def check_lesson(browser, folder, name, faults):
    lesson, (right, wrong) = describe(name), ANSWERS[name]
    browser.open(folder / f"{name}.html")
    state = browser.evaluate("({ ...window.inspector.state })")
    if state["unit"] != lesson["unit"] or [state["x"], state["y"]] != lesson["pixel"]:
        faults.append(f"it opens at {state['unit']}, {state['x']}, {state['y']}")
    for text in ["", *wrong]:
        browser.evaluate(TYPE % json.dumps(text))
        if browser.evaluate(STATE) != "asked":
            faults.append(f"'{text}' is taken for an answer")
    seen, veiled = shows(browser, lesson)
    if seen or not veiled:
        faults.append(f"{seen} hidden values can be seen before the answer, {veiled} are veiled")
    if lesson["why"][:24] in browser.evaluate("document.body.textContent"):
        faults.append("the reason stands there before the answer")
    form = {"form": lesson["answer"]["form"], "places": lesson["answer"].get("places", 0)}
    if not browser.evaluate(SAME % tuple(json.dumps(one) for one in (right, form, form, right[0]))):
        faults.append(f"{right} are not the same")
    browser.evaluate(TYPE % json.dumps(right[-1]))
    browser.evaluate("new Promise((done) => setTimeout(done, 20))")
    if browser.evaluate(STATE) != "answered":
        faults.append(f"'{right[-1]}' is not taken")
    seen, veiled = shows(browser, lesson)
    if veiled or (not seen and lesson["answer"]["from"] not in ("covered", "vertices.reuse=2.vertex")):
        faults.append(f"after the answer {seen} values can be seen, {veiled} cannot")
    if lesson["why"][:24] not in browser.evaluate("document.body.innerText"):
        faults.append("the reason does not stand there after the answer")
    faults.extend(browser.complaints())


def check_giving_up(browser, folder, faults):
    browser.open(folder / "03_clipping.html")
    browser.evaluate("document.querySelectorAll('#lesson .buttons button')[1].click()")
    browser.evaluate("new Promise((done) => setTimeout(done, 20))")
    if browser.evaluate(STATE) != "shown" or not shows(browser, describe("03_clipping"))[0]:
        faults.append("giving up does not show the value")
    faults.extend(browser.complaints())


def check_contrast(browser, folder, name, faults):
    for scheme in ("light", "dark"):
        browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        if name == "index.html":
            visit(browser, folder / name)
        else:
            browser.open(folder / name)
        faults.extend(f"{scheme}: too faint: {text}" for text in browser.evaluate(FAINT))
    browser.ask("Emulation.setEmulatedMedia", features=[])


# As a teacher would write it.
CHOICE = {
    "title": "A choice", "learn": "L", "unit": "tests", "pixel": [7, 8], "draw": 1, "question": "Which test ends it?",
    "why": "W", "answer": {"from": "test.passed=false.unit", "form": "choice", "choices": [
        {"value": "stencil", "text": "the stencil test"}, {"value": "depth", "text": "the depth test"}]},
}


def check_choice(browser, program, scratch, faults):
    folder = pathlib.Path(scratch) / "own"
    folder.mkdir()
    shutil.copy("scenes/lessons/10_tests.json", folder / "own.json")
    (folder / "own.lesson.json").write_text(json.dumps(CHOICE))
    subprocess.run([program, "inspect", "--lesson", folder / "own.lesson.json", "-q", "-o", folder / "own.html"], check=True)
    browser.open(folder / "own.html")
    said = []
    for choice in (None, 0, 1):
        if choice is not None:
            browser.evaluate(f"document.querySelectorAll('#lesson [type=radio]')[{choice}].click()")
        browser.evaluate("document.querySelector('#lesson form').requestSubmit()")
        browser.evaluate("new Promise((done) => setTimeout(done, 20))")
        said.append(browser.evaluate(STATE))
    if said != ["asked", "asked", "answered"]:
        faults.append(f"no choice, a wrong one and the right one: {said}")
    faults.extend(browser.complaints())


def check_index(browser, folder, faults):
    visit(browser, folder / "index.html")
    links = browser.evaluate("[...document.querySelectorAll('[data-lesson]')].map((one) => [one.dataset.lesson, "
                             "one.querySelector('.done').textContent])")
    if [name for name, _ in links] != sorted(ANSWERS):
        faults.append(f"the index has {[name for name, _ in links]}")
    marks = {name: mark for name, mark in links}
    if "answered" not in marks.get("01_three_vertices", "") or "seen" not in marks.get("03_clipping", ""):
        faults.append(f"the index marks {marks}")
    faults.extend(browser.complaints())


def main():
    program, count = os.path.abspath(sys.argv[1]), 0
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        folder = pathlib.Path(scratch) / "lessons"
        subprocess.run([program, "inspect", "--lesson", "scenes/lessons", "--no-timings", "-q", "-o", folder], check=True)
        browser = Browser(scratch)
        tests = [(f"lesson {name} is answered", lambda faults, name=name: check_lesson(browser, folder, name, faults))
                 for name in sorted(ANSWERS)[::1 if os.environ.get("GP_TEST_INSPECT") else 5]]
        tests += [("a lesson of one's own is chosen from", lambda faults: check_choice(browser, program, scratch, faults)),
                  ("giving up shows the value", lambda faults: check_giving_up(browser, folder, faults)),
                  ("the index has all lessons, and marks them", lambda faults: check_index(browser, folder, faults)),
                  ("a lesson has contrast", lambda faults: check_contrast(browser, folder, "03_clipping.html", faults)),
                  ("the index has contrast", lambda faults: check_contrast(browser, folder, "index.html", faults))]
        for count, (name, run) in enumerate(tests, 1):
            faults = []
            try:
                run(faults)
            except RuntimeError as problem:
                faults.append(str(problem))
            print(f"{'not ok' if faults else 'ok'} {count} - {name}", flush=True)
            for fault in faults[:8]:
                print(f"# {fault}")
        browser.close()
    print(f"1..{count}")


main()
