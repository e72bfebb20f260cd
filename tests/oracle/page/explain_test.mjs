// `groundtruth explain --html` in a real browser: node explain_test.mjs PROGRAM FOLDER
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test, after, before } from "node:test";
import { fileURLToPath } from "node:url";

import { launch, open, run, violations } from "./browser.mjs";

const [program, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const ASKS = {
  seam: "seam/along-the-top",
  "face-plane": "grazing/top-plane",
  miss: "grazing/one-ulp-above",
  corner: "clip/case-2-corner",
  lift: join(here, "lift-off.jsonl"),
};
mkdirSync(folder, { recursive: true });

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

function pageOf(name) {
  const file = join(folder, `${name}.html`);
  run(program, "explain", ASKS[name], "--html", file);
  return file;
}

// By stop: the leaves that the page of text says are true, and whether the solid holds it.
function stopsInText(name) {
  const lines = run(program, "explain", ASKS[name]).split("\n").filter((line) => line.includes("leaves true:"));
  return lines.map((line) => {
    const [head, leaves] = line.split("leaves true:");
    return { inside: / in\s*$/.test(head), leaves: leaves.trim() === "none" ? [] : leaves.trim().split(" ") };
  });
}

const lit = (page) => page.evaluate(() => ({
  inside: document.querySelector(".shown .node").classList.contains("true"),
  leaves: [...document.querySelectorAll(".shown .node.true[data-leaf]")].map((node) => node.dataset.leaf),
}));

for (const name of Object.keys(ASKS)) {
  for (const colorScheme of ["light", "dark"]) {
    test(`${name} is quiet, asks for nothing and has enough contrast, ${colorScheme}`, async () => {
      const { page, complaints, close } = await open(browser, pageOf(name), { colorScheme });
      await page.screenshot({ path: join(folder, `${name}-${colorScheme}.png`), fullPage: true });
      assert.deepEqual(await violations(page), []);
      assert.deepEqual(complaints, []);
      assert.ok(await page.locator("svg[role=img][aria-label]").count() > 0);
      await close();
    });
  }
}

for (const name of ["seam", "face-plane", "miss"]) {
  test(`${name}: the keyboard stops at every breakpoint, and the right leaves are lit`, async () => {
    const expected = stopsInText(name);
    const { page, complaints, close } = await open(browser, pageOf(name));
    await page.locator(".lambda").focus();
    await page.keyboard.press("Home");
    for (const [i, stop] of expected.entries()) {
      assert.deepEqual(await lit(page), stop, `stop ${i}`);
      await page.keyboard.press("ArrowRight");
    }
    assert.equal(await page.locator(".lambda").inputValue(), String(expected.length - 1));
    assert.deepEqual(complaints, []);
    await close();
  });

  test(`${name}: so does the mouse`, async () => {
    const expected = stopsInText(name);
    const { page, close } = await open(browser, pageOf(name));
    const box = await page.locator(".lambda").boundingBox();
    const thumb = 16;
    for (const [i, stop] of expected.entries()) {
      const share = i / (expected.length - 1);
      await page.mouse.click(box.x + thumb / 2 + share * (box.width - thumb), box.y + box.height / 2);
      assert.equal(await page.locator(".lambda").inputValue(), String(i));
      assert.deepEqual(await lit(page), stop);
    }
    await close();
  });

  test(`${name}: the solid is first entered where the answer says`, async () => {
    const { page, close } = await open(browser, pageOf(name));
    const answer = JSON.parse((await page.locator("details pre").textContent()).trim().split("\n").at(-1)).answer;
    const stops = JSON.parse(await page.locator(".stops").textContent());
    const entered = stops.find((stop) => stop.lit[0] === "1");
    assert.equal(entered?.lambda, answer.lambda_exact);
    const named = await page.locator(".faces tr.yes td:first-child").allTextContents();
    assert.deepEqual(named.map(Number), answer.admissible ?? []);
    await close();
  });
}

test("the hash brings back case, stop and zoom", async () => {
  const file = pageOf("seam");
  const { page, close } = await open(browser, file);
  await page.locator(".lambda").focus();
  await page.keyboard.press("End");
  await page.locator(".zoom-choice").selectOption("3");
  const { hash } = new URL(page.url());
  const again = await open(browser, file, { hash });
  assert.equal(await again.page.locator(".lambda").inputValue(), await page.locator(".lambda").inputValue());
  assert.equal(await again.page.locator(".zoom-choice").inputValue(), "3");
  assert.deepEqual(await lit(again.page), await lit(page));
  assert.equal(await again.page.locator("g.zoom:visible").count(), 1);
  await again.page.screenshot({ path: join(folder, "seam-zoom.png") });
  await Promise.all([close(), again.close()]);
});

test("a recorded chain is gone through by its links", async () => {
  const { page, complaints, close } = await open(browser, pageOf("lift"));
  const count = await page.locator("section.case").count();
  assert.ok(count > 2);
  for (let i = 1; i < count; ++i) {
    await page.screenshot({ path: join(folder, `lift-${i}.png`), fullPage: true });
    await page.locator(".shown .next").focus();
    await page.keyboard.press("Enter");
    assert.equal(await page.locator(".shown").getAttribute("id"), `case=${i + 1}`);
  }
  await page.screenshot({ path: join(folder, `lift-${count}.png`), fullPage: true });
  assert.deepEqual(complaints, []);
  await close();
});

test("a validation's page shows their answer beside the exact one", async () => {
  const file = join(folder, "validation.html");
  try { run(program, "validate", "--cases", "300", "--html", file, "--engine", "as-written"); } catch { /* it exits with 1 */ }
  const { page, complaints, close } = await open(browser, file, { hash: "#case=2" });
  assert.ok(await page.locator(".shown .opinions tr:first-child td:first-child", { hasText: "yours" }).isVisible());
  await page.screenshot({ path: join(folder, "validation.png"), fullPage: true });
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(complaints, []);
  await close();
});

test("without its script the page shows all it knows", async () => {
  const { page, close } = await open(browser, pageOf("lift"), { javaScriptEnabled: false });
  const sections = page.locator("section.case");
  for (let i = 0; i < await sections.count(); ++i) assert.ok(await sections.nth(i).isVisible());
  await close();
});

test("the command can be copied", async () => {
  const { page, close } = await open(browser, pageOf("seam"), { permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator(".copy").click();
  await page.locator(".copy", { hasText: "copied" }).waitFor();
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), "groundtruth explain seam/along-the-top");
  await close();
});
