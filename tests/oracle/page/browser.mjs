// Opens pages in Debian's Chromium and watches what they do. Exit code 77 where the tools are missing.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { homedir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const cache = join(process.env.XDG_CACHE_HOME || join(homedir(), ".cache"), "groundtruth-browser");
const chromium = "/usr/bin/chromium";

function tools() {
  try {
    const require = createRequire(join(cache, "package.json"));
    if (!existsSync(chromium)) throw new Error(`${chromium} is missing`);
    return { playwright: require("playwright-core"), axe: readFileSync(require.resolve("axe-core"), "utf8") };
  } catch (error) {
    console.log(`skipped: ${error.message.split("\n")[0]} (.ci/install-dependencies --with-browser)`);
    process.exit(77);
  }
}

const { playwright, axe } = tools();

export const run = (program, ...words) => execFileSync(program, words, { encoding: "utf8", env: { ...process.env, NO_COLOR: "1" } });

export const launch = () => playwright.chromium.launch({ executablePath: chromium, args: ["--no-sandbox"] });

// A page with what it complained of and asked the network for.
export async function open(browser, file, { hash = "", ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1240, height: 1000 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => request.url().startsWith(pathToFileURL(file).href) || complaints.push(`asks for ${request.url()}`));
  await page.goto(pathToFileURL(file).href + hash);
  return { page, complaints, close: () => context.close() };
}

// What axe-core finds against WCAG 2 A and AA, contrast included.
export async function violations(page) {
  await page.addScriptTag({ content: axe });
  const found = await page.evaluate(() => globalThis.axe.run({ runOnly: ["wcag2a", "wcag2aa"] }));
  return found.violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.html} ${node.failureSummary}`));
}
