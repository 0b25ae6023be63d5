// Pages of states: what is written at transitions can be read, and lies on nothing.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";

const corpus =
  process.env.MLAB_CORPUS ?? join(process.env.MLAB_ROOT ?? join(import.meta.dirname, "../../.."), "../shared/corpus");
const configurations = join(corpus, "configurations");

/** What lies on each other, in words; and how large the labels' letters are on the screen [px]. */
function looked({ page }: DesignerPage): Promise<{ over: string[]; labels: number; font: number; short: number }> {
  return page.evaluate(() => {
    const boxOf = (element: Element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { left: x + 1, top: y + 1, right: x + width - 1, bottom: y + height - 1 };
    };
    type Box = ReturnType<typeof boxOf>;
    const isOver = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    const labels = [...document.querySelectorAll<HTMLElement>(".transition-label")];
    const boxes = labels.map((label) => ({ id: label.dataset.transition ?? "", box: boxOf(label) }));
    const states = [...document.querySelectorAll(".state")].map((state) => ({
      id: state.textContent,
      box: boxOf(state),
    }));
    const ways = [...document.querySelectorAll<HTMLElement>(".react-flow__edge")].map((edge) => {
      const path = edge.querySelector("path")!;
      const [length, matrix] = [path.getTotalLength(), path.getScreenCTM()!];
      const points = Array.from({ length: 81 }, (_, i) =>
        path.getPointAtLength((length * i) / 80).matrixTransform(matrix),
      );
      return { id: edge.dataset.id ?? "", points };
    });
    const over: string[] = [];
    boxes.forEach(({ id, box }, i) => {
      for (const state of states) if (isOver(box, state.box)) over.push(`${id} on state ${state.id}`);
      for (const other of boxes.slice(0, i)) if (isOver(box, other.box)) over.push(`${id} on label ${other.id}`);
      for (const way of ways) {
        const passes = way.points.some(({ x, y }) => x > box.left && x < box.right && y > box.top && y < box.bottom);
        if (way.id !== id && passes) over.push(`${id} on the way of ${way.id}`);
      }
    });
    const fonts = labels.map(
      (label) =>
        Number.parseFloat(getComputedStyle(label).fontSize) *
        (label.getBoundingClientRect().height / label.offsetHeight),
    );
    const short = labels.filter((label) =>
      label.querySelector<HTMLElement>(".transition-lines")?.dataset.lines?.includes("…"),
    ).length;
    return { over, labels: labels.length, font: Math.min(...fonts), short };
  });
}

test("the states of the forage example are read without touching anything", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  await designer.toDeclaration("Forage");
  await designer.node("Searching").waitFor();
  await expect.poll(async () => (await looked(designer)).labels).toBe(8);
  await expect.poll(() => looked(designer)).toMatchObject({ over: [], short: 0 });
  expect((await looked(designer)).font).toBeGreaterThanOrEqual(9.5);
});

for (const [file, declaration] of [
  ["mars2020_demos__recov", "recovRobot1_movement"],
  ["usability_demos-1997__Task3__new_example", "exampleRobot1_movement"],
  ["usability_demos-2000__robots__Sentry", "SentryRobot1_movement"],
  ["honda_demos__sound_demo_motivated", "sound_demo_motivatedRobot1_movement"],
] as const) {
  const path = join(configurations, `${file}.cdl`);
  // Without the corpus the test is listed as skipped.
  test.skipIf(!existsSync(path))(`no label lies on anything: ${file}`, async () => {
    const { designer } = await begin({
      file: "one.cdl",
      prepare: (project) => project.write("one.cdl", readFileSync(path)),
    });
    await designer.on("");
    await designer.details.getByRole("button", { name: declaration, exact: true }).click();
    await designer.on(declaration);
    await designer.page.locator(".transition-label").first().waitFor();
    await expect.poll(async () => (await looked(designer)).over).toEqual([]);
    expect((await looked(designer)).font).toBeGreaterThanOrEqual(8);
  });
}
