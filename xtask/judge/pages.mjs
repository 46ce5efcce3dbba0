// Opens pages from disk in Chromium, light and dark, wide and narrow, with and without scripts, and counts what is wrong.
//
// Usage: node pages.mjs CHROMIUM PAGE…   Prints one line per finding and ends with their number; exit code 1 when there is any.
// Looked for: requests for anything but the page itself, faults that axe-core finds, text that only scripts show,
// content wider than the window, and messages in the console.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";
import { chromium } from "playwright-core";

const [executablePath, ...pages] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const findings = [];

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
for (const page of pages) {
  const texts = new Map();
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
await browser.close();
for (const finding of findings) console.log(finding);
console.log(`${pages.length} pages in 8 ways each: ${findings.length} findings`);
process.exit(findings.length === 0 ? 0 : 1);

async function look(path, scene, { javaScriptEnabled, colorScheme, width }) {
  // The judge's own script is not the page's: its policy must not stop it.
  const context = await browser.newContext({
    bypassCSP: javaScriptEnabled,
    javaScriptEnabled,
    colorScheme,
    viewport: { width, height: 900 },
  });
  const page = await context.newPage();
  const address = pathToFileURL(resolve(path)).href;
  page.on("request", (request) => {
    const asked = request.url();
    if (asked !== address && !asked.startsWith("data:")) findings.push(`${scene}: asks for ${asked}`);
  });
  page.on("console", (message) => findings.push(`${scene}: console: ${message.text()}`));
  page.on("pageerror", (error) => findings.push(`${scene}: script error: ${error.message}`));
  await page.goto(address);
  const text = (await page.locator("body").innerText()).replace(/\s+/g, " ");
  if (javaScriptEnabled) {
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    if (overflow > 0) findings.push(`${scene}: ${overflow} px wider than the window`);
    await page.evaluate(axe);
    const result = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
    for (const violation of result.violations) {
      const where = violation.nodes.slice(0, 3).map((node) => node.target.join(" ")).join("; ");
      findings.push(`${scene}: axe: ${violation.id} at ${violation.nodes.length} places: ${where}`);
    }
  }
  await context.close();
  return text;
}

// What is written on the page may not depend on scripts; colours and widths may hide or show nothing either.
function compareTexts(texts) {
  const [[first, expected], ...rest] = texts;
  for (const [scene, text] of rest) {
    if (scene.endsWith("off)") && !text.includes(expected.slice(0, 2000)) && text.length < 0.99 * expected.length) {
      findings.push(`${scene}: shows ${text.length} characters, ${first} shows ${expected.length}`);
    }
  }
}
