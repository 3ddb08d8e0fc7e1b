#!/usr/bin/env python3
"""The page of `kerfline serve` in a browser: it runs a job, by mouse and by keyboard.

    page_test.py KERFLINE CHROMIUM EXAMPLES PICTURES
"""
import pathlib
import subprocess
import sys
import unittest

from browser import Browser
from web_client import http

KERFLINE = CHROMIUM = ""
EXAMPLES = PICTURES = pathlib.Path()
FROM_SCRATCH = "document.querySelector('#state').textContent === 'Idle'"


def state_is(name):
    return f"document.querySelector('#state').textContent.startsWith({name!r})"


def x_of(page):
    return float(page.text("#places tr td:nth-child(3)"))


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(CHROMIUM)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.served = subprocess.Popen(
            [KERFLINE, "serve", "--ws", "0", "--settings", str(EXAMPLES / "laser.settings")],
            stdout=subprocess.PIPE, text=True)
        lines = {}
        for line in self.served.stdout:
            kind, _, lines[kind] = line.strip().partition(" ")
            if kind.strip() == "ready":
                break
        self.address = lines["page"]
        self.addCleanup(self.end)

    def end(self):
        self.served.terminate()
        self.served.wait(20)
        self.served.stdout.close()

    def open(self):
        page = self.browser.open(self.address)
        page.wait(FROM_SCRATCH)
        return page

    def take_control(self, page):
        page.click("#control")
        page.wait("document.querySelector('#who').textContent.startsWith('You')")

    def test_runs_a_job_by_mouse(self):
        page = self.open()
        self.take_control(page)
        page.give_file("#file", EXAMPLES / "circle_r20.nc")
        page.wait("!document.querySelector('#run').disabled")
        page.click("#run")
        page.wait(state_is("Run"))
        page.wait("document.querySelector('#power').textContent !== '0'")
        before = page.text("#places")
        page.wait(f"document.querySelector('#places').textContent !== {before!r}")
        page.click("#hold")
        page.wait(state_is("Hold"))
        page.wait("document.querySelector('#power').textContent === '0'")
        page.picture(PICTURES / "page_hold.png")
        page.click("#resume")
        page.wait(state_is("Run"))
        page.wait("document.querySelector('#progress').value === 1", 60)
        page.wait(FROM_SCRATCH, 60)
        page.picture(PICTURES / "page_done.png")
        self.assertTrue(page.value("document.querySelector('#notice').hidden"), page.text("#notice"))
        self.assertEqual([], page.complaints())
        for address in page.requests():
            self.assertTrue(address.startswith(self.address), address)

    def test_is_operated_by_keyboard_alone(self):
        page = self.open()
        page.press("c")
        page.wait("document.querySelector('#who').textContent.startsWith('You')")
        page.press("ArrowRight")
        page.wait(state_is("Jog"))
        page.wait(FROM_SCRATCH)
        self.assertAlmostEqual(x_of(page), 10.0, delta=0.01)
        page.press("]")
        page.wait("document.querySelector('#feed-percent').textContent === '110 %'")
        page.press("/")
        page.write("G1 X100 F2000")
        page.press("Enter")
        page.wait(state_is("Run"))
        page.press("Escape")  # Out of the console.
        page.press(" ")
        page.wait(state_is("Hold"))
        page.press(" ")
        page.wait(state_is("Run"))
        page.press("x")
        page.wait(state_is("Alarm"))
        self.assertLess(x_of(page), 100.0)
        page.press("u")
        page.wait(FROM_SCRATCH)
        page.press("c")
        page.wait("document.querySelector('#who').textContent.startsWith('Nobody')")

    def test_a_second_page_watches_and_is_told_why_it_may_not_more(self):
        first, second = self.open(), self.open()
        self.take_control(first)
        second.click("#control")
        second.wait("!document.querySelector('#notice').hidden")
        self.assertIn("Another sender", second.text("#notice"))
        self.assertTrue(second.value("document.querySelector('#reset').disabled"))
        first.press("ArrowUp")
        second.wait("document.querySelectorAll('#places td')[6].textContent === '10.000'")
        second.picture(PICTURES / "page_watching.png")
        first.press("c")
        second.wait("document.querySelector('#who').textContent.startsWith('Nobody')")
        second.click("#control")
        second.wait("document.querySelector('#who').textContent.startsWith('You')")

    def test_a_wrong_host_gets_nothing(self):
        port = int(self.address.rstrip("/").rsplit(":", 1)[1])
        self.assertEqual(http(port, host=f"evil.example:{port}")[0], 403)


if __name__ == "__main__":
    KERFLINE, CHROMIUM = sys.argv[1:3]
    EXAMPLES, PICTURES = (pathlib.Path(name).resolve() for name in sys.argv[3:5])
    del sys.argv[1:5]
    unittest.main()
