import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import type { Console } from "./console.ts";

async function obstacles(console: Console): Promise<number> {
  const panel = await console.panel("World");
  const text = (await panel.getByRole("heading", { name: /obstacles?, / }).textContent()) ?? "";
  return Number.parseInt(text, 10);
}

test("an obstacle is added, moved and removed during a run, undone and redone by name, and saved", async () => {
  const { console, project } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.main.click();
  await console.reaches("Running");
  const world = await console.panel("World");
  const first = await obstacles(console);
  const before = project.read("democ.odl");

  await world.getByRole("button", { name: "Add obstacle" }).click();
  await console.dragMap([500, 140], [520, 140]);
  await expect.poll(() => obstacles(console)).toBe(first + 1);
  await console.button(/^Undo add obstacle/).waitFor();
  const thing = world.getByRole("region", { name: "Selected thing" });
  await expect.poll(() => thing.getByLabel("x [m]").inputValue()).toBe("500");
  await expect.poll(() => thing.getByLabel("y [m]").inputValue()).toBe("140");

  await world.getByRole("button", { name: "Move and resize" }).click();
  await console.dragMap([500, 140], [600, 160]);
  await expect.poll(() => thing.getByLabel("x [m]").inputValue()).toBe("600");
  await console.button(/^Undo move/).click();
  await expect.poll(() => thing.getByLabel("x [m]").inputValue()).toBe("500");
  await console.button(/^Redo move/).click();
  await expect.poll(() => thing.getByLabel("x [m]").inputValue()).toBe("600");

  expect(project.read("democ.odl")).toBe(before);
  await console.button("Not saved").click();
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("democ.odl")).toMatch(/OBSTACLE 600 160 20\b/);
  // What else stands in the text stays as it was.
  expect(project.read("democ.odl")).toContain("-- Rocks beside the way");

  await thing.getByRole("button", { name: "Remove" }).click();
  await expect.poll(() => obstacles(console)).toBe(first);
  await console.button(/^Undo remove/).waitFor();
  await page.keyboard.press("Control+s");
  await expect.poll(() => project.read("democ.odl")).not.toMatch(/OBSTACLE 600 160/);
});

test("random obstacles come from a seed, and the same seed gives the same", async () => {
  const texts: string[] = [];
  for (let i = 0; i < 2; ++i) {
    const { console, project } = await begin({ mission: "demo_c" });
    const { page } = console;
    await console.reaches("Ready");
    const world = await console.panel("World");
    const first = await obstacles(console);
    await world.getByRole("button", { name: "Random obstacles…" }).click();
    const dialog = page.getByRole("dialog", { name: "Random obstacles" });
    await dialog.getByLabel("Smallest radius [m]").fill("4");
    await dialog.getByLabel("Largest radius [m]").fill("9");
    await dialog.getByLabel("Seed").fill("42");
    await dialog.getByRole("button", { name: /^(Add|Replace) obstacles$/ }).click();
    await dialog.waitFor({ state: "detached" });
    await expect.poll(() => obstacles(console)).not.toBe(first);
    await page.keyboard.press("Control+s");
    await console.button("Not saved").waitFor({ state: "detached" });
    texts.push(project.read("democ.odl"));
  }
  expect(texts[0]).toMatch(/OBSTACLE/);
  expect(texts[1]).toBe(texts[0]);
});
