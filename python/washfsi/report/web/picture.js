// SPDX-License-Identifier: BSD-3-Clause
// The playback alone, for a picture, in a page whose body is of the class "picture": nothing is seen until all is drawn.

/** Sets the playback as the page's address asks: #time=1.2&view=top&slice=none&height=0.2&colour=number. */
function setPlayback(playback, asked) {
  if (playback.height) {
    // a slice that can be moved: there is a flow, in space
    if (asked.has("slice")) playback.axis = asked.get("slice");
    if (asked.has("height")) playback.height.value = asked.get("height");
    playback.cut();
  }
  if (asked.has("colour") && playback.cloths) playback.cloths.by = asked.get("colour");
  playback.view.look(asked.get("view") ?? playback.view.from);
  if (asked.has("time")) playback.time = Number(asked.get("time"));
  playback.refresh();
}

/** Puts the playback at each of some times into the page, as the images of a movie. */
function addFrames({ playback }, times) {
  const { renderer, scene, camera } = playback.view;
  for (const time of times) {
    playback.time = time;
    playback.refresh();
    renderer.render(scene, camera);
    const src = renderer.domElement.toDataURL("image/jpeg", 0.95);
    document.body.append(element("img", { class: "frame", src, alt: playback.clock.textContent }));
  }
}

/** Shows nothing but the playback, as a still image: what is drawn in space is lost when the browser takes its time. */
async function showPicture(report, address) {
  const { view } = report.page.playback;
  view.resize();
  const asked = new URLSearchParams(address.slice(1));
  setPlayback(report.page.playback, asked);
  if (asked.has("times")) addFrames(report.page, asked.get("times").split(",").map(Number));
  view.renderer.render(view.scene, view.camera);
  const still = element("img", { src: view.renderer.domElement.toDataURL(), alt: "playback" });
  await still.decode();
  view.renderer.domElement.replaceWith(still);
  document.body.classList.add("done");
}
