// SPDX-License-Identifier: BSD-3-Clause
// The playback alone, for a picture, in a page whose body is of the class "picture": nothing is seen until all is drawn.

/** Sets the playback as the page's address asks: #time=1.2&view=top&slice=none&height=0.2&colour=number. */
function setPlayback(playback, asked) {
  if (asked.has("slice")) playback.axis = asked.get("slice");
  if (asked.has("height")) playback.height.value = asked.get("height");
  if (playback.slice && playback.axis) playback.cut();
  if (asked.has("colour")) playback.cloths.by = asked.get("colour");
  if (asked.has("view")) playback.view.look(asked.get("view"));
  if (asked.has("time")) playback.time = Number(asked.get("time"));
  playback.refresh();
}

/** Shows nothing but the playback, as a still image: what is drawn in space is lost when the browser takes its time. */
async function showPicture(report, address) {
  const { view } = report.page.playback;
  view.resize();
  setPlayback(report.page.playback, new URLSearchParams(address.slice(1)));
  view.renderer.render(view.scene, view.camera);
  const still = element("img", { src: view.renderer.domElement.toDataURL(), alt: "playback" });
  await still.decode();
  view.renderer.domElement.replaceWith(still);
  document.body.classList.add("done");
}
