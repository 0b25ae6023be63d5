// What the map shows, told by what is on the screen.
import { inflateSync } from "node:zlib";
import { expect, test } from "vitest";
import { begin, type Project } from "./begin.ts";
import type { Console } from "./console.ts";

/** Red, green and blue [0 .. 255] at a place of the world. */
async function colorAt(console: Console, x: number, y: number): Promise<number[]> {
  const at = await console.onPage(x, y);
  const png = await console.page.screenshot({
    clip: { x: Math.round(at.x), y: Math.round(at.y), width: 1, height: 1 },
  });
  const parts: Buffer[] = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  // One pixel: after the byte that names the filter come its colours as they are.
  return [...inflateSync(Buffer.concat(parts)).subarray(1, 4)];
}

/** Four pixels: below red and green, above blue and white. */
function bitmap(): Buffer {
  const file = Buffer.alloc(54 + 16);
  file.write("BM");
  file.writeUInt32LE(file.length, 2);
  file.writeUInt32LE(54, 10);
  file.writeUInt32LE(40, 14);
  file.writeInt32LE(2, 18);
  file.writeInt32LE(2, 22);
  file.writeUInt16LE(1, 26);
  file.writeUInt16LE(24, 28);
  file.writeUInt32LE(16, 34);
  Buffer.from([0, 0, 255, 0, 255, 0, 0, 0, 255, 0, 0, 255, 255, 255, 0, 0]).copy(file, 54);
  return file;
}

/** The same as PPM, which browsers don't know: its rows go down from the top. */
function pixmap(): Buffer {
  const pixels = [0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0];
  return Buffer.concat([Buffer.from("P6\n# by hand\n2 2\n255\n"), Buffer.from(pixels)]);
}

function withPicture(project: Project, name = "ground.bmp", picture = bitmap()): void {
  project.write(name, picture);
  project.write("ground.mapinfo", `${name}\n100 0 800 800\n`);
  project.write("democ.odl", project.read("democ.odl").replace("CONTROL MEASURES:", "LOAD-MAP ground.mapinfo\n\n$&"));
}

test.each([
  ["ground.bmp", bitmap()],
  ["ground.ppm", pixmap()],
])("a picture, %s, lies where its map-info file says, the right way up, and can be hidden", async (name, picture) => {
  const { console } = await begin({ mission: "demo_c", prepare: (project) => withPicture(project, name, picture) });
  await console.reaches("Ready");
  // A picture is drawn a little paler than it is.
  const colour = async (x: number, y: number) => (await colorAt(console, x, y)).map((part) => (part > 128 ? 1 : 0));
  await expect.poll(() => colour(220, 30)).toEqual([1, 0, 0]);
  expect(await colour(850, 30)).toEqual([0, 1, 0]);
  expect(await colour(220, 780)).toEqual([0, 0, 1]);
  expect(await colour(60, 780)).toEqual([1, 1, 1]); // west of it
  const view = await console.panel("View");
  await view.getByText("Background picture").click();
  await expect.poll(() => colour(220, 30)).toEqual([1, 1, 1]);
});

test("each layer is switched off and on, and its switching undone by name", async () => {
  const { console } = await begin({ mission: "demo_c", prepare: (project) => withPicture(project) });
  const { page } = console;
  await console.reaches("Ready");
  await console.panel("World");
  await console.button("Add object").click();
  await console.dragMap([550, 140], [580, 140]);
  await console.button(/^Undo add object/).waitFor();
  await console.button("Put the tool away").click();
  await console.panel("Mission");
  await console.startRobots();
  await console.setSpeed("×2"); // the first question comes at 17 s, and is none of this
  await console.main.click();
  await console.passes(4);
  await console.main.filter({ hasText: "Pause" }).click();
  await console.reaches("Paused");
  await console.select("Robot 1");
  const view = await console.panel("View");
  for (const layer of ["Formation stations", "Movement vectors"]) await view.getByText(layer).click();
  await page.mouse.move(640, 799);
  await console.camera();
  const box = await console.map.boundingBox();
  if (!box) throw new Error("the map is not shown");
  const shown = async () => (await page.screenshot({ clip: box })).toString("base64");
  let all = "";
  // Until nothing moves any more.
  await expect
    .poll(async () => {
      const before = all;
      all = await shown();
      return all === before;
    })
    .toBe(true);

  const names = [
    "Background picture",
    "Grid",
    "Control measures",
    "Obstacles",
    "Objects",
    "Names",
    "Robots",
    "Formation stations",
    "Movement vectors",
    "Scale and compass",
  ];
  for (const name of names) {
    const layer = view.getByRole("switch", { name, exact: true });
    expect(await layer.isChecked(), name).toBe(true);
    await view.getByText(name, { exact: true }).click();
    await expect.poll(async () => (await shown()) !== all, { message: `${name} hidden` }).toBe(true);
    await console.button(`Undo hide ${name.toLowerCase()}`).click();
    await page.mouse.move(640, 799);
    await expect.poll(async () => (await shown()) === all, { message: `${name} shown again` }).toBe(true);
  }
});

test("the coordinates under the pointer are told, and hidden when it leaves the map", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const readout = page.locator(".map-place");
  for (const [x, y] of [
    [500, 140],
    [930, 640],
  ] as const) {
    const at = await console.onPage(x, y);
    await page.mouse.move(at.x, at.y);
    const text = (await readout.textContent()) ?? "";
    const [east = Number.NaN, north = Number.NaN] = text.split(",").map(Number.parseFloat);
    expect(Math.abs(east - x)).toBeLessThan(2);
    expect(Math.abs(north - y)).toBeLessThan(2);
  }
  await page.mouse.move(20, 400);
  await expect.poll(() => readout.isVisible()).toBe(false);
});

test("distances and bearings are measured by mouse and by keys", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  await page.getByRole("toolbar", { name: "Map tools" }).getByRole("button", { name: "Measure" }).click();
  const words = page.getByRole("region", { name: "Measure" }).getByRole("status");
  await words.getByText("Click, or").waitFor();
  const click = async (x: number, y: number, clicks = 1) => {
    const at = await console.onPage(x, y);
    await page.mouse.move(at.x, at.y);
    await page.mouse.click(at.x, at.y, { clickCount: clicks });
  };
  await click(400, 300);
  await click(600, 300);
  expect(Number.parseFloat((await words.textContent()) ?? "")).toBeCloseTo(200, -1);
  expect(await words.textContent()).toContain("bearing 090°");
  const at = await console.onPage(600, 500);
  await page.mouse.dblclick(at.x, at.y);
  await words.getByText(/whole/).waitFor();
  expect(await words.textContent()).toContain("bearing 000°");
  expect(Number.parseFloat(((await words.textContent()) ?? "").split("whole")[1] ?? "")).toBeCloseTo(400, -1);

  // The next line, by keys alone: from the middle of the map to one that lies east of it.
  await console.map.focus();
  await page.keyboard.press("Escape");
  await words.getByText("Click, or").waitFor();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await console.camera();
  await page.keyboard.press("Enter");
  await words.getByText("bearing 090°").waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await words.waitFor({ state: "detached" });
});
