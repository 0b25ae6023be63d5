// Pictures of the map's gallery into pictures/, for people to look at. `npm run gallery [part of a name]`.
import { mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { openBrowser } from "./browser.mjs";
import { serve } from "./serve.mjs";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const out = join(web, "pictures");
mkdirSync(out, { recursive: true });
const small = { width: 1280, height: 800 };
const large = { width: 1920, height: 1080 };
const kPictures = [
  ["demo_c", "scene=demo-c&labels=1", small],
  ["demo_c_watched", "scene=demo-c&watched=1", small],
  ["demo_c_watched_dark", "scene=demo-c&watched=all&theme=dark", large],
  ["demo_c_military", "scene=demo-c&military=1", large],
  ["demo_c_military_dark", "scene=demo-c&military=1&theme=dark&labels=1", small],
  ["everything", "scene=everything", small],
  ["everything_dark", "scene=everything&theme=dark&labels=1", small],
  ["everything_military", "scene=everything&military=1&circles=1", large],
  ["everything_military_dark", "scene=everything&military=1&theme=dark", large],
  ["everything_fine", "scene=everything", { ...small, density: 2 }],
  ["lab", "scene=lab&watched=1", small],
  ["lab_dark", "scene=lab&watched=1&theme=dark", small],
  ["crowd_1000", "scene=crowd&count=1000", small],
  ["crowd_10000", "scene=crowd&count=10000", small],
  ["crowd_10000_dark", "scene=crowd&count=10000&theme=dark", large],
  ["crowd_10000_webgl", "scene=crowd&count=10000&renderer=webgl", small],
  ["watched_webgl", "scene=demo-c&watched=1&renderer=webgl&circles=1", { ...small, density: 2 }],
];

const { address, close } = await serve(web);
const wanted = kPictures.filter(([name]) => name.includes(process.argv[2] ?? ""));
for (const withGl of [false, true]) {
  const pictures = wanted.filter(([name]) => name.includes("webgl") === withGl);
  if (pictures.length === 0) continue;
  const browser = await openBrowser({ withGl });
  for (const [name, query, size] of pictures) {
    const page = await browser.page(size);
    page.on("pageerror", (error) => console.error(name, error));
    page.on("console", (message) => message.type() === "error" && console.error(name, message.text()));
    await page.goto(`${address}gallery.html?${query}`);
    await page.waitForSelector("body[data-drawn]");
    await page.screenshot({ path: join(out, `${name}.png`) });
    await page.close();
  }
  await browser.close();
}
await close();
