import { expect, test } from "vitest";
import { begin } from "./begin.ts";

test("a panel that is hidden by its key comes back by undo, which names it", async () => {
  const { console } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  await console.steps.waitFor();
  await console.page.keyboard.press("1");
  await console.steps.waitFor({ state: "detached" });
  await console.button("Undo hide Mission").click();
  await console.steps.waitFor();
  expect(await console.button("Redo hide Mission").isEnabled()).toBe(true);
});
