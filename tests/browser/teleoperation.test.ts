import type { Locator } from "playwright-core";
import { expect, test } from "vitest";
import { begin } from "./begin.ts";
import type { Console } from "./console.ts";

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

/** Steers all, on a run that goes on. @returns the card of the unit */
async function steerScouts(console: Console): Promise<Locator> {
  await console.setSpeed("×1");
  await console.startRobots();
  await console.select("scouts");
  const steer = await console.panel("Teleoperation");
  await steer.getByRole("button", { name: "Steer scouts" }).click();
  const card = steer.getByRole("region", { name: "Teleoperation of scouts" });
  await card.getByText("as on the map").click();
  if (await console.state.filter({ hasText: "Paused" }).isVisible()) await console.page.keyboard.press("x");
  return card;
}

test("a key that is down when the window loses the focus is let go", async () => {
  const { console } = await begin({ mission: "demo_c" });
  const card = await steerScouts(console);
  await card.getByRole("application", { name: "Stick of scouts" }).focus();
  await console.page.keyboard.down("w");
  await card.getByText(/by keys/).waitFor();
  // Nobody sees the key go up.
  await console.page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await card.getByText("let go: stands").waitFor();
  await card.getByText("0.0 m/s").waitFor();
  await console.page.keyboard.up("w");
});

test("a gamepad steers while a shoulder button is held, and only then", async () => {
  const { console } = await begin({
    mission: "demo_c",
    before: () => {
      const pad = { connected: true, index: 0, axes: [0, 0], buttons: Array.from({ length: 16 }, () => released()) };
      function released() {
        return { pressed: false, touched: false, value: 0 };
      }
      Object.assign(window, { pad });
      navigator.getGamepads = () => [pad as unknown as Gamepad];
    },
  });
  const { page } = console;
  const hold = (east: number, held: boolean) =>
    page.evaluate(
      ([x, down]) => {
        const { pad } = window as unknown as { pad: { axes: number[]; buttons: { pressed: boolean }[] } };
        pad.axes[0] = x as number;
        (pad.buttons[5] as { pressed: boolean }).pressed = down as boolean;
      },
      [east, held],
    );
  const card = await steerScouts(console);
  const before = await console.place("Robot 1");
  // The stick alone does nothing: the dead-man's switch is not held.
  await hold(1, false);
  await console.passes(2);
  await card.getByText("let go: stands").waitFor();
  expect(Math.abs((await console.place("Robot 1")).x - before.x)).toBeLessThan(2);

  await hold(1, true);
  await card.getByText(/by gamepad/).waitFor();
  await expect.poll(async () => (await console.place("Robot 1")).x, { timeout: 60_000 }).toBeGreaterThan(before.x + 5);
  await hold(1, false);
  await card.getByText("let go: stands").waitFor();
  await card.getByText("0.0 m/s").waitFor();
});
