#!/usr/bin/env python3
"""Opens pages of `glasspipe inspect` in a headless Chromium and holds what they show against the trace:

    inspect_pages.py PROGRAM SCENE | "INPUT --technique NAME ..." ...

For each scene: the page from file://, without an error in the console; a click on a pixel; every unit, by
keyboard, of every fragment there; and each value shown, those of shaders' steps too, equal to what
`glasspipe pixel --steps --json` says, and written as it is; of one scene, and of every technique's frame, that
all texts have the contrast that WCAG AA asks for. Of a technique's frame, all panels of a pixel, held against the page's own record; and
that its panel has values. Also how large a page is and how soon it opens. Says so in TAP.
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

from browser import Browser

SIZE = "160x120"
MOST_BYTES = 10_000_000
MOST_SECONDS = 2  # to open
UNITS = 12  # panels that every frame has


SHOWN = """
[...document.querySelectorAll('#panel [data-path]')].map(
    (one) => [one.dataset.path, one.dataset.value, one.textContent])
"""

PLACE = """
(() => {
    const { frame, state } = window.inspector, pass = frame.passes[state.pass];
    const [x, y] = %s;
    const box = document.querySelector('.stage canvas').getBoundingClientRect();
    return { x: box.left + (x + .5) * box.width / pass.width,
             y: box.top + (y + .5) * box.height / pass.height };
})()
"""


# Texts whose contrast is below WCAG 2's AA: their words, and the contrast.
FAINT = """
(() => {
    const channels = (color) => color.match(/[\\d.]+/g).map(Number);
    const linear = (c) => c / 255 <= .04045 ? c / 255 / 12.92 : ((c / 255 + .055) / 1.055) ** 2.4;
    const light = ([r, g, b]) => .2126 * linear(r) + .7152 * linear(g) + .0722 * linear(b);
    const ground = (node) => {
        for (; node; node = node.parentElement) {
            const color = channels(getComputedStyle(node).backgroundColor);
            if (color.length < 4 || color[3] === 1)
                return color;
        }
        return [255, 255, 255];
    };
    const faint = [];
    for (const node of document.querySelectorAll('body *')) {
        const own = [...node.childNodes].some((one) => one.nodeType === 3 && one.data.trim());
        if (!own || node.closest('script, svg, option') || !node.checkVisibility())
            continue;
        const style = getComputedStyle(node), [a, b] = [light(channels(style.color)), light(ground(node))];
        const contrast = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
        if (contrast < (parseFloat(style.fontSize) >= 24 ? 3 : 4.5))
            faint.push(`${node.textContent.trim().slice(0, 30)}: ${contrast.toFixed(2)}`);
    }
    return faint;
})()
"""


# Slices of the voxels of the first pass's worksheets.
SLICES = """
(async () => {
    const { frame, state, choose, idle } = window.inspector;
    const [x, y] = frame.nearest(0, frame.passes[0].width >> 1, frame.passes[0].height >> 1);
    choose({ pass: 0, draw: frame.passes[0].draws.length - 1, x, y, fragment: -1, unit: "voxels" });
    await idle();
    return document.querySelectorAll('#panel .slice canvas').length;
})()
"""


class Trace:
    """What the trace says of a pixel's fragment."""

    def __init__(self, events, draw, primitive):
        self.parts = {"vertices": [], "setup": [], "texture": [], "test": [], "output": []}
        for event in events:
            if event.get("draw") == draw and event.get("primitive") == primitive:
                self.add(event, {"vertex": "vertices"}.get(event["kind"], event["kind"]))

    def add(self, event, kind):
        if kind == "steps" and "corner" in event:
            self.parts["vertices"][event["corner"]]["steps"] = event
        elif kind in self.parts and isinstance(self.parts[kind], list):
            known = kind in ("vertices", "setup") and any(
                one.get("vertex") == event.get("vertex") and one.get("part") == event.get("part")
                for one in self.parts[kind])
            if not known or (kind == "vertices" and len(self.parts[kind]) < 3):
                self.parts[kind].append(event)
        else:
            self.parts[kind] = event

    def at(self, path):
        value = self.parts
        words = path.split(".")
        if words[0] == "setup":
            value = next(one for one in self.parts["setup"] if one["part"] == int(words[1]))
            words = words[2:]
        for word in words:
            value = value[int(word)] if isinstance(value, list) else value[word]
        return value


