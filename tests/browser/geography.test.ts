// Places on the Earth, and a map of it below ours.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inflateSync } from "node:zlib";
import { expect, onTestFinished, test } from "vitest";
import { begin, type Project } from "./begin.ts";
import type { Console } from "./console.ts";
import { picture } from "./picture.ts";

const kOrigin = 'ORIGIN GEO "48.2082 N 16.3738 E"';
// 48.2117971 N 16.3805277 E.
const kMiddle = { x: 500, y: 400 };
// Where nothing else is drawn.
const kMarked = { x: 255, y: 345 };

/** Squares of zoom 13 to 17: green and sand as a board, with a red disc 255 m east and 345 m north of the origin. */
const kMakeTiles = `
import math, sqlite3, struct, sys, zlib
def png(pixel):
    rows = b"".join(b"\\0" + b"".join(bytes(pixel(x, y)) for x in range(256)) for y in range(256))
    part = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\\x89PNG\\r\\n\\x1a\\n" + part(b"IHDR", struct.pack(">IIBBBBB", 256, 256, 8, 2, 0, 0, 0)) + part(b"IDAT", zlib.compress(rows, 1)) + part(b"IEND", b"")
lat, lon = 48.2082 + 345 / 111198.4, 16.3738 + 255 / 74372.3
base = sqlite3.connect(sys.argv[1])
base.executescript("CREATE TABLE metadata (name text, value text); CREATE TABLE tiles (zoom_level integer, tile_column integer, tile_row integer, tile_data blob);")
base.executemany("INSERT INTO metadata VALUES (?, ?)", [("format", "png"), ("minzoom", "13"), ("maxzoom", "17"), ("attribution", "<b>&copy; Surveyors</b>")])
board = [png(lambda x, y, c=c: (60, 60, 60) if x < 2 or y < 2 else c) for c in ((120, 190, 120), (225, 205, 150))]
for zoom in range(13, 18):
    side = 2 ** zoom
    fx, fy = (lon + 180) / 360 * side, (1 - math.asinh(math.tan(math.radians(lat))) / math.pi) / 2 * side
    px, py = (fx % 1) * 256, (fy % 1) * 256
    reach = 12 if zoom > 14 else 2
    for column in range(int(fx) - reach, int(fx) + reach + 1):
        for row in range(int(fy) - reach, int(fy) + reach + 1):
            tile = board[(column + row) % 2]
            if (column, row) == (int(fx), int(fy)):
                tile = png(lambda x, y: (220, 0, 0) if math.hypot(x - px, y - py) < 16 * side / 65536 else (120, 190, 120))
            base.execute("INSERT INTO tiles VALUES (?, ?, ?, ?)", (zoom, column, side - 1 - row, tile))
base.commit()
`;

function onTheEarth(project: Project): void {
  project.write("democ.odl", project.read("democ.odl").replace("CONTROL MEASURES:", `${kOrigin}\n\n$&`));
}

