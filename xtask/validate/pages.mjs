// Opens pages from disk in Chromium, light and dark, wide and narrow, with and without scripts, and counts the faults.
//
// Usage: node pages.mjs CHROMIUM PAGE…   Prints one line per finding and ends with their number; exit code 1 when there is any.
// It checks for requests for anything but the page itself, faults found by axe-core, text that only scripts show,
// messages in the console, and readouts and sliders that the keyboard does not move; and, with everything that folds open,
// at four widths, for content wider than the window and for text that its picture clips.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";
import { chromium } from "playwright-core";

const [executablePath, ...pages] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const findings = [];

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
// Two pages at a time: a browser uses little more than one processor for each.
const queue = pages.values();
await Promise.all([open(), open()]);
await browser.close();
for (const finding of findings.sort()) console.log(finding);
console.log(`${pages.length} pages in 10 ways each: ${findings.length} findings`);
process.exit(findings.length === 0 ? 0 : 1);

async function open() {
  for (const page of queue) {
    const texts = new Map();
    for (const width of [768, 390]) await fits(page, width);
    for (const javaScriptEnabled of [true, false]) {
      for (const colorScheme of ["light", "dark"]) {
        for (const width of [1280, 320]) {
          const scene = `${page} (${colorScheme}, ${width} px, scripts ${javaScriptEnabled ? "on" : "off"})`;
          texts.set(scene, await look(page, scene, { javaScriptEnabled, colorScheme, width }));
        }
      }
    }
    compareTexts(texts);
  }
}

// Opens a page in the light at a width that needs no other check.
async function fits(path, width) {
  const page = await browser.newPage({ viewport: { width, height: 900 } });
  await page.goto(pathToFileURL(resolve(path)).href);
  await findOverflow(page, `${path} (${width} px)`);
  await page.close();
}

// What sticks out of the window or of its picture, with everything open: the page stays so.
async function findOverflow(page, scene) {
  const found = await page.evaluate(async () => {
    const wider = () => document.documentElement.scrollWidth - window.innerWidth;
    const folded = wider();
    document.querySelectorAll("details").forEach((element) => { element.open = true; });
    // What is packed is in place soon after it was opened; a piece that never comes is a finding of the time limit.
    while (document.querySelector("details[open][data-packed]")) await new Promise((resume) => setTimeout(resume, 20));
    const clipped = [...document.querySelectorAll("svg text")].filter((text) => {
      const [inner, outer] = [text, text.ownerSVGElement].map((element) => element.getBoundingClientRect());
      const sticksOut = [outer.left - inner.left, outer.top - inner.top, inner.right - outer.right, inner.bottom - outer.bottom];
      return inner.width > 0 && Math.max(...sticksOut) > 1;
    });
    return { widths: [folded, wider()], clipped: clipped.map((text) => text.textContent) };
  });
  for (const [index, width] of found.widths.entries()) {
    if (width > 0) findings.push(`${scene}: ${["folded", "opened"][index]}, ${width} px wider than the window`);
  }
  for (const text of found.clipped) findings.push(`${scene}: its picture clips "${text}"`);
}

async function look(path, scene, { javaScriptEnabled, colorScheme, width }) {
  // axe-core's script is not part of the page: the page's policy must not stop it.
  const context = await browser.newContext({
    bypassCSP: javaScriptEnabled,
    javaScriptEnabled,
    colorScheme,
    viewport: { width, height: 900 },
  });
  const page = await context.newPage();
  const address = pathToFileURL(resolve(path)).href;
  page.on("request", (request) => {
    const requested = request.url();
    if (requested !== address && !requested.startsWith("data:")) findings.push(`${scene}: requests ${requested}`);
  });
  page.on("console", (message) => findings.push(`${scene}: console: ${message.text()}`));
  page.on("pageerror", (error) => findings.push(`${scene}: script error: ${error.message}`));
  await page.goto(address);
  await showExtras(page, "none");
  const text = (await page.locator("body").innerText()).replace(/\s+/g, "");
  await showExtras(page, "");
  if (javaScriptEnabled) {
    await findOverflow(page, scene);
    // Shading at the edges of scrolling areas would leave the contrast undecided: it is checked on the plain background.
    await page.addStyleTag({ content: ".plot, .scroll { background: var(--ground) !important; }" });
    await page.evaluate(axe);
    const result = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
    for (const violation of result.violations) {
      const where = violation.nodes.slice(0, 3).map((node) => node.target.join(" ")).join("; ");
      findings.push(`${scene}: axe: ${violation.id} at ${violation.nodes.length} places: ${where}`);
    }
    await tryReadouts(page, scene);
    await trySliders(page, scene);
  } else if (await page.locator("#controls").isVisible()) {
    findings.push(`${scene}: sliders that nothing listens to`);
  }
  await context.close();
  return text;
}

// What scripts are for, or say when they are missing, and the contents, which fold where there is little room; none of it may be all
// there is.
async function showExtras(page, display) {
  const style = (extras, value) => extras.forEach((element) => { element.style.display = value; });
  await page.locator("[data-extra], noscript, nav.contents").evaluateAll(style, display);
}

// Every map that reads out says something else after an arrow key, and no field of its sentence is left open.
async function tryReadouts(page, scene) {
  for (const plot of await page.locator(".plot:has(rect.readout)").all()) {
    const said = plot.locator("xpath=following-sibling::p[1]");
    await plot.focus();
    const heard = [];
    for (const key of ["ArrowRight", "ArrowUp", "ArrowUp"]) {
      await page.keyboard.press(key);
      heard.push(await said.innerText());
    }
    const broken = heard.some((text) => /undefined|[{}]/.test(text) || !text.startsWith("V = "));
    if (broken || new Set(heard).size < heard.length) findings.push(`${scene}: a map reads out: ${heard.join(" / ")}`);
  }
}

// Every slider moves with the keyboard, says its value, and changes what is shown.
async function trySliders(page, scene) {
  const sliders = page.locator("#controls input[type=range]");
  const shown = () => page.evaluate(() => [
    document.querySelector("#map svg").outerHTML,
    ...[...document.querySelectorAll("[data-cells]")].map((element) => element.textContent),
  ].join("|"));
  for (const slider of await sliders.all()) {
    const [before, spoken] = [await shown(), await slider.getAttribute("aria-valuetext")];
    await slider.focus();
    await page.keyboard.press("ArrowRight");
    const moved = (await shown()) !== before && (await slider.getAttribute("aria-valuetext")) !== spoken;
    if (!moved || /undefined/.test(await shown())) findings.push(`${scene}: a slider changes nothing, or into nothing`);
    for (const end of ["Home", "End"]) {
      await page.keyboard.press(end);
      if (/undefined/.test(await shown())) findings.push(`${scene}: nothing is stored at ${end}`);
    }
  }
}

// What is written on the page depends neither on scripts nor on colours and widths.
function compareTexts(texts) {
  const [[first, expected], ...rest] = texts;
  for (const [scene, text] of rest) {
    if (text === expected) continue;
    let at = 0;
    while (text[at] === expected[at]) at += 1;
    findings.push(`${scene}: "${text.slice(at, at + 60)}" where ${first} has "${expected.slice(at, at + 60)}"`);
  }
}
