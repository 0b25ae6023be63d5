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
