// Pages of states: what is written at transitions can be read, and lies on nothing.
import { expect, test } from "vitest";
import { begin } from "./designer.ts";
import { looked } from "./looked.ts";

test("the states of the forage example are read without touching anything", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  await designer.toDeclaration("Forage");
  await designer.node("Searching").waitFor();
  await expect.poll(async () => (await looked(designer)).labels).toBe(8);
  await expect.poll(() => looked(designer)).toMatchObject({ over: [], short: 0 });
  expect((await looked(designer)).font).toBeGreaterThanOrEqual(9.5);
});

test("a long row of states that all lead back to the first is folded, so that it can be read", async () => {
  const count = 60;
  const state = (i: number) => [
    `    ${i === 0 ? "start " : ""}Step${i}: Noise(persistence = 1 s);`,
    ...(i + 1 < count ? [`      when Wait(delay = 10 s) goto Step${i + 1};`] : []),
    ...(i > 0 ? ["      when Wait(delay = 90 s) goto Step0;"] : []),
  ];
  const text = ["assemblage Many() {", "  sequence {", ...Array.from({ length: count }, (_, i) => state(i)).flat()];
  const { designer } = await begin({
    file: "many.cdl",
    prepare: (project) => project.write("many.cdl", [...text, "  }", "}", ""].join("\n")),
  });
  await designer.on("Many");
  const { over, nodes } = await looked(designer);
  expect(nodes).toBe(count);
  expect(over.filter((one) => !one.startsWith("label"))).toEqual([]);
  const { width, height } = (await designer.node("Step0").boundingBox())!;
  expect(Math.min(width, height)).toBeGreaterThan(16); // in one row it would be 2 px high
});

test("a file of which nothing can be read says so where the drawing would be, and leads to the reason", async () => {
  const { designer } = await begin({
    file: "broken.cdl",
    prepare: (project) => project.write("broken.cdl", "assemblage {{{\n"),
  });
  await designer.page.getByRole("heading", { name: "Nothing can be drawn of this text" }).waitFor();
  await designer.button("Show why").click();
  await designer.problems.getByRole("button").first().waitFor();
  await expect.poll(() => designer.text.textContent()).toContain("assemblage {{{");
});
