#!/usr/bin/env python3
"""Opens pages of `glasspipe inspect` in a headless Chromium and holds what they show against the trace:

    inspect_pages.py PROGRAM SCENE...

For each scene: the page from file://, without an error in the console; a click on a pixel; every unit, by
keyboard, of every fragment there; and each value shown equal to what `glasspipe pixel --json` says, and
written as it is; of one scene that all texts have the contrast that WCAG AA asks for. Says so in TAP. Python's own library is enough: Chromium is spoken to by a pipe.
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time

SIZE = "160x120"


class Browser:
    """Chromium, by its protocol of development tools over file descriptors 3 and 4."""

    def __init__(self, folder):
        to_read, self.write_end = os.pipe()
        self.read_end, to_write = os.pipe()

        def connect():
            copies = os.dup(to_read), os.dup(to_write)
            os.dup2(copies[0], 3)
            os.dup2(copies[1], 4)
            os.set_inheritable(3, True)
            os.set_inheritable(4, True)

        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-dev-shm-usage", "--remote-debugging-pipe", f"--user-data-dir={folder}",
             "--window-size=1500,1200", "about:blank"],
            preexec_fn=connect, close_fds=False, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.number, self.waiting, self.events = 0, b"", []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.ask(f"{domain}.enable")

    def message(self):
        while b"\0" not in self.waiting:
            got = os.read(self.read_end, 1 << 20)
            if not got:
                raise RuntimeError("Chromium has gone")
            self.waiting += got
        one, self.waiting = self.waiting.split(b"\0", 1)
        return json.loads(one)

    def ask(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if hasattr(self, "session"):
            request["sessionId"] = self.session
        os.write(self.write_end, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def evaluate(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, awaitPromise=True,
                          returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description"))
        return answer["result"].get("value")

    def open(self, path):
        self.events = []
        self.ask("Page.navigate", url=path.as_uri())
        end = time.monotonic() + 60
        while not self.evaluate("document.documentElement?.dataset.ready === 'true'"):
            if time.monotonic() > end:
                raise RuntimeError(f"the page is not ready; {self.complaints()}")
            time.sleep(0.1)

    def complaints(self):
        """Errors of scripts and of the console since the page was opened."""
        said = []
        for event in self.events:
            kind, of = event.get("method"), event.get("params", {})
            if kind == "Runtime.exceptionThrown":
                details = of["exceptionDetails"]
                said.append(details.get("exception", {}).get("description", details["text"]))
            elif kind == "Runtime.consoleAPICalled" and of["type"] in ("error", "warning"):
                said.append(str(of["args"]))
            elif kind == "Log.entryAdded" and of["entry"]["level"] == "error":
                said.append(of["entry"]["text"])
        return [re.sub(r"data:[^ )]*", "data:", one).replace("\n", " ") for one in said]

    def press(self, key):
        text = key if len(key) == 1 else ""
        self.ask("Input.dispatchKeyEvent", type="keyDown", key=key, text=text)
        self.ask("Input.dispatchKeyEvent", type="keyUp", key=key)
        self.evaluate("window.inspector.idle()")

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)
        self.evaluate("window.inspector.idle()")

    def close(self):
        self.process.kill()
        self.process.wait()


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


class Trace:
    """What the trace says of a pixel's fragment."""

    def __init__(self, events, draw, primitive):
        self.parts = {"vertices": [], "setup": [], "texture": [], "test": [], "output": []}
        names = {"vertex": "vertices"}
        for event in events:
            if event.get("draw") != draw or event.get("primitive") != primitive:
                continue
            kind = names.get(event["kind"], event["kind"])
            if kind in self.parts and isinstance(self.parts[kind], list):
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
    looked = 0


def check_panel(browser, trace, faults, where):
    for path, shown, text in browser.evaluate(SHOWN):
        faults.looked += 1
        if not readable(text, shown):
            faults.append(f"{where}: {path} is {shown}, and reads {text}")
        if path.split(".")[0] in ("steps", "incoming", "stored", "result"):
            continue
        try:
            said = trace.at(path)
        except (KeyError, IndexError, StopIteration):
            faults.append(f"{where}: {path} is not in the trace")
            continue
        if not same(shown, said):
            faults.append(f"{where}: {path} is {shown}, the trace has {said}")


def check_fragment(browser, events, faults, scene):
    chosen = browser.evaluate("({ ...window.inspector.pixel.list[window.inspector.state.fragment], "
                              "agrees: window.inspector.pixel.one?.steps?.agrees })")
    trace = Trace(events, chosen["draw"], chosen["primitive"])
    if chosen.get("agrees") is False:
        faults.append(f"{scene}: the steps of draw {chosen['draw']} end in other bits")
    browser.press("1")
    for unit in browser.evaluate("window.inspector.units"):
        now = browser.evaluate("window.inspector.state.unit")
        if now != unit:
            faults.append(f"{scene}: the keyboard is at {now}, not {unit}")
        check_panel(browser, trace, faults, f"{scene}, {unit}")
        browser.press("i")
    browser.press("0")
    for _ in range(3):
        browser.press("j")
        check_panel(browser, trace, faults, f"{scene}, shader")


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
         "--size", SIZE, "--json"], check=True, capture_output=True).stdout)
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


def check_scene(browser, program, scene, folder):
    faults = Faults()
    page = pathlib.Path(folder) / (pathlib.Path(scene).stem + ".html")
    subprocess.run([program, "inspect", scene, "--size", SIZE, "--no-timings", "-q", "-o", page],
                   check=True)
    browser.open(page)
    check_pixel(browser, program, scene, faults)
    if scene.endswith("stencil_outline.json"):
        check_contrast(browser, faults, scene)
    faults.extend(f"{scene}: {said}" for said in browser.complaints())
    page.unlink()
    if not faults.looked:
        faults.append(f"{scene}: no value is shown")
    return faults


def main():
    program, scenes = os.path.abspath(sys.argv[1]), sys.argv[2:]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(folder)
        for number, scene in enumerate(scenes, 1):
            try:
                faults = check_scene(browser, program, scene, folder)
            except (RuntimeError, subprocess.CalledProcessError) as problem:
                faults = Faults([str(problem)])
            print(f"{'not ok' if faults else 'ok'} {number} - a page shows what the trace has: "
                  f"{scene}, {faults.looked} values", flush=True)
            for fault in faults[:12]:
                print("# " + re.sub(r"data:[^ )]*", "data:", fault).replace("\n", " "))
        browser.close()
    print(f"1..{len(scenes)}")


main()
