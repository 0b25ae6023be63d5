// How fast the console's map draws: main-thread time and frames per second in a headless Chromium, fed with frames as
// the server sends them. Prints JSON. `node bench/console_map/measure.mjs [seconds for each]`; needs `npm ci` in web/.
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { openBrowser } from "../../web/tools/browser.mjs";
import { serve } from "../../web/tools/serve.mjs";

const web = join(dirname(dirname(dirname(fileURLToPath(import.meta.url)))), "web");
const seconds = Number(process.argv[2] ?? 8);
const size = { width: 1280, height: 800 };
// `auto` in a browser whose WebGL is made by software has to notice, and take the cheaper way.
const kRuns = [
  { name: "10,000 robots, WebGL", withGl: true, query: "count=10000&renderer=webgl" },
  { name: "1,000 robots, WebGL", withGl: true, query: "count=1000&renderer=webgl" },
  { name: "10,000 robots, WebGL in software, as the map chooses", withGl: true, query: "count=10000" },
  { name: "10,000 robots, no WebGL", withGl: false, query: "count=10000" },
  { name: "1,000 robots, no WebGL", withGl: false, query: "count=1000" },
];

const server = await serve(web);
const results = [];
for (const withGl of [true, false]) {
  const browser = await openBrowser({ withGl });
  for (const run of kRuns.filter((one) => one.withGl === withGl)) {
    const page = await browser.page(size);
    await page.goto(`${server.address}gallery.html?scene=crowd&bench=1&${run.query}`);
    await page.waitForSelector("body[data-drawn]");
    await page.evaluate(() => window.measure(1)); // warm
    results.push({ name: run.name, ...(await page.evaluate((time) => window.measure(time), seconds)) });
    await page.close();
  }
  await browser.close();
}
await server.close();
console.log(JSON.stringify(results, null, 2));
