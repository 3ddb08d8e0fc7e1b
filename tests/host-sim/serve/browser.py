"""A headless Chromium, driven over its debugging protocol with the standard library alone."""
import base64
import json
import pathlib
import subprocess
import tempfile
import time

from web_client import TEXT, WebSocket, http

# Keys whose name is no character: code and number.
NAMED = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Escape": 27, "Enter": 13, "Tab": 9}


class Browser:
    def __init__(self, chromium):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.process = subprocess.Popen(
            [chromium, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--window-size=1360,900",
             "--remote-debugging-port=0", f"--user-data-dir={self.folder.name}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        place = pathlib.Path(self.folder.name, "DevToolsActivePort")
        end = time.monotonic() + 60
        while not (place.exists() and "\n" in place.read_text()):
            if time.monotonic() > end:
                raise TimeoutError("the browser does not start")
            time.sleep(0.05)
        self.port = int(place.read_text().split("\n")[0])
        self.pages = []
        found = WebSocket(self.port, place.read_text().split("\n")[1].strip())
        self.control = Remote(found)

    def open(self, address):
        target = self.control.do("Target.createTarget", url="about:blank")["targetId"]
        page = Page(WebSocket(self.port, f"/devtools/page/{target}"))
        self.pages.append(page)
        page.do("Page.enable")
        page.do("Network.enable")
        page.do("Runtime.enable")
        page.do("Page.navigate", url=address)
        page.wait("document.readyState === 'complete'")
        return page

    def close(self):
        for page in self.pages:
            page.socket.close()
        self.control.socket.close()
        self.process.terminate()
        self.process.wait(20)
        self.folder.cleanup()


class Remote:
    """One end of the debugging protocol."""

    def __init__(self, socket):
        self.socket = socket
        self.socket.link.settimeout(30)
        self.number = 0
        self.events = []

    def do(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        self.socket.send(json.dumps(message).encode(), TEXT)
        while True:
            answer = json.loads(self.socket.frame()[1])
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)


class Page(Remote):
    def value(self, expression):
        answer = self.do("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait(self, condition, seconds=15.0):
        end = time.monotonic() + seconds
        while not self.value(condition):
            if time.monotonic() > end:
                raise TimeoutError(f"{condition}; state {self.text('#state')}, {self.text('#notice')}")
            time.sleep(0.03)

    def text(self, selector):
        return self.value(f"document.querySelector({json.dumps(selector)})?.textContent")

    def press(self, key):
        self.do("Page.bringToFront")
        number = NAMED.get(key, ord(key.upper()) if len(key) == 1 else 0)
        names = {"key": key, "windowsVirtualKeyCode": number}
        text = {"text": key} if len(key) == 1 else {"text": "\r"} if key == "Enter" else {}
        self.do("Input.dispatchKeyEvent", type="keyDown", **names, **text)
        self.do("Input.dispatchKeyEvent", type="keyUp", **names)

    def write(self, words):
        self.do("Input.insertText", text=words)

    def click(self, selector):
        self.do("Page.bringToFront")
        place = self.value(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)}); e.scrollIntoView();"
            " const r = e.getBoundingClientRect();"
            " return [r.x + r.width / 2, r.y + r.height / 2]; })()")
        for kind in ("mousePressed", "mouseReleased"):
            self.do("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1],
                    button="left", clickCount=1)

    def give_file(self, selector, path):
        root = self.do("DOM.getDocument")["root"]["nodeId"]
        node = self.do("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.do("DOM.setFileInputFiles", nodeId=node, files=[str(path)])

    def picture(self, path):
        pathlib.Path(path).write_bytes(base64.b64decode(self.do("Page.captureScreenshot")["data"]))

    def requests(self):
        """Addresses that the page asked for."""
        return [event["params"]["request"]["url"] for event in self.events
                if event.get("method") == "Network.requestWillBeSent"]

    def complaints(self):
        return [event for event in self.events
                if event.get("method") in ("Runtime.exceptionThrown", "Log.entryAdded")]