class Recorded:
    """The same of the page's own record: of frames that `glasspipe pixel` does not draw."""

    def __init__(self, browser):
        self.browser, self.known = browser, {}

    def fragment(self, name):
        if name not in self.known:
            self.known[name] = self.browser.evaluate("""(async ([number, draw, primitive]) => {
                const { frame, state } = window.inspector;
                return { events: (await frame.history(number, state.x, state.y)) ?? [],
                         primitive: await frame.primitive(number, draw, primitive) };
            })(%s)""" % json.dumps([int(word) for word in name.split("/")]))
        _, draw, primitive = (int(word) for word in name.split("/"))
        told = self.known[name]
        trace = Trace(told["events"], draw, primitive)
        for part in ("vertices", "clip", "setup"):
            trace.parts[part] = (told["primitive"] or {}).get(part, [])
        return trace


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def same(shown, said):
    if isinstance(said, str):
        return shown == said
    if isinstance(said, int):
        return float(shown) == said
    if shown in ("nan", "inf", "-inf"):
        return False
    # a float to its bits; what is a double to the nine digits of a page
    return single(float(shown)) == single(said) or abs(float(shown) - said) <= 1e-9 * abs(said)


def readable(text, shown):
    """Whether the text of a value is that value, to seven digits."""
    if text in ("true", "false"):
        return (shown == "1") == (text == "true")
    if shown in ("nan", "inf", "-inf"):
        return text == shown
    value, read = float(shown), float(text.replace(" ", ""))
    return abs(value - read) <= 1e-6 * abs(value)


class Faults(list):
    """What was wrong, and how much was looked at."""
    looked = megabytes = milliseconds = 0


def said_of(path, trace, recorded):
    """What a value ought to be: of the chosen fragment, or of the one that the path begins with."""
    if path.startswith("@"):
        name, rest = path[1:].split(".", 1)
        return recorded.fragment(name).at(rest)
    return trace.at(path)


def check_panel(browser, trace, recorded, faults, where):
    for path, shown, text in browser.evaluate(SHOWN):
        faults.looked += 1
        if not readable(text, shown):
            faults.append(f"{where}: {path} is {shown}, and reads {text}")
        if path.split(".")[0] in ("incoming", "stored", "result", "truth"):
            continue
        try:
            said = said_of(path, trace, recorded)
        except (KeyError, IndexError, StopIteration):
            faults.append(f"{where}: {path} is not in the trace")
            continue
        if not same(shown, said):
            faults.append(f"{where}: {path} is {shown}, the trace has {said}")


def check_fragment(browser, events, faults, scene):
    chosen = browser.evaluate("({ ...window.inspector.pixel.list[window.inspector.state.fragment], "
                              "agrees: window.inspector.pixel.one?.steps?.agrees })")
    trace, recorded = Trace(events, chosen["draw"], chosen["primitive"]), Recorded(browser)
    if chosen.get("agrees") is False:
        faults.append(f"{scene}: the steps of draw {chosen['draw']} end in other bits")
    browser.press("1")
    for unit in browser.evaluate("window.inspector.units"):
        now = browser.evaluate("window.inspector.state.unit")
        if now != unit:
            faults.append(f"{scene}: the keyboard is at {now}, not {unit}")
        check_panel(browser, trace, recorded, faults, f"{scene}, {unit}")
        browser.press("i")
    browser.press("0")
    for _ in range(3):
        browser.press("j")
        check_panel(browser, trace, recorded, faults, f"{scene}, shader")


def check_pixel(browser, program, scene, faults):
    """The recorded pixel with the most fragments."""
    place = browser.evaluate("""(async () => {
        const { frame, state } = window.inspector, of = await frame.fragments(state.pass);
        let best = null, most = -1;
        for (const [x, y] of frame.passes[state.pass].histories.pixels) {
            const count = of.at(x, y).length;
            if (count > most && count < 9) { most = count; best = [x, y]; }
        }
        return best;
    })()""")
    at = browser.evaluate(PLACE % json.dumps(place))
    browser.click(at["x"], at["y"])
    state = browser.evaluate("({ ...window.inspector.state })")
    if [state["x"], state["y"]] != place:
        faults.append(f"{scene}: a click at {place} chose {state['x']}, {state['y']}")
    told = json.loads(subprocess.run(
        [program, "pixel", scene, str(state["x"]), str(state["y"]), "--pass", str(state["pass"]),
         "--size", SIZE, "--steps", "--json"], check=True, capture_output=True).stdout)
    count = browser.evaluate("window.inspector.pixel.list.length")
    for _ in range(count):
        browser.press("<")
    for i in range(count):
        check_fragment(browser, told["events"], faults, scene)
        browser.press(">")
    stored = browser.evaluate("[...document.querySelectorAll('.readout [data-stored]')].length")
    if not stored:
        faults.append(f"{scene}: the target's values are not shown")


