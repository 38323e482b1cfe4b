"use strict";
// Asks for the file as it stands, shows it, and asks again with its stamp: the answer comes when the file has changed. A slider asks at once.

const at = (id) => document.getElementById(id);
const values = {}; // what was moved, by name in the query
let stamp = null;
let asking = null;
let shown = "";

function make(tag, text, kind) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (kind) element.className = kind;
  return element;
}

async function ask(after) {
  if (asking) asking.abort();
  const own = new AbortController();
  asking = own;
  const query = new URLSearchParams(values);
  if (after) query.set("after", after);
  try {
    const answer = await fetch("/state?" + query, { signal: own.signal });
    const state = await answer.json();
    if (asking !== own) return;
    stamp = state.stamp;
    show(state);
    ask(stamp);
  } catch (error) {
    if (own.signal.aborted) return;
    at("news").textContent = "linkwright watch has ended, or does not answer; asking again …";
    setTimeout(() => { if (asking === own) ask(null); }, 1000);
  }
}

function show(state) {
  const text = JSON.stringify(state);
  if (text === shown) return;
  shown = text;
  at("messages").replaceChildren(...state.messages.map(message));
  const isWhole = state.motion !== undefined;
  for (const id of ["motion", "values", "drawing"]) at(id).classList.toggle("old", !isWhole);
  if (!isWhole) {
    at("news").textContent = "The file has mistakes; what is below is its last state without.";
    return;
  }
  document.title = state.name + " – Linkwright";
  at("news").textContent = state.name + ", " + new Date().toLocaleTimeString();
  at("drawing").innerHTML = state.drawing;
  sliders(state);
  move(state.motion);
}

// The motion anew, at the time where the old one was, playing if that was.
function move(page) {
  const frame = at("motion");
  const old = frame.contentDocument;
  const time = old && old.getElementById("time");
  const play = old && old.getElementById("play");
  const was = { time: time && time.value, plays: play && play.textContent !== "Play" };
  const axes = ["against_x", "against_y"].map((id) => chosen(old, id));
  frame.onload = () => {
    const inside = frame.contentDocument;
    const slider = inside.getElementById("time");
    if (slider && was.time) {
      slider.value = was.time;
      slider.dispatchEvent(new Event("input"));
    }
    for (const [id, text] of axes) choose(inside, id, text);
    const button = inside.getElementById("play");
    if (button && was.plays && button.textContent === "Play") button.click();
  };
  frame.srcdoc = page;
}

// What a choice says, so that a page with other quantities finds it again.
function chosen(page, id) {
  const select = page && page.getElementById(id);
  return [id, select && select.selectedOptions[0] && select.selectedOptions[0].textContent];
}

function choose(page, id, text) {
  const select = page.getElementById(id);
  const option = select && [...select.options].find((known) => known.textContent === text);
  if (!option || option.value === select.value) return;
  select.value = option.value;
  select.dispatchEvent(new Event("change"));
  select.closest("details").open = true;
}

function message(found) {
  const box = make("div", undefined, "message " + found.severity);
  const head = make("div");
  head.append(make("b", found.severity + ": "), found.message);
  box.append(head);
  if (found.at) box.append(line(found.at));
  for (const note of found.notes) {
    box.append(make("div", note.message));
    box.append(line(note.at));
  }
  return box;
}

// The line of a file, and a mark under what is meant.
function line(place) {
  const box = make("div");
  box.append(make("div", `${place.file}:${place.line}:${place.column}`, "place"));
  box.append(make("pre", place.text + "\n" + " ".repeat(place.column - 1) + "^".repeat(place.width)));
  return box;
}

function sliders(state) {
  const form = at("values");
  const focus = document.activeElement && document.activeElement.name;
  const parts = state.parameters.map(slider).concat(state.inputs.map(field));
  if (parts.length) {
    const back = make("button", "As written");
    back.type = "button";
    back.onclick = () => {
      for (const name of Object.keys(values)) delete values[name];
      ask(null);
    };
    parts.push(back);
  }
  form.replaceChildren(...parts);
  if (focus && form.elements[focus]) form.elements[focus].focus();
}

function slider(parameter) {
  const { name, value, unit } = parameter;
  const around = Math.abs(parameter.default) || 1;
  const [least, most] = parameter.bounds || [parameter.default - around, parameter.default + around];
  const label = make("label", undefined);
  const input = make("input");
  Object.assign(input, { type: "range", name: "set." + name, min: least, max: most, step: (most - least) / 200 });
  input.value = value;
  const text = (number) => String(Number(Number(number).toPrecision(4))) + (unit === "1" ? "" : " " + unit);
  const output = make("output", text(value));
  input.oninput = () => {
    values["set." + name] = input.value;
    output.textContent = text(input.value);
    ask(null);
  };
  label.append(make("span", name), output, input);
  return label;
}

function field(input) {
  const label = make("label");
  const box = make("input");
  Object.assign(box, { type: "text", name: "input." + input.name, value: input.law, spellcheck: false });
  box.onchange = () => {
    values["input." + input.name] = box.value;
    ask(null);
  };
  label.append(make("span", input.name + "(t)"), make("output", input.unit === "1" ? "" : input.unit), box);
  return label;
}

at("values").onsubmit = (event) => event.preventDefault();
ask(null);
