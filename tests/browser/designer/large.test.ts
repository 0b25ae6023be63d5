// Large pages: their wires can be seen, from far away and near, and what is wide opens so that it can be read.
import { expect, test } from "vitest";
import { wiresInSight } from "../../../web/tools/wires.mjs";
import { begin, type DesignerPage } from "./designer.ts";

const kFullHd = { width: 1920, height: 1080 };

async function open(members: string[], size = kFullHd): Promise<DesignerPage> {
  const text = ["assemblage Many() {", "  cooperate {", ...members, "  }", "}", ""].join("\n");
  const { designer } = await begin({
    file: "many.cdl",
    prepare: (project) => project.write("many.cdl", text),
    ...size,
  });
  await designer.on("Many");
  return designer;
}

/** `members`: of each of them. */
function sums(count: number, members: number): string[] {
  const noise = (i: number) => `      ${i + 1}: Noise(persistence = ${i + 1} s);`;
  const sum = ["    1: cooperate {", ...Array.from({ length: members }, (_, i) => noise(i)), "    };"];
  return Array.from({ length: count }, () => sum).flat();
}

function zoom({ page }: DesignerPage): Promise<number> {
  return page.evaluate(
    () => new DOMMatrix(getComputedStyle(document.querySelector(".react-flow__viewport")!).transform).a,
  );
}

// Ten of ten: 111 wires, each drawn by itself; 30 of ten: more than 300 nodes, whose wires are drawn in one piece from afar.
test.each([
  { count: 10, wires: 111 },
  { count: 30, wires: 331 },
])("every one of $wires wires is seen from far away, and where one comes near", async ({ count, wires }) => {
  const designer = await open(sums(count, 10));
  const { page, canvas } = designer;
  await page.locator("body").press("f");
  await expect.poll(() => wiresInSight(page)).toMatchObject({ wires, loose: 0, bare: 0, nodes: wires + 1 });
  const { x, y, width, height } = (await canvas.boundingBox())!;
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.keyboard.down("Control");
  for (let i = 0; i < 20 && (await zoom(designer)) >= 0.11; ++i) await page.mouse.wheel(0, 200);
  await page.keyboard.up("Control");
  expect(await zoom(designer)).toBeLessThan(0.12);
  await expect.poll(() => wiresInSight(page)).toMatchObject({ wires, loose: 0, bare: 0, nodes: wires + 1 });
  await page.locator("body").press("1");
  await expect.poll(() => zoom(designer)).toBe(1);
  await expect.poll(() => wiresInSight(page)).toMatchObject({ loose: 0, bare: 0 });
  await expect.poll(async () => (await wiresInSight(page)).wires).toBeGreaterThan(4);
});

test.each([12, 100])("a sum of %i opens in columns, so that it can be read", async (count) => {
  const designer = await open(Array.from({ length: count }, (_, i) => `    1: Noise(persistence = ${i + 1} s);`));
  const { page } = designer;
  const letters = await page.evaluate(() => {
    const title = document.querySelector<HTMLElement>(".node-title, .node-far")!;
    const zoomed = title.getBoundingClientRect().height / title.offsetHeight;
    return Number.parseFloat(getComputedStyle(title).fontSize) * zoomed;
  });
  expect(letters).toBeGreaterThan(6.4);
  await expect.poll(async () => (await wiresInSight(page)).wires).toBeGreaterThan(10);
  await expect.poll(() => wiresInSight(page)).toMatchObject({ loose: 0, bare: 0 });
  const lefts = await page
    .locator(".react-flow__node")
    .evaluateAll((nodes) => new Set(nodes.map((node) => Math.round(node.getBoundingClientRect().right))).size);
  if (count > 12) expect(lefts).toBeGreaterThanOrEqual(4);
});
