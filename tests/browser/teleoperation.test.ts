import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a unit is steered by the stick, and stands when it is let go", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.setSpeed("×1");
  await console.startRobots();
  await console.select("scouts-1");
  const steer = await console.panel("Teleoperation");
  await steer.getByRole("button", { name: "Steer scouts-1" }).click();
  const card = steer.getByRole("region", { name: "Teleoperation of scouts-1" });
  await card.waitFor();
  await card.getByText("as on the map").click();
  if (await console.state.filter({ hasText: "Paused" }).isVisible()) await page.keyboard.press("x");
  const before = await console.place("Robot 1");

  const stick = card.getByRole("application", { name: "Stick of scouts-1" });
  const box = await stick.boundingBox();
  if (!box) throw new Error("there is no stick");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + box.width / 2, y, { steps: 5 });
  await card.getByText(/by pointer/).waitFor();
  // To the right is east on the map.
  await expect.poll(async () => (await console.place("Robot 1")).x, { timeout: 60_000 }).toBeGreaterThan(before.x + 5);
  await page.mouse.up();
  await card.getByText("let go: stands").waitFor();
  await card.getByText("0.0 m/s").waitFor();
  const stands = await console.place("Robot 1");
  await console.passes(3);
  // Shown in whole metres.
  const later = await console.place("Robot 1");
  expect(Math.hypot(later.x - stands.x, later.y - stands.y)).toBeLessThan(2);

  await card.getByRole("button", { name: "End teleoperation" }).click();
  await card.waitFor({ state: "detached" });
});

test("keys steer while they are held, and only then", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.setSpeed("×1");
  await console.startRobots();
  await console.select("scouts");
  const steer = await console.panel("Teleoperation");
  await steer.getByRole("button", { name: "Steer scouts" }).click();
  const card = steer.getByRole("region", { name: "Teleoperation of scouts" });
  await card.getByText("as on the map").click();
  if (await console.state.filter({ hasText: "Paused" }).isVisible()) await page.keyboard.press("x");
  const before = await console.place("Robot 1");
  await card.getByRole("application", { name: "Stick of scouts" }).focus();
  await page.keyboard.down("ArrowUp");
  await card.getByText(/by keys/).waitFor();
  await expect.poll(async () => (await console.place("Robot 1")).y, { timeout: 60_000 }).toBeGreaterThan(before.y + 5);
  await page.keyboard.up("ArrowUp");
  await card.getByText("let go: stands").waitFor();
  await card.getByText("0.0 m/s").waitFor();
});
