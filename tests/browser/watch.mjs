// The page of `linkwright watch` in Chromium: it loads without an error, a slider changes the motion, an edit with a mistake shows its message at
// its line and keeps the old motion, and the next edit takes the message away. `.ci/browser` runs it.
//
//     node watch.mjs PROGRAM FILE FOLDER     FILE is copied to FOLDER and edited there
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { chromium } from "playwright-core";

const [program, source, folder] = process.argv.slice(2);
const file = path.join(folder, "watched.mech");
const text = fs.readFileSync(source, "utf8");
fs.writeFileSync(file, text);
const child = spawn(program, ["watch", "--port", "0", "--for", "2s", "--step", "5ms", file]);
const url = await new Promise((resolve) => child.stdout.once("data", (data) => resolve(String(data).split(" ")[0])));
const quiet = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: quiet });
try {
  for (const options of [{}, { colorScheme: "dark" }, { viewport: { width: 390, height: 800 } }]) {
    const context = await browser.newContext({ viewport: { width: 1200, height: 800 }, reducedMotion: "reduce", ...options });
    const page = await context.newPage();
    const wrong = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && wrong.push(message.text()));
    page.on("pageerror", (error) => wrong.push(error.message));
    await page.goto(url);
    const picture = () => page.evaluate(() => document.getElementById("motion").contentDocument.getElementById("stage").toDataURL());
    const stage = () => page.frameLocator("#motion").locator("#stage");
    await stage().waitFor();
    await page.waitForTimeout(300);
    const before = await picture();
    const slider = page.locator("#values input[type=range]").first();
    await slider.evaluate((input) => {
      input.value = input.min;
      input.dispatchEvent(new Event("input"));
    });
    await page.waitForFunction((old) => {
      const stage = document.getElementById("motion").contentDocument?.getElementById("stage");
      return stage && stage.toDataURL() !== old;
    }, before);
    // A busy machine draws once more when the size of the page is known.
    let moved = await picture();
    for (let tries = 0; tries < 20; tries += 1) {
      await page.waitForTimeout(300);
      const next = await picture();
      if (next === moved) break;
      moved = next;
    }
    const begin = Date.now();
    fs.writeFileSync(file, text.replace("crank.start", "crank.begin"));
    await page.locator(".message.error").waitFor();
    console.log(`a mistake is shown after ${Date.now() - begin} ms`);
    assert.match(await page.locator(".message .place").first().textContent(), /watched\.mech:\d+:\d+$/);
    assert.match(await page.locator(".message pre").first().textContent(), /crank\.begin[^]*\^/);
    assert.equal(await picture(), moved, "the last motion stays");
    await page.screenshot({ path: path.join(folder, `watch_mistake_${options.colorScheme || options.viewport?.width || "light"}.png`) });
    fs.writeFileSync(file, text);
    await page.locator(".message").waitFor({ state: "detached" });
    await page.waitForTimeout(300);
    await page.screenshot({ path: path.join(folder, `watch_${options.colorScheme || options.viewport?.width || "light"}.png`) });
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `nothing is cut off at the side, ${overflow} px`);
    assert.deepEqual(wrong, []);
    await context.close();
  }
} finally {
  child.kill();
  await browser.close();
}
console.log("watch: all well");