/** A file that goes with the test. */
function makeTiles(): string {
  const folder = mkdtempSync(join(tmpdir(), "mlab-tiles-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  const file = join(folder, "map.mbtiles");
  execFileSync("python3", ["-c", kMakeTiles, file]);
  return file;
}

/** Red, green and blue [0 .. 255] at a place of the world. */
async function colorAt(console: Console, x: number, y: number): Promise<[number, number, number]> {
  const at = await console.onPage(x, y);
  const clip = { x: Math.round(at.x), y: Math.round(at.y), width: 1, height: 1 };
  const png = await console.page.screenshot({ clip });
  const parts: Buffer[] = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  // One pixel: after the byte that names the filter come its colours as they are.
  const [red = 0, green = 0, blue = 0] = inflateSync(Buffer.concat(parts)).subarray(1, 4);
  return [red, green, blue];
}

async function isRed(console: Console, x: number, y: number): Promise<boolean> {
  const [red, green, blue] = await colorAt(console, x, y);
  return red > green + 60 && red > blue + 60;
}

test("places are told and copied in the notation that was chosen, also after a reload", async () => {
  const { console } = await begin({ mission: "demo_c", prepare: onTheEarth });
  const { page } = console;
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await console.reaches("Ready");
  const readout = page.locator(".map-place");
  const point = async () => {
    const at = await console.onPage(kMiddle.x, kMiddle.y);
    await page.mouse.move(at.x - 1, at.y);
    await page.mouse.move(at.x, at.y);
  };
  await point();
  await expect.poll(() => readout.textContent()).toMatch(/ m$/);
  const view = await console.panel("View");
  for (const [notation, told] of [
    ["Degrees", /^48\.211\d{4} N 16\.380\d{4} E$/],
    ["Degrees, minutes, seconds", /^48°12'42\.\d{4}'' N 16°22'(?:49|50)\.\d{4}'' E$/],
    ["UTM", /^33N 60255\d\.\d\d 534076\d\.\d\d$/],
    ["MGRS", /^33UXP0255\d4076\d$/],
  ] as const) {
    await view.getByRole("button", { name: /Places$/ }).click();
    await page.getByRole("option", { name: notation, exact: true }).click();
    await point();
    await expect.poll(() => readout.textContent(), { message: notation }).toMatch(told);
  }
  await page.keyboard.press("Shift+C");
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toMatch(/^33UXP0255\d4076\d$/);
  // PP Charlie is 300 m east and 420 m north.
  await console.clickMap(300, 420);
  const selection = await console.panel("Selection");
  await selection.getByText("33UXP0235740778").waitFor();
  await selection.getByRole("button", { name: "Copy the place" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe("33UXP0235740778");
  await picture(page, "places");
  await page.reload();
  await console.reaches("Ready");
  await point();
  await expect.poll(() => readout.textContent()).toMatch(/^33UXP0255\d4076\d$/);
});

test("a map of the Earth lies below, in its place, and can be hidden", async () => {
  const { console, mlab } = await begin({
    mission: "demo_c",
    prepare: onTheEarth,
    options: ["--tiles", makeTiles()],
  });
  const { page } = console;
  expect(mlab.output).not.toContain("warning");
  await console.reaches("Ready");
  await expect.poll(() => isRed(console, kMarked.x, kMarked.y)).toBe(true);
  // It is 25 m from its middle to its edge on the ground, and a pixel is up to 2 m.
  for (const [dx, dy, red] of [
    [18, 0, true],
    [0, -18, true],
    [33, 0, false],
    [0, 33, false],
    [-33, 0, false],
  ] as const)
    expect(await isRed(console, kMarked.x + dx, kMarked.y + dy), `${dx} ${dy}`).toBe(red);
  expect(await page.locator(".map-attribution").textContent()).toBe("© Surveyors");
  await picture(page, "tiles");
  const view = await console.panel("View");
  await view.getByText("Dark", { exact: true }).click();
  await expect.poll(() => isRed(console, kMarked.x, kMarked.y)).toBe(true);
  await picture(page, "tiles_dark");
  await view.getByText("Light", { exact: true }).click();
  await view.getByText("Map of the Earth", { exact: true }).click();
  await expect.poll(() => isRed(console, kMarked.x, kMarked.y)).toBe(false);
  expect(await page.locator(".map-attribution").isVisible()).toBe(false);
  await view.getByText("Map of the Earth", { exact: true }).click();
  await page.setViewportSize({ width: 390, height: 844 });
  await view.getByRole("button", { name: "Close View" }).click();
  await page.locator(".map-attribution").waitFor();
  await picture(page, "tiles_narrow");
});

test("a map that lies nowhere has no tiles, which is told", async () => {
  const { console, mlab } = await begin({ mission: "demo_c", options: ["--tiles", makeTiles()] });
  expect(mlab.output).toContain("does not say where it lies on the Earth");
  await console.reaches("Ready");
  const view = await console.panel("View");
  await view.getByText("The overlay does not say where it lies").waitFor();
  expect(await console.page.locator(".map-attribution").isVisible()).toBe(false);
});
