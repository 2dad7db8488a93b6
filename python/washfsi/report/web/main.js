// SPDX-License-Identifier: BSD-3-Clause
// The page: the comparison if there are several runs, then the run that is chosen.

/** What is shown of one run. */
class RunPage {
  constructor(run, arrays, scales) {
    this.charts = new TimeCharts((time) => this.playback.go(time));
    this.tracks = run.tracks ? new TracksChart(run, arrays) : null;
    this.playback = makePlayback(run, arrays, scales, (time) => this.showTime(time));
    this.element = element(
      "div",
      { id: "shown" },
      overviewSection(run),
      storySection(run),
      playbackSection(run, this.playback),
      cyclesSection(run) ?? "",
      curvesSection(run, arrays, this.charts) ?? "",
      this.tracks ? tracksSection(this.tracks) : "",
      trustSection(run) ?? "",
      figuresSection(run) ?? "",
      optionsSection(run),
    );
  }

  showTime(time) {
    this.charts.showTime(time);
    this.tracks?.showTime(time);
  }

  /** Draws what has to be in the page for it. */
  draw() {
    this.tracks?.draw();
    this.recolour();
  }

  recolour() {
    this.charts.recolour();
    this.tracks?.recolour();
    this.playback.recolour();
  }

  destroy() {
    this.charts.destroy();
    this.tracks?.chart.destroy();
    this.playback.destroy();
  }
}

/** Writes the list of contents. */
function listContents(list) {
  const sections = [...document.querySelectorAll("main section")];
  list.replaceChildren(
    ...sections.map((part) => element("a", { href: `#${part.id}` }, part.getAttribute("aria-label"))),
  );
}

/** The report. */
class Report {
  constructor(data, packs) {
    this.data = data;
    this.packs = packs;
    this.main = document.getElementById("main");
  }

  start() {
    const { runs, comparison } = this.data;
    document.getElementById("title").textContent = runs.length > 1 ? `${runs.length} runs` : runs[0].name;
    document.getElementById("subtitle").textContent = "washfsi: cloth and water in a washing machine";
    this.main.replaceChildren();
    if (comparison) {
      this.comparison = new Comparison(this.data, this.packs, (time) => this.page.playback.go(time));
      this.main.append(this.comparison.element);
      this.comparison.draw();
      this.offerRuns();
    }
    this.show(0);
    onTheme(() => {
      this.page.recolour();
      this.comparison?.recolour();
    });
  }

  /** Lets the reader choose a run. */
  offerRuns() {
    const select = document.getElementById("run");
    select.append(...this.data.runs.map((run, place) => element("option", { value: place }, run.name)));
    select.addEventListener("change", () => this.show(Number(select.value)));
    document.getElementById("chooser").hidden = false;
  }

  /** Shows a run. */
  show(place) {
    this.page?.destroy();
    this.page?.element.remove();
    this.page = new RunPage(this.data.runs[place], this.packs[place], this.data.scales);
    this.main.append(this.page.element);
    this.page.draw();
    listContents(document.getElementById("contents"));
  }
}

/** Reads the data in the page and shows it; `washfsiReport` resolves when all is there. */
async function startReport() {
  startTheme(document.getElementById("theme"));
  const data = JSON.parse(document.getElementById("data").textContent);
  const packs = await Promise.all(
    [...document.querySelectorAll("script.pack")].map((pack) => unpacked(pack.textContent)),
  );
  const report = new Report(data, packs);
  report.start();
  if (document.body.classList.contains("picture")) await showPicture(report, location.hash);
  return report;
}

window.washfsiReport = startReport();
