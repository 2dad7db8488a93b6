// SPDX-License-Identifier: BSD-3-Clause
// Light and dark: as the system has it, until the reader chooses.

const themeListeners = [];

/** Returns a colour or other value of the style sheet. */
function styleValue(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Returns the colour of the n-th curve. */
function seriesColour(number) {
  return styleValue(`--series-${number % 7}`);
}

/** Calls a function now and whenever the theme changes. */
function onTheme(listener) {
  themeListeners.push(listener);
  listener();
}

function tellTheme() {
  themeListeners.forEach((listener) => listener());
}

/** Lets the button change the theme; from then on the system does not. */
function startTheme(button) {
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  root.dataset.theme = dark.matches ? "dark" : "light";
  let chosen = false;
  dark.addEventListener("change", () => {
    if (chosen) return;
    root.dataset.theme = dark.matches ? "dark" : "light";
    tellTheme();
  });
  button.addEventListener("click", () => {
    chosen = true;
    root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark";
    tellTheme();
  });
}
