"""A headless Chromium that opens pages of this program, for tests: by its protocol of development tools, with
Python's own library alone."""
import base64
import json
import os
import re
import subprocess
import time


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
        self.ask("Performance.enable", timeDomain="threadTicks")

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

    def spent(self):
        """Seconds of the processor that the page's own thread took since it was opened."""
        metrics = self.ask("Performance.getMetrics")["metrics"]
        return next(one["value"] for one in metrics if one["name"] == "ThreadTime")

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

    def screenshot(self, path, **options):
        picture = self.ask("Page.captureScreenshot", format="png", **options)
        path.write_bytes(base64.b64decode(picture["data"]))

    def print_pdf(self, path):
        """The page on paper."""
        told = self.ask("Page.printToPDF", printBackground=False, preferCSSPageSize=True)
        path.write_bytes(base64.b64decode(told["data"]))

    def close(self):
        self.process.kill()
        self.process.wait()
