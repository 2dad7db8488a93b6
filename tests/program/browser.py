#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A headless browser for tests of pages: Debian's chromium and chromium-driver, steered by python3-selenium.

By itself it opens a report a few times, tells seconds and errors, and takes a picture of every section:

    tests/program/browser.py out/report.html [FOLDER]
"""

import io
import pathlib
import shutil
import sys
import time

import numpy as np
from matplotlib.image import imread

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None

DRIVER = shutil.which("chromedriver")
MISSING = ("no browser to test in: install Debian's chromium, chromium-driver and python3-selenium "
           "(scripts/install-dependencies --browser)")
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--use-gl=angle",
         "--use-angle=swiftshader-webgl"]  # WebGL by the processor, also on a machine without graphics
WAIT = "const done = arguments[arguments.length - 1];"


def there():
    """Returns whether there is a browser."""
    return bool(webdriver and DRIVER and shutil.which("chromium"))


class Browser:
    """A browser with one page."""

    def __init__(self, width=900, height=640):
        options = webdriver.ChromeOptions()
        for flag in FLAGS:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.resize(width, height)

    def resize(self, width, height=640):
        """Takes a width of the window [px]; below 600 it is a telephone."""
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})

    def prefer(self, scheme):
        """Makes the system light or dark."""
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": scheme}]})

    def open(self, path):
        """Opens a report and waits until all is there; returns the seconds."""
        begun = time.monotonic()
        self.driver.get(f"file://{path}")
        said = self.driver.execute_async_script(
            f"{WAIT} washfsiReport.then(() => requestAnimationFrame(() => done('')), (error) => done(String(error.stack)))")
        if said:
            raise AssertionError(said)
        return time.monotonic() - begun

    def run(self, code, *arguments):
        """Runs code in the page, where `report` is the report; returns what it returns."""
        return self.driver.execute_async_script(
            f"{WAIT} washfsiReport.then((report) => done((function (...given) {{ {code} }})(...arguments)))", *arguments)

    def errors(self):
        """Returns the errors on the console since last asked."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def picture(self, selector):
        """Returns the picture of an element, as rows of pixels."""
        self.run("document.querySelector(given[0]).scrollIntoView({block: 'center'});", selector)
        self.driver.execute_async_script(f"{WAIT} requestAnimationFrame(() => requestAnimationFrame(done));")
        element = self.driver.find_element("css selector", selector)
        return np.rint(255 * imread(io.BytesIO(element.screenshot_as_png))[..., :3]).astype(int)

    def set(self, selector, value, event="input"):
        """Sets a slider or a choice as a reader would."""
        self.run("const one = document.querySelector(given[0]); one.value = given[1];"
                 "one.dispatchEvent(new Event(given[2], {bubbles: true}));", selector, value, event)

    def close(self):
        self.driver.quit()


def look_at(path, folder):
    """Opens a report, tells how long that takes, and takes pictures of its sections."""
    browser = Browser(1280, 900)
    print("seconds to open:", *(f"{browser.open(path):.2f}" for _ in range(4)), "errors:", browser.errors() or "none")
    for name in browser.run("return [...document.querySelectorAll('main section')].map((part) => part.id);"):
        browser.run("document.getElementById(given[0]).scrollIntoView();", name)
        time.sleep(0.5)
        browser.driver.save_screenshot(str(folder / f"{name}.png"))
    browser.close()


if __name__ == "__main__":
    look_at(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path((sys.argv[2:] or ["."])[0]))
