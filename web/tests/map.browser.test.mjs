// The map in a real browser, on the gallery's page: what is drawn where, and what pointer and keys do.
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { openBrowser } from "../tools/browser.mjs";
import { serve } from "../tools/serve.mjs";

const web = dirname(dirname(fileURLToPath(import.meta.url)));
let server;
let browser;
let withGl;

beforeAll(async () => {
  server = await serve(web);
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  await withGl?.close();
  await server?.close();
});

async function open(query, from = browser, density = 1) {
  const page = await from.page({ width: 1000, height: 700, density });
  await page.goto(`${server.address}gallery.html?${query}`);
  await page.waitForSelector("body[data-drawn]");
  return page;
}

const selected = (page) => page.evaluate(() => window.model.get("selection").robots);
const camera = (page) => page.evaluate(() => ({ ...window.map.camera.saved() }));
/** Where a robot is on the screen. */
const robotAt = (page, id) => page.evaluate((robot) => window.map.camera.toScreen(window.model.placeOf(robot)), id);

/** Share of the robots whose colour is seen at their places, on the layers as they are. */
function seen(page) {
  return page.evaluate(async () => {
    const picture = await createImageBitmap(await window.map.toPng());
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const context = canvas.getContext("2d");
    context.drawImage(picture, 0, 0);
    const density = picture.width / window.map.camera.width;
    const { robots } = window.model;
    let found = 0;
    for (let row = 0; row < robots.count; ++row) {
      const { x, y } = window.map.camera.toScreen({ x: robots.x(row), y: robots.y(row) });
      const hex = window.model.get("roster").robot(robots.id(row)).color;
      const wanted = [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16));
      const { data } = context.getImageData(Math.round(x * density), Math.round(y * density), 1, 1);
      if (wanted.every((part, i) => Math.abs(part - data[i]) < 48)) ++found;
    }
    return { renderer: window.map.statistics().renderer, share: found / robots.count };
  });
}

describe("robots are drawn in their colours at their places", () => {
  test("by paths", async () => {
    const page = await open("scene=crowd&count=300");
    expect(await seen(page)).toMatchObject({ renderer: "canvas", share: expect.closeTo(1, 1) });
  });

  test("as blocks, where they are many and there is no graphics card", async () => {
    const page = await open("scene=crowd&count=1600");
    const { renderer, share } = await seen(page);
    expect(renderer).toBe("blocks");
    expect(share).toBeGreaterThan(0.8); // some lie below others, or below a name
  });

  test("by WebGL, at two device pixels for one", async () => {
    withGl ??= await openBrowser({ withGl: true });
    const page = await open("scene=crowd&count=400&renderer=webgl", withGl, 2);
    const { renderer, share } = await seen(page);
    expect(renderer).toBe("webgl");
    expect(share).toBeGreaterThan(0.9);
  });

  test("not by WebGL where a processor plays the graphics card", async () => {
    withGl ??= await openBrowser({ withGl: true });
    const page = await open("scene=crowd&count=1600", withGl);
    expect((await seen(page)).renderer).toBe("blocks");
  });
});

