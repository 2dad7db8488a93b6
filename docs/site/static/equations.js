// SPDX-License-Identifier: BSD-3-Clause
// Typesets the equations of a page by KaTeX. What it cannot read is an error, which tests/program/site_test.py looks for.
"use strict";
document.addEventListener("DOMContentLoaded", () => {
  for (const element of document.querySelectorAll(".math")) {
    const text = element.textContent.trim().replace(/^\\[[(]|\\[\])]$/g, "");
    katex.render(text, element, { displayMode: element.tagName === "DIV", throwOnError: true });
  }
});
