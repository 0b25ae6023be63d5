// Told outside of the page: what the browser is asked to sound and to show.
import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("questions sound and are shown by the desktop once that is switched on, and not before", async () => {
  const { console } = await begin({
    mission: "demo_c",
    before: () => {
      const told: string[] = [];
      class Shown {
        static permission = "default";
        static requestPermission = async () => {
          Shown.permission = "granted";
          return "granted";
        };
        onclick: unknown = null;
        constructor(title: string, { body }: { body: string }) {
          told.push(`${title}: ${body}`);
        }
        close() {}
      }
      let tones = 0;
      const create = AudioContext.prototype.createOscillator;
      AudioContext.prototype.createOscillator = function () {
        ++tones;
        return create.call(this);
      };
      Object.assign(window, { Notification: Shown, told, tones: () => tones });
    },
  });
  const { page } = console;
  const told = () => page.evaluate(() => (window as unknown as { told: string[] }).told);
  const tones = () => page.evaluate(() => (window as unknown as { tones: () => number }).tones());
  await console.reaches("Ready");
  await console.setSpeed("Max");
  await console.main.click();
  const proceed = console.questions.getByRole("button", { name: /^PROCEED/ });
  await proceed.first().waitFor();
  expect(await told()).toEqual([]);
  expect(await tones()).toBe(0);

  const view = await console.panel("View");
  await view.getByText("Sound and desktop notification").click();
  const before = await tones();
  expect(await told()).toEqual([]); // what was there is known
  await proceed.first().click();
  await expect.poll(told, { timeout: 60_000 }).toHaveLength(1);
  expect((await told())[0]).toMatch(/^Question of /);
  expect(await tones()).toBeGreaterThan(before);
});
