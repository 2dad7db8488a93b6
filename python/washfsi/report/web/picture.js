// SPDX-License-Identifier: BSD-3-Clause
// The playback alone, for a picture: the page's address ends with #picture, or #picture&time=1.2&view=top&slice=none.

/** Shows nothing but the playback, as the address asks. */
function showPicture(report, address) {
  const asked = new URLSearchParams(address.slice(1));
  const { playback } = report.page;
  document.body.classList.add("picture");
  playback.view.resize();
  if (asked.has("slice")) playback.element.querySelector("#slice").value = playback.axis = asked.get("slice");
  if (asked.has("height")) playback.height.value = asked.get("height");
  if (playback.slice && playback.axis) playback.cut();
  if (asked.has("colour")) playback.cloths.by = asked.get("colour");
  if (asked.has("view")) playback.view.look(asked.get("view"));
  if (asked.has("time")) playback.time = Number(asked.get("time"));
  playback.refresh();
}
