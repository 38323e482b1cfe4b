// Pages of `linkwright animate` in Chromium, opened from disk: they load without an error, the scrubber moves the motion, plots share
// its cursor and show values, nothing is cut off on a phone, dark pages are dark. `.ci/browser` runs it.
//
//     node pages.mjs FOLDER NAME…        FOLDER/NAME.html of each mechanism, and FOLDER/NAME.svg
import assert from "node:assert/strict";
import path from "node:path";
import { chromium } from "playwright-core";

const [folder, ...names] = process.argv.slice(2);
const quiet = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: quiet });
const url = (name) => `file://${path.resolve(folder, name)}`;

/** A page that reports every error and every request that leaves the disk. */
async function opened(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 800 }, reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && wrong.push(message.text()));
  page.on("pageerror", (error) => wrong.push(error.message));
  page.on("request", (request) => /^https?:/.test(request.url()) && wrong.push(request.url()));
  await page.goto(url(name));
  return { page, context, wrong };
}

const picture = (page) => page.evaluate(() => document.getElementById("stage").toDataURL());
const scrub = (page, share) => page.evaluate((share) => {
  const time = document.getElementById("time");
  time.value = Number(time.min) + (Number(time.max) - Number(time.min)) * share;
  time.dispatchEvent(new Event("input"));
}, share);

for (const name of names) {
  const { page, context, wrong } = await opened(`${name}.html`);
  await scrub(page, 0);
  const before = await picture(page);
  const value = () => page.locator(".plot header span").first().textContent();
  const [first, cursor] = [await value(), await page.locator(".plot svg line[stroke='var(--ink)']").first().getAttribute("x1")];
  await scrub(page, 0.4);
  assert.ok(await picture(page) !== before, `${name}: the scrubber moves the motion`);
  assert.notEqual(await value(), first, `${name}: and the values`);
  const cursors = await page.locator(".plot svg line[stroke='var(--ink)']").evaluateAll((lines) => lines.map((line) => line.getAttribute("x1")));
  assert.ok(cursors.length > 1 && new Set(cursors).size === 1 && cursors[0] !== cursor, `${name}: all plots share the cursor`);
  const plot = page.locator(".plot svg").first();
  await plot.hover({ position: { x: 200, y: 40 } });
  assert.match(await value(), / at .* s$/, `${name}: a value where one points`);
  await scrub(page, 0);
  await page.mouse.move(5, 5);
  assert.ok(await picture(page) === before, `${name}: back is the same picture`);

  // One quantity against another: choices draw anew, the spot follows the time, a click goes to a time.
  await page.evaluate(() => { document.getElementById("against_x").closest("details").open = true; });
  const way = () => page.locator(".against svg path").getAttribute("d"), spot = () => page.locator(".against svg circle").getAttribute("cx");
  const ways = [await way()];
  const most = await page.locator("#against_x option").count() - 1;
  for (const [axis, index] of [["x", "0"], ["y", "1"], ["x", `${most}`], ["y", `${most - 1}`]]) {
    await page.selectOption(`#against_${axis}`, index);
    ways.push(await way());
  }
  assert.ok(ways.every((path) => path.startsWith("M") && !path.includes("NaN")), `${name}: a way for each choice`);
  // What grows alike has the same straight way.
  assert.ok(new Set(ways).size > 1, `${name}: choices draw anew`);
  await page.selectOption("#against_x", "0");
  const resting = await spot();
  await scrub(page, 0.5);
  assert.notEqual(await spot(), resting, `${name}: the spot follows the time`);
  await page.locator(".against svg").click({ position: { x: 300, y: 60 } });
  assert.ok(await page.evaluate(() => { const t = document.getElementById("time"); return Number(t.value) > Number(t.min) && Number(t.value) < Number(t.max); }), `${name}: a click goes to a time`);
  assert.match(await page.locator(".against header span").textContent(), / at .* s$/, `${name}: and is told`);
  await scrub(page, 0.1);
  for (const box of ["names", "traces", "velocities"]) {
    const plain = await picture(page);
    await page.locator(`#${box}`).check();
    assert.ok(await picture(page) !== plain, `${name}: ${box} are shown`);
  }
  const stage = await page.locator("#stage").boundingBox();
  const still = await picture(page);
  await page.mouse.move(stage.x + 200, stage.y + 150);
  await page.mouse.down();
  await page.mouse.move(stage.x + 260, stage.y + 190, { steps: 3 });
  await page.mouse.up();
  const dragged = await picture(page);
  assert.ok(dragged !== still, `${name}: dragging turns or shifts it`);
  await page.mouse.wheel(0, -240);
  await page.waitForFunction((old) => document.getElementById("stage").toDataURL() !== old, dragged);
  assert.deepEqual(wrong, [], name);
  await context.close();

  // It plays by itself where motion is welcome.
  const playing = await opened(`${name}.html`, { reducedMotion: "no-preference" });
  await playing.page.waitForFunction(() => Number(document.getElementById("time").value) > 0.05);
  assert.deepEqual(playing.wrong, [], name);
  await playing.context.close();

  for (const [kind, options] of [["dark", { colorScheme: "dark" }], ["phone", { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true }]]) {
    const other = await opened(`${name}.html`, options);
    const [wide, view] = await other.page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view, `${name}, ${kind}: ${wide} px in a window of ${view} px`);
    const light = await other.page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).reduce((sum, x) => sum + Number(x), 0));
    assert.equal(light < 384, kind === "dark", `${name}, ${kind}: ${light}`);
    assert.deepEqual(other.wrong, [], `${name}, ${kind}`);
    if (process.env.SHOTS) await other.page.screenshot({ path: path.join(process.env.SHOTS, `${name}_${kind}.png`), fullPage: kind === "phone" });
    await other.context.close();
  }

  // The picture that plays by itself.
  const svg = await opened(`${name}.svg`);
  const shot = async (time) => {
    await svg.page.evaluate((time) => { document.documentElement.pauseAnimations(); document.documentElement.setCurrentTime(time); }, time);
    return (await svg.page.screenshot()).toString("base64");
  };
  assert.ok(await shot(0) !== await shot(0.7), `${name}.svg plays`);
  assert.deepEqual(svg.wrong, [], `${name}.svg`);
  await svg.context.close();
  console.log(`${name}: well`);
}
await browser.close();
