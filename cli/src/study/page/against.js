// One quantity against another: the way of a point of a coupler, what a pin carries at each angle of the crank. Two lengths are drawn to scale.
"use strict";
function against({ data, el, svg, figure, unit, ticks, between, cursors, stop, seek }) {
  const { times } = data;
  const quantities = [{ name: "time", unit: "s", values: times }];
  data.columns.forEach((column, index) => { if (column.group !== "residual") quantities.push({ ...column, values: data.values[index] }); });
  if (quantities.length < 3) return null;
  const [W, L, R, T, B] = [520, 58, 16, 12, 36];
  const isLength = ({ unit }) => ["m", "cm", "mm"].includes(unit);

  // What is asked most: a place in the plane if there is one, else the first two outputs.
  function first() {
    for (let k = 1; k + 1 < quantities.length; k++) {
      const [a, b] = [quantities[k], quantities[k + 1]];
      if (a.group === "outputs" && b.group === "outputs" && isLength(a) && a.unit === b.unit) return [k, k + 1];
    }
    return [1, 2];
  }
  const chosen = first();
  const box = el("figure", { class: "plot against" }), head = el("header"), value = el("span"), place = el("div");
  const selects = ["x", "y"].map((axis, which) => {
    const select = el("select", { id: `against_${axis}`, "aria-label": `${axis} of the plot` });
    quantities.forEach(({ name, unit: of }, index) => select.append(el("option", { value: index }, name === "time" ? "time" : `${name}, ${unit(of)}`)));
    select.value = chosen[which];
    select.addEventListener("change", () => { chosen[which] = Number(select.value); draw(); show(now); });
    return select;
  });
  const choice = el("div", { class: "choice" });
  choice.append(selects[1], el("span", {}, "against"), selects[0]);
  head.append(value);
  box.append(choice, head, place);

  const range = (values) => {
    const finite = values.filter(Number.isFinite);
    let [least, most] = finite.length ? [Math.min(...finite), Math.max(...finite)] : [0, 1];
    const by = most - least <= 1e-9 * Math.max(Math.abs(most), Math.abs(least), 1e-12) ? Math.max(0.05 * Math.abs(most), 1e-6) : 0.06 * (most - least);
    return [least - by, most + by];
  };
  let now = times[0], spot, places;
  function draw() {
    const [x, y] = chosen.map((index) => quantities[index]);
    let [[left, right], [low, high]] = [range(x.values), range(y.values)];
    let height = 200;
    if (isLength(x) && x.unit === y.unit) {
      // To scale: the taller of two pictures that would be too tall gets room at its sides.
      const wanted = ((high - low) / (right - left)) * (W - L - R);
      height = Math.min(380, Math.max(120, wanted));
      const scale = Math.max((right - left) / (W - L - R), (high - low) / height);
      const widen = (a, b, length) => { const rest = (scale * length - (b - a)) / 2; return [a - rest, b + rest]; };
      [[left, right], [low, high]] = [widen(left, right, W - L - R), widen(low, high, height)];
    }
    const H = T + height + B;
    const across = (value) => L + ((W - L - R) * (value - left)) / (right - left);
    const upward = (value) => T + (height * (high - value)) / (high - low);
    const picture = svg("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": `${y.name} against ${x.name}` });
    ticks(low, high, height > 160 ? 4 : 2).forEach((mark) => {
      picture.append(svg("line", { x1: L, x2: W - R, y1: upward(mark), y2: upward(mark), stroke: "var(--grid)" }));
      picture.append(svg("text", { x: L - 6, y: upward(mark) + 4, "text-anchor": "end" }, figure(mark, 3)));
    });
    ticks(left, right, 4).forEach((mark) => {
      picture.append(svg("line", { x1: across(mark), x2: across(mark), y1: T, y2: T + height, stroke: "var(--grid)" }));
      picture.append(svg("text", { x: across(mark), y: T + height + 14, "text-anchor": "middle" }, figure(mark, 3)));
    });
    picture.append(svg("text", { x: (L + W - R) / 2, y: H - 6, "text-anchor": "middle" }, `${x.name}, ${unit(x.unit)}`));
    places = times.map((_, k) => [across(x.values[k]), upward(y.values[k])]);
    let path = "", isDown = false;
    places.forEach(([a, b]) => {
      const isKnown = Number.isFinite(a) && Number.isFinite(b);
      if (isKnown) path += `${isDown ? "L" : "M"}${a.toFixed(1)} ${b.toFixed(1)}`;
      isDown = isKnown;
    });
    picture.append(svg("path", { d: path, fill: "none", stroke: "var(--accent)", "stroke-width": 1.6, "stroke-linejoin": "round" }));
    spot = svg("circle", { r: 4, fill: "var(--accent)", stroke: "var(--paper)" });
    picture.append(spot);
    // The sample that is nearest to where one points.
    const nearest = (event) => {
      const area = picture.getBoundingClientRect();
      const at = [((event.clientX - area.left) / area.width) * W, ((event.clientY - area.top) / area.height) * H];
      let best = 0, least = Infinity;
      places.forEach(([a, b], k) => {
        const square = (a - at[0]) ** 2 + (b - at[1]) ** 2;
        if (square < least) [best, least] = [k, square];
      });
      return times[best];
    };
    picture.addEventListener("pointerdown", (event) => { stop(); seek(nearest(event)); });
    picture.addEventListener("pointermove", (event) => { if (event.buttons) { stop(); seek(nearest(event)); } else tell(nearest(event)); });
    picture.addEventListener("pointerleave", () => tell(now));
    place.replaceChildren(picture);
  }
  const at = (values, time) => { const [a, b, share] = between(time); return values[a] + (values[b] - values[a]) * share; };
  function tell(time) {
    const [x, y] = chosen.map((index) => quantities[index]);
    const text = ({ values, unit: of }) => `${figure(at(values, time))} ${unit(of)}`;
    value.textContent = `${text(y)} at ${text(x)}${x.name === "time" ? "" : `, ${figure(time, 4)} s`}`;
  }
  function show(time) {
    now = time;
    const [a, b, share] = between(time);
    const here = [0, 1].map((k) => places[a][k] + (places[b][k] - places[a][k]) * share);
    const isKnown = here.every(Number.isFinite);
    spot.setAttribute("cx", isKnown ? here[0] : -9);
    spot.setAttribute("cy", isKnown ? here[1] : -9);
    tell(time);
  }
  draw();
  cursors.push(show);
  return { box, isWay: chosen.every((index) => isLength(quantities[index])) };
}