describe("selecting", () => {
  test("a click takes a robot, with shift another, on empty ground none", async () => {
    const page = await open("scene=everything");
    const [one, two] = [await robotAt(page, 1), await robotAt(page, 3)];
    await page.mouse.click(one.x, one.y);
    expect(await selected(page)).toEqual([1]);
    await page.keyboard.down("Shift");
    await page.mouse.click(two.x, two.y);
    await page.keyboard.up("Shift");
    expect(await selected(page)).toEqual([1, 3]);
    await page.mouse.click(20, 20);
    expect(await selected(page)).toEqual([]);
  });

  test("a box takes the robots in it, a double click a whole unit, Escape nothing", async () => {
    const page = await open("scene=everything");
    const [one, two] = [await robotAt(page, 1), await robotAt(page, 3)];
    await page.mouse.move(one.x - 12, one.y - 30);
    await page.mouse.down();
    await page.mouse.move(two.x + 12, two.y + 30, { steps: 4 });
    await page.mouse.up();
    expect(await selected(page)).toEqual([1, 2, 3]);
    await page.mouse.dblclick(one.x, one.y);
    expect(await selected(page)).toHaveLength(8);
    await page.keyboard.press("Escape");
    expect(await selected(page)).toEqual([]);
  });

  test("another click on the same place takes what lies below", async () => {
    const page = await open("scene=everything");
    const at = await page.evaluate(() => window.map.camera.toScreen({ x: 540, y: 75 }));
    const kinds = [];
    for (let i = 0; i < 2; ++i) {
      await page.mouse.click(at.x, at.y);
      kinds.push(await page.evaluate(() => window.model.get("selection").items[0]?.index));
      await page.waitForTimeout(600); // no double click
    }
    expect(kinds[0]).toBeDefined();
    const near = await page.evaluate((place) => window.map.picksAt(place, 4).length, at);
    expect(kinds[1] === kinds[0]).toBe(near === 1);
  });
});

describe("moving about", () => {
  test("the wheel zooms about the pointer", async () => {
    const page = await open("scene=demo-c");
    const before = await page.evaluate(() => window.map.camera.toWorld({ x: 300, y: 200 }));
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, -240);
    await page.waitForFunction((scale) => window.map.camera.scale > scale * 1.2, (await camera(page)).scale / 1.3);
    const after = await page.evaluate(() => window.map.camera.toWorld({ x: 300, y: 200 }));
    expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeLessThan(1e-6);
  });

  test("the right button drags the map, space and the left one too", async () => {
    const page = await open("scene=demo-c");
    const drag = async (button) => {
      const before = await camera(page);
      await page.mouse.move(400, 300);
      await page.mouse.down({ button });
      await page.mouse.move(450, 280, { steps: 3 });
      await page.mouse.up({ button });
      const after = await camera(page);
      return [(before.x - after.x) * after.scale, (after.y - before.y) * after.scale].map(Math.round);
    };
    expect(await drag("right")).toEqual([50, -20]);
    await page.locator("#map").focus();
    await page.keyboard.down(" ");
    expect(await drag("left")).toEqual([50, -20]);
    await page.keyboard.up(" ");
  });

  test("keys pan, zoom and fit", async () => {
    const page = await open("scene=demo-c");
    await page.locator("#map").focus();
    const start = await camera(page);
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("+");
    const moved = await camera(page);
    expect(moved.x).toBeGreaterThan(start.x);
    expect(moved.y).toBeGreaterThan(start.y);
    expect(moved.scale / start.scale).toBeCloseTo(Math.SQRT2);
    await page.keyboard.press("f");
    expect(await camera(page)).toEqual(start);
  });

  test("a followed robot stays in the middle, until the map is dragged", async () => {
    const page = await open("scene=demo-c");
    await page.evaluate(() => {
      window.map.framing.follow({ robot: 2 });
      window.map.draw();
    });
    const { x, y } = await camera(page);
    const place = await page.evaluate(() => window.model.placeOf(2));
    expect(Math.hypot(x - place.x, y - place.y)).toBeLessThan(0.5);
    await page.evaluate(() => window.map.framing.pan(10, 0));
    expect(await page.evaluate(() => window.map.framing.following)).toBeNull();
  });

  test("the pointer's place in the world is told", async () => {
    const page = await open("scene=demo-c");
    const at = await page.evaluate(() => window.map.camera.toScreen({ x: 500, y: 300 }));
    await page.mouse.move(at.x, at.y);
    const [x, y] = (await page.locator(".map-place").textContent()).match(/-?\d+(\.\d+)?/g).map(Number);
    expect(Math.abs(x - 500) + Math.abs(y - 300)).toBeLessThan(3);
  });
});
