// The motion of a mechanism, with plots that share its cursor. Everything is in the page; nothing is fetched.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const { times, bodies, planar } = data;
  const last = times.length - 1;
  const duration = Math.max(times[last] - times[0], 1e-12);
  const numbers = planar ? 4 : 12;
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const el = (name, attributes = {}, text) => {
    const made = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const $ = (id) => document.getElementById(id);

  // ---- numbers ------------------------------------------------------------------------------------------------
  const raised = (power) => [...String(power)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("");
  function figure(value, digits = 4) {
    if (!Number.isFinite(value)) return "–";
    if (value === 0) return "0";
    const power = Math.floor(Math.log10(Math.abs(value)));
    if (power < -3 || power > 5) return `${figure(value / 10 ** power, digits)}·10${raised(power)}`;
    const text = Number(value.toPrecision(digits)).toString();
    return text.replace("-", "−");
  }
  const unit = (text) => text.replaceAll("*", "·").replaceAll("^2", "²").replaceAll("^3", "³");

  // ---- where everything is ------------------------------------------------------------------------------------
  // The frame before a time, and how far beyond it: a pose between two samples is on the straight line between them.
  function between(time) {
    let low = 0, high = last;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle; else high = middle;
    }
    const span = times[high] - times[low];
    return [low, high, span > 0 ? Math.min(1, Math.max(0, (time - times[low]) / span)) : 0];
  }
  let pose = new Float64Array(bodies.length * numbers + data.modes);
  function stand(time) {
    const [a, b, share] = between(time);
    const [from, to] = [data.poses[a], data.poses[b]];
    for (let k = 0; k < pose.length; k++) pose[k] = from[k] + (to[k] - from[k]) * share;
  }
  function turned(body, x, y, z) {
    if (body < 0) return [x, y, z];
    const p = body * numbers;
    if (planar) {
      const [c, s] = [pose[p + 2], pose[p + 3]];
      return [c * x - s * y, s * x + c * y, z];
    }
    const r = (k) => pose[p + 3 + 3 * k] * x + pose[p + 4 + 3 * k] * y + pose[p + 5 + 3 * k] * z;
    return [r(0), r(1), r(2)];
  }
  // A station of the lines of what deforms, as the modes bend them.
  function bent(body, station) {
    const { lines } = bodies[body], at = [...lines.stations[station]];
    lines.bendings.forEach(({ modes, along, factors }) => {
      at[along] += modes.reduce((product, mode) => product * pose[bodies.length * numbers + mode], factors[station]);
    });
    return at;
  }
  function place([body, x, y, z, station]) {
    const d = turned(body, ...(station === undefined ? [x, y, z] : bent(body, station)));
    if (body < 0) return d;
    const p = body * numbers;
    return [pose[p] + d[0], pose[p + 1] + d[1], planar ? d[2] : pose[p + 2] + d[2]];
  }
  const center = (body) => place([body, 0, 0, 0]);
  const each = (body) => {
    const { lines, spots } = bodies[body];
    if (!lines) return spots.map((spot) => place([body, ...spot]));
    return [...Array(lines.counts.reduce((sum, count) => sum + count)).keys()].map((k) => place([body, 0, 0, 0, k]));
  };
  // What leaves a trace: all that acts, or where lines begin and end.
  const ends = (body) => {
    const all = each(body);
    return bodies[body].lines ? [all[0], all[all.length - 1]] : all.length ? all : [center(body)];
  };

  // ---- the eye ------------------------------------------------------------------------------------------------
  const canvas = $("stage"), pen = canvas.getContext("2d");
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const size = (a) => Math.hypot(...a);
  const times3 = (k, a) => a.map((x) => k * x);
  const plus = (a, b) => a.map((x, k) => x + b[k]);
  const minus = (a, b) => a.map((x, k) => x - b[k]);
  const home = { azimuth: -1.01, height: 0.44, zoom: 1, shift: [0, 0] };
  let eye = structuredClone(home);
  const up = data.up;
  const level = (() => {
    const first = Math.abs(up[0]) > 0.5 ? [0, 1, 0] : [1, 0, 0];
    const a = planar ? [1, 0, 0] : first;
    return [a, cross(up, a)];
  })();
  const all = { middle: [0, 0, 0], reach: 1 };
  (() => {
    const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
    const take = (at) => at.forEach((x, k) => { least[k] = Math.min(least[k], x); most[k] = Math.max(most[k], x); });
    const stride = Math.max(1, Math.floor(times.length / 120));
    for (let k = 0; k <= last; k += stride) {
      pose.set(data.poses[k]);
      bodies.forEach((body, index) => {
        each(index).forEach(take);
        const at = center(index);
        take(at);
        const r = body.outline === "box" ? Math.hypot(...body.lengths) / 2 : /bar|lines/.test(body.outline) ? 0 : body.lengths[0];
        if (r) [0, 1, 2].forEach((axis) => [-r, r].forEach((d) => take(at.map((x, j) => (j === axis && !(planar && j === 2) ? x + d : x)))));
      });
      data.surfaces.forEach((surface) => surface.lines.forEach((points) => points.forEach((at) => take(place(at)))));
      data.joints.forEach((joint) => take(place(joint.second)));
      data.loads.forEach((load) => load.ends.forEach((end) => take(place(end))));
    }
    if (most[0] >= least[0]) {
      all.middle = least.map((x, k) => (x + most[k]) / 2);
      all.box = most.map((x, k) => x - least[k]);
      all.reach = Math.max(1e-9, 0.56 * Math.max(...all.box), 0.4 * size(all.box));
    }
  })();
  let view;
  function look() {
    const ratio = Math.min(3, window.devicePixelRatio || 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    let right, rise, toward;
    if (planar) {
      [right, rise, toward] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    } else {
      const [a, b] = level;
      const [c, s] = [Math.cos(eye.azimuth), Math.sin(eye.azimuth)];
      const [ch, sh] = [Math.cos(eye.height), Math.sin(eye.height)];
      const out = plus(times3(c, a), times3(s, b));
      toward = plus(times3(ch, out), times3(sh, up));
      right = cross(up, out);
      rise = cross(toward, right);
    }
    const margin = 46;
    const fit = planar && all.box
      ? Math.min((width - 2 * margin) / Math.max(all.box[0], 1e-9), (height - 2 * margin) / Math.max(all.box[1], 1e-9))
      : (Math.min(width, height) / 2 - margin * 0.6) / all.reach;
    const scale = Math.max(1e-9, Math.min(fit, 1e9)) * eye.zoom;
    view = { width, height, ratio, right, rise, toward, scale, unit: Math.max(2.2, Math.min(5, Math.min(width, height) / 110)) };
  }
  const spot = (at) => {
    const d = minus(at, all.middle);
    return [view.width / 2 + eye.shift[0] + view.scale * dot(view.right, d), view.height / 2 + eye.shift[1] - view.scale * dot(view.rise, d)];
  };
  const depth = (at) => dot(view.toward, at);

  // ---- shapes -------------------------------------------------------------------------------------------------
  function hull(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    if (sorted.length < 3) return sorted;
    const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    const half = (list) => {
      const kept = [];
      for (const p of list) {
        while (kept.length > 1 && turn(kept[kept.length - 2], kept[kept.length - 1], p) <= 0) kept.pop();
        kept.push(p);
      }
      kept.pop();
      return kept;
    };
    return [...half(sorted), ...half(sorted.reverse())];
  }
  function trace(points, closed) {
    pen.beginPath();
    points.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    if (closed) pen.closePath();
  }
  let ink = {};
  const hue = (index) => ink[`series${index % 6}`];
  function plate(points, width, colour, closed = points.length > 2) {
    trace(points, closed);
    pen.lineJoin = pen.lineCap = "round";
    pen.strokeStyle = ink.ink;
    pen.lineWidth = width + 2;
    pen.stroke();
    pen.strokeStyle = pen.fillStyle = ink.paper;
    pen.lineWidth = width;
    pen.stroke();
    if (closed) pen.fill();
    pen.globalAlpha = 0.3;
    pen.strokeStyle = pen.fillStyle = colour;
    if (closed) {
      pen.fill();
    } else {
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }
  function filled(points, colour) {
    trace(points, true);
    pen.fillStyle = ink.paper;
    pen.fill();
    pen.globalAlpha = 0.16;
    pen.fillStyle = colour;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = ink.ink;
    pen.lineWidth = 1.3;
    pen.stroke();
  }
  function round(at, radius, fill, line = 1.4) {
    pen.beginPath();
    pen.arc(at[0], at[1], radius, 0, 2 * Math.PI);
    pen.fillStyle = fill;
    pen.fill();
    pen.strokeStyle = ink.ink;
    pen.lineWidth = line;
    if (line) pen.stroke();
  }
  function line(points, colour, width = 1.3, dash = []) {
    trace(points, false);
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.setLineDash(dash);
    pen.stroke();
    pen.setLineDash([]);
  }
  function arrow(from, to, colour) {
    const way = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(...way);
    if (length < 3) return;
    const e = way.map((x) => x / length), n = [-e[1], e[0]];
    const back = (a, b) => [to[0] - a * e[0] + b * n[0], to[1] - a * e[1] + b * n[1]];
    line([from, back(5, 0)], colour, 1.5);
    trace([to, back(8, 3), back(8, -3)], true);
    pen.fillStyle = colour;
    pen.fill();
  }
  function ring(at, about, radius) {
    const first = Math.abs(about[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const u = cross(about, first), a = times3(1 / size(u), u), b = times3(1 / Math.max(size(about), 1e-9), cross(about, a));
    return Array.from({ length: 49 }, (_, k) => {
      const [c, s] = [Math.cos((k * Math.PI) / 24), Math.sin((k * Math.PI) / 24)];
      return spot(plus(at, plus(times3(radius * c, a), times3(radius * s, b))));
    });
  }
  // Stretches of a picture with what they hide: the nearer one is drawn later.
  function parts() {
    const list = [];
    const add = (layer, near, draw) => list.push({ layer: planar ? layer : 1, near: planar ? 0 : near, draw });
    bodies.forEach((body, index) => {
      const at = center(index), colour = hue(index), spots = each(index);
      if (body.outline === "disk") {
        const axis = turned(index, 0, 0, 1), rim = turned(index, body.lengths[0], 0, 0);
        add(0, depth(at), () => { filled(ring(at, axis, body.lengths[0]), colour); line([spot(at), spot(plus(at, rim))], ink.ink, 1); });
      } else if (body.outline === "ball") {
        add(0, depth(at), () => filled(ring(at, view.toward, body.lengths[0]), colour));
      } else if (body.outline === "box") {
        const [a, b, c = 0] = body.lengths.map((x) => x / 2);
        const corner = [...Array(8).keys()].map((k) => plus(at, turned(index, k & 1 ? a : -a, k & 2 ? b : -b, k & 4 ? c : -c)));
        add(0, depth(at), () => {
          filled(hull(corner.map(spot)), colour);
          if (!planar) {
            for (let k = 0; k < 8; k++) [1, 2, 4].forEach((bit) => { if (!(k & bit)) line([spot(corner[k]), spot(corner[k | bit])], ink.faint, 0.8); });
          }
        });
      }
      if (body.lines) {
        let first = 0;
        body.lines.counts.forEach((count) => {
          const bent = spots.slice(first, first + count).map(spot);
          const ends = [first, first + count - 1].map((k) => spot(place([index, ...body.lines.stations[k]])));
          if (data.magnified) add(0, depth(at), () => line(ends, ink.muted, 1, [9, 3, 2, 3]));
          add(2, depth(at), () => plate(bent, 1.9 * view.unit, colour, false));
          first += count;
        });
      }
      const from = body.outline === "bar" ? (spots.length > 1 ? spots : [...spots, at]) : [];
      const corners = hull(from.map(spot));
      const wide = corners.length > 1 && Math.max(...corners.map((p) => Math.hypot(p[0] - corners[0][0], p[1] - corners[0][1]))) > 2;
      if (wide) {
        const near = from.reduce((sum, p) => sum + depth(p), 0) / from.length;
        add(2, near, () => plate(corners, 1.9 * view.unit, colour));
      } else if (body.outline === "bar") {
        add(2, depth(at), () => round(spot(at), 1.9 * view.unit, colour));
      }
    });
    data.surfaces.forEach((surface) => surface.lines.forEach((points) => {
      const at = points.map(place);
      add(-1, depth(at[0]), () => line(at.map(spot), ink.muted, 1.2));
    }));
    data.wheels.forEach((wheel) => add(1, depth(place(wheel.center)), () => line(ring(place(wheel.center), turned(wheel.center[0], ...wheel.about), wheel.radius), ink.muted, 1, [9, 3, 2, 3])));
    data.joints.forEach((joint) => joints(joint, add));
    data.loads.forEach((load) => loads(load, add));
    return list.sort((a, b) => a.layer - b.layer || a.near - b.near);
  }
  function ground(at) {
    const u = view.unit, [x, y] = at;
    trace([at, [x - 2 * u, y + 3.4 * u], [x + 2 * u, y + 3.4 * u]], true);
    pen.fillStyle = ink.paper;
    pen.fill();
    pen.strokeStyle = ink.muted;
    pen.lineWidth = 1.3;
    pen.stroke();
    line([[x - 3.2 * u, y + 3.4 * u], [x + 3.2 * u, y + 3.4 * u]], ink.muted, 1.5);
    for (let k = -3; k < 3; k++) line([[x + (k + 1) * u, y + 3.4 * u], [x + k * u, y + 4.8 * u]], ink.muted, 0.8);
  }
  function joints(joint, add) {
    const [first, second] = [place(joint.first), place(joint.second)], u = view.unit;
    const grounded = joint.first[0] < 0 || joint.second[0] < 0;
    const axis = turned(joint.first[0], ...joint.axis);
    if (joint.slides) {
      const way = [spot(plus(second, axis)), spot(second)];
      const e = [way[0][0] - way[1][0], way[0][1] - way[1][1]], length = Math.hypot(...e) || 1;
      const [c, s] = e.map((x) => x / length);
      const reach = grounded ? all.reach : 0;
      if (grounded) add(0, depth(second) - 1e3, () => line([spot(plus(first, times3(-1.2 * reach / size(axis), axis))), spot(plus(first, times3(1.2 * reach / size(axis), axis)))], ink.faint, 1.5));
      add(3, depth(second) + 1e-6, () => {
        const p = spot(second), at = (x, y) => [p[0] + c * x - s * y, p[1] + s * x + c * y];
        trace([at(-3 * u, -1.8 * u), at(3 * u, -1.8 * u), at(3 * u, 1.8 * u), at(-3 * u, 1.8 * u)], true);
        pen.fillStyle = ink.paper;
        pen.fill();
        pen.strokeStyle = ink.ink;
        pen.lineWidth = 1.4;
        pen.stroke();
      });
      return;
    }
    if (size(minus(first, second)) * view.scale > 3) add(3, depth(second), () => line([spot(first), spot(second)], ink.ink, 1.2));
    if (grounded) add(1, depth(second) - 1e-3 * all.reach, () => ground(spot(joint.first[0] < 0 ? first : second)));
    add(4, depth(second) + 1e-2 * all.reach, () => {
      if (!planar && size(axis) > 0 && !/spherical|ball/.test(joint.kind)) {
        const tip = times3((2.4 * u) / view.scale / size(axis), axis);
        line([spot(minus(second, tip)), spot(plus(second, tip))], ink.ink, 1.9 * u);
        line([spot(minus(second, times3(0.86, tip))), spot(plus(second, times3(0.86, tip)))], ink.paper, 1.9 * u - 2.4);
      } else {
        round(spot(second), u, ink.paper, 1.5);
      }
    });
  }
  function loads(load, add) {
    const ends = load.ends.map(place), u = view.unit;
    if (!ends.length) return;
    const near = ends.reduce((sum, p) => sum + depth(p), 0) / ends.length;
    if (ends.length === 1) {
      if (/torque|torsion/.test(load.kind)) {
        add(5, near + 1, () => {
          const p = spot(ends[0]), r = 4.2 * u;
          pen.beginPath();
          pen.arc(p[0], p[1], r, -2.8, 0.6);
          pen.strokeStyle = ink.load;
          pen.lineWidth = 1.5;
          pen.stroke();
          const tip = [p[0] + r * Math.cos(0.6), p[1] + r * Math.sin(0.6)];
          arrow([tip[0] + 6 * Math.sin(0.6) * 0.8, tip[1] - 6 * Math.cos(0.6)], [tip[0] - 3 * Math.sin(0.6), tip[1] + 3 * Math.cos(0.6)], ink.load);
        });
      } else {
        add(5, near + 1, () => round(spot(ends[0]), 0.8 * u, ink.load, 0));
      }
      return;
    }
    add(5, near + 1, () => {
      const points = ends.map(spot);
      if (!/spring|damper|bushing/.test(load.kind) || points.length > 2) return line(points, ink.load, 1.4, /cable/.test(load.kind) ? [] : [4, 3]);
      const [a, b] = points, way = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(...way);
      if (length < 4) return;
      const e = way.map((x) => x / length), n = [-e[1], e[0]];
      const at = (share, aside) => [a[0] + share * way[0] + aside * n[0], a[1] + share * way[1] + aside * n[1]];
      if (/damper/.test(load.kind)) {
        line([a, at(0.4, 0)], ink.load);
        line([at(0.7, -1.3 * u), at(0.4, -1.3 * u), at(0.4, 1.3 * u), at(0.7, 1.3 * u)], ink.load);
        line([at(0.55, -u), at(0.55, u)], ink.load, 1.8);
        line([at(0.55, 0), b], ink.load);
        return;
      }
      // As many turns at any length, so that the spring is seen to stretch.
      const path = [a, at(0.1, 0)];
      for (let k = 1; k < 20; k++) path.push(at(0.1 + (0.8 * k) / 20, (k % 2 ? 1.5 : -1.5) * u));
      line([...path, at(0.9, 0), b], ink.load);
    });
  }

  // ---- the picture --------------------------------------------------------------------------------------------
  let now = times[0];
  const shown = (id) => $(id).checked;
  const traced = () => {
    // The corners of each body, from sample to sample.
    const stride = Math.max(1, Math.floor(times.length / 400));
    bodies.forEach((_, index) => {
      const paths = [];
      for (let k = 0; k <= last; k += stride) {
        pose.set(data.poses[k]);
        ends(index).forEach((at, which) => (paths[which] ||= []).push(spot(at)));
      }
      pen.globalAlpha = 0.55;
      paths.forEach((path) => line(path, hue(index), 1.1));
      pen.globalAlpha = 1;
    });
  };
  function names() {
    const taken = [];
    pen.font = "12px system-ui, sans-serif";
    bodies.forEach((body, index) => {
      const at = spot(center(index)), width = pen.measureText(body.name).width;
      const free = [[8, -10], [8, 18], [-width - 8, -10], [-width - 8, 18], [-width / 2, -18], [-width / 2, 26]]
        .map(([x, y]) => [at[0] + x, at[1] + y - 10, width, 13])
        .find((a) => !taken.some((b) => a[0] < b[0] + b[2] + 3 && b[0] < a[0] + a[2] + 3 && a[1] < b[1] + b[3] && b[1] < a[1] + a[3]));
      if (!free) return;
      taken.push(free);
      pen.lineWidth = 3.5;
      pen.strokeStyle = ink.paper;
      pen.lineJoin = "round";
      pen.strokeText(body.name, free[0], free[1] + 10);
      pen.fillStyle = ink.ink;
      pen.fillText(body.name, free[0], free[1] + 10);
    });
  }
  function velocities() {
    // Of the centres, from the samples beside; the longest of the run is a fifth of the picture.
    const [a, b] = between(now), span = times[b] - times[a] || 1;
    const at = (k, index) => { pose.set(data.poses[k]); return center(index); };
    bodies.forEach((_, index) => {
      const v = times3(1 / span, minus(at(b, index), at(a, index)));
      stand(now);
      const from = center(index);
      arrow(spot(from), spot(plus(from, times3((0.4 * all.reach) / fastest, v))), ink.accent);
    });
  }
  const fastest = (() => {
    let most = 1e-12;
    for (let k = 1; k <= last; k++) {
      for (let body = 0; body < bodies.length; body++) {
        const p = body * numbers, d = [0, 1, planar ? 1 : 2].map((j) => data.poses[k][p + j] - data.poses[k - 1][p + j]);
        most = Math.max(most, Math.hypot(...d) / Math.max(times[k] - times[k - 1], 1e-12));
      }
    }
    return most;
  })();
  function colours() {
    ["paper", "ink", "muted", "faint", "grid", "accent", "load"].forEach((name) => { ink[name] = css(`--${name}`); });
    for (let k = 0; k < 6; k++) ink[`series${k}`] = css(`--series-${k}`);
  }
  function draw() {
    look();
    pen.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
    pen.clearRect(0, 0, view.width, view.height);
    if (shown("traces")) traced();
    stand(now);
    parts().forEach((part) => part.draw());
    if (shown("velocities")) velocities();
    stand(now);
    if (shown("names")) names();
    axes();
  }
  function axes() {
    const corner = [26, view.height - 22];
    ["x", "y", "z"].slice(0, planar ? 2 : 3).forEach((name, k) => {
      const e = [0, 0, 0];
      e[k] = 1;
      const tip = [corner[0] + 20 * dot(view.right, e), corner[1] - 20 * dot(view.rise, e)];
      line([corner, tip], ink.muted, 1.1);
      pen.font = "11px system-ui, sans-serif";
      pen.fillStyle = ink.muted;
      pen.fillText(name, tip[0] + 3, tip[1] + 3);
    });
    if (data.magnified) pen.fillText(data.magnified, view.width - 14 - pen.measureText(data.magnified).width, view.height - 12);
  }

  // ---- plots --------------------------------------------------------------------------------------------------
  const svg = (name, attributes, text) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const [W, H, L, R, T, B] = [520, 132, 58, 10, 8, 20];
  const across = (time) => L + ((W - L - R) * (time - times[0])) / duration;
  const cursors = [];
  function ticks(least, most, count) {
    const rough = (most - least) / count || 1, power = 10 ** Math.floor(Math.log10(rough));
    const step = [10, 5, 2, 1].map((k) => k * power).find((k) => k <= rough * 1.001) || power;
    const list = [];
    for (let k = Math.ceil(least / step - 1e-9); k * step <= most + 1e-9 * step; k++) list.push(k * step);
    return list;
  }
  function plot(column, index) {
    const values = data.values[index];
    const finite = values.filter(Number.isFinite);
    const logarithmic = column.group === "residual" && finite.some((x) => x > 0);
    const scaled = (x) => (logarithmic ? Math.log10(Math.max(x, 1e-17)) : x);
    let [least, most] = [Math.min(...finite.map(scaled)), Math.max(...finite.map(scaled))];
    if (logarithmic) [least, most] = [Math.floor(least), Math.max(Math.ceil(most), Math.floor(least) + 1)];
    const flat = most - least <= 1e-9 * Math.max(Math.abs(most), Math.abs(least), 1e-12);
    if (flat) { const by = Math.max(Math.abs(most) * 0.05, 1e-6); least -= by; most += by; }
    const rest = logarithmic || flat ? 0 : 0.06 * (most - least);
    const upward = (x) => H - B - ((H - T - B) * (scaled(x) - least + rest)) / (most - least + 2 * rest);
    const box = el("figure", { class: "plot" }), head = el("header");
    const value = el("span");
    head.append(el("b", {}, `${column.name}, ${unit(column.unit)}`), value);
    const picture = svg("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": `${column.name} over time` });
    const marks = logarithmic ? [...new Set([least, Math.round((least + most) / 2), most])].map((p) => 10 ** p) : ticks(least, most, 3);
    marks.forEach((mark) => {
      const y = upward(mark);
      picture.append(svg("line", { x1: L, x2: W - R, y1: y, y2: y, stroke: "var(--grid)" }));
      const label = logarithmic ? `10${raised(Math.round(Math.log10(mark)))}` : figure(mark, 3);
      picture.append(svg("text", { x: L - 6, y: y + 4, "text-anchor": "end" }, label));
    });
    ticks(times[0], times[last], 4).forEach((mark) => picture.append(svg("text", { x: across(mark), y: H - 5, "text-anchor": "middle" }, `${figure(mark, 3)} s`)));
    let path = "";
    values.forEach((x, k) => { if (Number.isFinite(x)) path += `${path && Number.isFinite(values[k - 1]) ? "L" : "M"}${across(times[k]).toFixed(1)} ${upward(x).toFixed(1)}`; });
    picture.append(svg("path", { d: path, fill: "none", stroke: `var(--series-${index % 6})`, "stroke-width": 1.6, "stroke-linejoin": "round" }));
    const cursor = svg("line", { y1: T, y2: H - B, stroke: "var(--ink)", "stroke-width": 1 }), point = svg("circle", { r: 3.2, fill: `var(--series-${index % 6})` });
    const pointed = svg("line", { y1: T, y2: H - B, stroke: "var(--faint)", "stroke-dasharray": "3 3", visibility: "hidden" });
    picture.append(pointed, cursor, point);
    box.append(head, picture);
    const at = (time) => { const [a, b, share] = between(time); return values[a] + (values[b] - values[a]) * share; };
    const show = (time) => { value.textContent = `${figure(at(time))} ${unit(column.unit)} at ${figure(time, 4)} s`; };
    cursors.push((time) => {
      const x = across(time), y = at(time);
      cursor.setAttribute("x1", x);
      cursor.setAttribute("x2", x);
      point.setAttribute("cx", x);
      point.setAttribute("cy", Number.isFinite(y) ? upward(y) : -9);
      if (pointed.getAttribute("visibility") === "hidden") show(time);
    });
    const timeOf = (event) => {
      const area = picture.getBoundingClientRect(), x = ((event.clientX - area.left) / area.width) * W;
      return Math.min(times[last], Math.max(times[0], times[0] + (duration * (x - L)) / (W - L - R)));
    };
    picture.addEventListener("pointermove", (event) => {
      const time = timeOf(event), x = across(time);
      pointed.setAttribute("visibility", "visible");
      pointed.setAttribute("x1", x);
      pointed.setAttribute("x2", x);
      show(time);
      if (event.buttons) { stop(); seek(time); }
    });
    picture.addEventListener("pointerdown", (event) => { stop(); seek(timeOf(event)); });
    picture.addEventListener("pointerleave", () => { pointed.setAttribute("visibility", "hidden"); show(now); });
    return box;
  }
  const titles = { outputs: "Outputs", energy: "Energy", inputs: "Inputs", reactions: "Reactions", efforts: "Drivers", residual: "Constraints", powers: "Powers of loads" };
  [...new Set(data.columns.map((column) => column.group))].forEach((group, order) => {
    const inner = el("div");
    data.columns.forEach((column, index) => { if (column.group === group) inner.append(plot(column, index)); });
    const box = el("details");
    if (order === 0 || group === "energy") box.open = true;
    box.append(el("summary", {}, titles[group] || group), inner);
    $("plots").append(box);
  });
  const pair = against({ data, el, svg, figure, unit, ticks, between, cursors, stop: () => stop(), seek: (time) => seek(time) });
  if (pair) {
    const box = el("details");
    box.open = pair.isWay;
    box.append(el("summary", {}, "One against another"), pair.box);
    $("plots").append(box);
  }

  // ---- time ---------------------------------------------------------------------------------------------------
  let playing = false, before;
  const scrubber = $("time");
  [scrubber.min, scrubber.max, scrubber.value] = [times[0], times[last], times[0]];
  scrubber.step = duration / 1000;
  function seek(time) {
    now = time;
    scrubber.value = time;
    $("clock").textContent = `${time.toFixed(duration < 1 ? 4 : 2)} s`;
    cursors.forEach((cursor) => cursor(time));
    draw();
  }
  function tick(stamp) {
    if (!playing) return;
    const elapsed = before === undefined ? 0 : (stamp - before) / 1000;
    before = stamp;
    let time = now + elapsed * Number($("speed").value);
    if (time > times[last]) time = times[0];
    seek(time);
    requestAnimationFrame(tick);
  }
  function stop() {
    playing = false;
    $("play").textContent = "Play";
  }
  function play() {
    playing = true;
    before = undefined;
    $("play").textContent = "Pause";
    requestAnimationFrame(tick);
  }
  $("play").addEventListener("click", () => (playing ? stop() : play()));
  scrubber.addEventListener("input", () => { stop(); seek(Number(scrubber.value)); });
  ["names", "traces", "velocities"].forEach((id) => $(id).addEventListener("change", draw));
  document.addEventListener("keydown", (event) => {
    if (event.key === " " && !/INPUT|BUTTON|SELECT|SUMMARY/.test(event.target.tagName)) { event.preventDefault(); if (playing) stop(); else play(); }
  });

  // ---- hands --------------------------------------------------------------------------------------------------
  const fingers = new Map();
  canvas.addEventListener("pointerdown", (event) => { canvas.setPointerCapture(event.pointerId); fingers.set(event.pointerId, [event.clientX, event.clientY]); });
  canvas.addEventListener("pointerup", (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("pointercancel", (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const old = fingers.get(event.pointerId);
    if (!old) return;
    const here = [event.clientX, event.clientY], moved = [here[0] - old[0], here[1] - old[1]];
    if (fingers.size === 2) {
      const other = [...fingers.entries()].find(([id]) => id !== event.pointerId)[1];
      eye.zoom *= Math.hypot(here[0] - other[0], here[1] - other[1]) / Math.max(1, Math.hypot(old[0] - other[0], old[1] - other[1]));
    } else if (planar || event.shiftKey || event.buttons & 6) {
      eye.shift = [eye.shift[0] + moved[0], eye.shift[1] + moved[1]];
    } else {
      eye.azimuth -= 0.008 * moved[0];
      eye.height = Math.max(-1.55, Math.min(1.55, eye.height + 0.008 * moved[1]));
    }
    fingers.set(event.pointerId, here);
    draw();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const factor = Math.exp(-0.0015 * event.deltaY), area = canvas.getBoundingClientRect();
    const from = [event.clientX - area.left - view.width / 2, event.clientY - area.top - view.height / 2];
    eye.shift = eye.shift.map((x, k) => from[k] + (x - from[k]) * factor);
    eye.zoom *= factor;
    draw();
  }, { passive: false });
  canvas.addEventListener("dblclick", () => { eye = structuredClone(home); draw(); });
  window.addEventListener("resize", draw);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { colours(); draw(); });

  colours();
  seek(times[0]);
  if (last > 0 && !window.matchMedia("(prefers-reduced-motion: reduce)").matches) play();
})();