def check_contrast(browser, faults, scene):
    """Of all units, by day and by night."""
    for scheme in ("light", "dark"):
        browser.ask("Emulation.setEmulatedMedia",
                    features=[{"name": "prefers-color-scheme", "value": scheme},
                              {"name": "prefers-reduced-motion", "value": "reduce"}])
        browser.press("1")
        for unit in browser.evaluate("window.inspector.units"):
            faults.extend(f"{scene}, {unit}, {scheme}: too faint: {text}"
                          for text in browser.evaluate(FAINT))
            browser.press("i")
    browser.ask("Emulation.setEmulatedMedia", features=[])


def check_middle(browser, faults, case):
    """The recorded pixel in the middle: what all panels show is in the record, and the technique's has values."""
    browser.press("1")
    own = 0
    for number, unit in enumerate(browser.evaluate("window.inspector.units")):
        before = faults.looked
        chosen = browser.evaluate(
            "window.inspector.pixel.list[window.inspector.state.fragment] ?? null")
        recorded = Recorded(browser)
        state = browser.evaluate("({ ...window.inspector.state })")
        trace = recorded.fragment(f"{state['pass']}/{chosen['draw']}/{chosen['primitive']}")
        check_panel(browser, trace, recorded, faults, f"{case}, {unit}")
        own = faults.looked - before if number >= UNITS else own
        browser.press("i")
    if "--technique" in case and not own and not browser.evaluate(SLICES):
        faults.append(f"{case}: its own panel shows no value")


def check_page(browser, page, faults, case):
    """Opens a page; its bytes, and the time until all of it stands."""
    browser.open(page)
    faults.milliseconds = browser.evaluate("window.inspector.milliseconds")
    if browser.spent() > MOST_SECONDS:
        faults.append(f"{case}: the page takes {browser.spent():.1f} s of the processor to open")
    faults.megabytes = page.stat().st_size / 1e6
    if page.stat().st_size > MOST_BYTES:
        faults.append(f"{case}: the page has {page.stat().st_size} bytes")


def check_case(browser, program, case, folder):
    faults = Faults()
    words = case.split()
    is_scene = len(words) == 1
    page = pathlib.Path(folder) / "page.html"
    size = ["--size", SIZE] if is_scene else []
    subprocess.run([program, "inspect", *words, *size, "--no-timings", "-q", "-o", page], check=True)
    check_page(browser, page, faults, case)
    if is_scene:
        check_pixel(browser, program, case, faults)
    else:
        check_middle(browser, faults, case)
    if case.endswith("stencil_outline.json") or not is_scene:
        check_contrast(browser, faults, case)
    faults.extend(f"{case}: {said}" for said in browser.complaints())
    page.unlink()
    if not faults.looked:
        faults.append(f"{case}: no value is shown")
    return faults


def main():
    program, cases = os.path.abspath(sys.argv[1]), sys.argv[2:]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(folder)
        for number, case in enumerate(cases, 1):
            try:
                faults = check_case(browser, program, case, folder)
            except (RuntimeError, subprocess.CalledProcessError) as problem:
                faults = Faults([str(problem)])
            print(f"{'not ok' if faults else 'ok'} {number} - a page shows what the trace has: "
                  f"{case}, {faults.looked} values, {faults.megabytes:.1f} MB, "
                  f"opens in {faults.milliseconds:.0f} ms", flush=True)
            for fault in faults[:12]:
                print("# " + re.sub(r"data:[^ )]*", "data:", fault).replace("\n", " "))
        browser.close()
    print(f"1..{len(cases)}")


if __name__ == "__main__":
    main()
