// Moves the bodies of each drawing: every frame is a time and a matrix (x, y, c, s) for each body.
for (const drawing of document.querySelectorAll(".drawing")) {
  const { frames, readouts } = JSON.parse(drawing.querySelector("script").textContent);
  const bodies = [...drawing.querySelectorAll("[data-body]")];
  const marks = [...drawing.querySelectorAll("[data-mark]")];
  const [button, slider, speed] = ["button", "input", "select"].map((name) => drawing.querySelector(name));
  const clock = drawing.querySelector("[data-clock]");
  const values = [...drawing.querySelectorAll("[data-value]")];
  const [start, end] = [frames[0][0], frames[frames.length - 1][0]];
  let time = start, last = null, playing = false;

  const show = () => {
    const index = Math.round((time - start) / (end - start) * (frames.length - 1));
    const frame = frames[index];
    for (const element of bodies) {
      const [x, y, c, s] = frame.slice(1 + 4 * element.dataset.body, 5 + 4 * element.dataset.body);
      element.setAttribute("transform", `matrix(${c} ${-s} ${s} ${c} ${x} ${y})`);
    }
    // A mark sits at a point of one body and is turned like another.
    for (const element of marks) {
      const [body, u, v, turned] = element.dataset.mark.split(" ").map(Number);
      const [x, y, c, s] = body < 0 ? [0, 0, 1, 0] : frame.slice(1 + 4 * body, 5 + 4 * body);
      const [tc, ts] = turned < 0 ? [1, 0] : frame.slice(3 + 4 * turned, 5 + 4 * turned);
      element.setAttribute("transform", `matrix(${tc} ${-ts} ${ts} ${tc} ${x + c * u + s * v} ${y - s * u + c * v})`);
    }
    slider.value = index;
    clock.textContent = frame[0].toFixed(3);
    values.forEach((element, k) => { element.textContent = readouts[k][index]; });
  };
  const tick = (now) => {
    if (!playing) return;
    if (last !== null) {
      time += (now - last) / 1000 * speed.value;
      if (time > end) time = start;
      show();
    }
    last = now;
    requestAnimationFrame(tick);
  };
  const play = (on) => {
    playing = on;
    last = null;
    button.textContent = on ? "Pause" : "Play";
    if (on) requestAnimationFrame(tick);
  };
  button.addEventListener("click", () => play(!playing));
  slider.addEventListener("input", () => { play(false); time = frames[slider.value][0]; show(); });
  show();
  play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
}
