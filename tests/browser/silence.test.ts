// A server that is there and does not answer: nothing on the page may look as if all was well.
import { expect, onTestFinished, test } from "vitest";
import { begin, look } from "./begin.ts";
import { Console } from "./console.ts";
import { openPage } from "./open_page.ts";
import { SwallowingLine } from "./swallowing.ts";

const isGrey = (console: Console, selector: string) =>
  console.page.locator(selector).evaluate((element) => getComputedStyle(element).filter.includes("grayscale"));

async function seconds(console: Console): Promise<number> {
  const text = (await console.page.getByTestId("silence").textContent()) ?? "";
  return Number(/No answer for (\d+) s/.exec(text)?.[1] ?? 0);
}

test("a server that was stopped is told as silent, and the emergency stop as sent until it is confirmed", async () => {
  const { console, mlab } = await begin({ mission: "demo_c", options: ["--speed", "1"] });
  await console.main.click();
  await console.reaches("Running");
  await console.passes(1);
  expect(await console.page.getByTestId("silence").count()).toBe(0);
  expect(await isGrey(console, ".dock.left")).toBe(false);

  mlab.freeze();
  await console.page.getByTestId("silence").waitFor();
  await console.reaches("No answer");
  expect(await isGrey(console, ".dock.left")).toBe(true);
  expect(await isGrey(console, ".map")).toBe(true);
  // On a telephone it lies over the map, which is not to be seen through it.
  expect(await console.page.locator(".dock.left").evaluate((one) => getComputedStyle(one).opacity)).toBe("1");
  const first = await seconds(console);
  expect(first).toBeGreaterThanOrEqual(1);
  await expect.poll(() => seconds(console)).toBeGreaterThan(first + 1);

  await console.stop.click();
  await console.stop.getByText("sent, not confirmed").waitFor();
  await console.page.getByText("EMERGENCY STOP sent, not confirmed.").waitFor();
  expect(await console.page.getByText("all robots stand and take no orders").count()).toBe(0);

  mlab.thaw();
  await console.stop.getByText("confirmed: all 4 stand").waitFor();
  await console.reaches("Emergency stop");
  await console.page.getByTestId("silence").waitFor({ state: "detached" });
  expect(await isGrey(console, ".dock.left")).toBe(false);
});

test("a line that swallows everything is told as silent, given up, and a stop is sent again by the next", async () => {
  const { console: direct, mlab } = await begin({ mission: "demo_c", options: ["--speed", "1"] });
  const line = await SwallowingLine.to(mlab.url);
  onTestFinished(() => line.close());
  const page = await openPage();
  onTestFinished(() => page.context().close());
  const far = new Console(page);
  await page.goto(line.url);
  await far.reaches("Ready");
  await direct.main.click();
  await far.reaches("Running");

  line.swallow();
  await far.page.getByTestId("silence").waitFor();
  await far.reaches("No answer");
  await far.stop.click();
  await far.stop.getByText("sent, not confirmed").waitFor();
  await direct.reaches("Running");

  line.heal();
  await far.stop.getByText("confirmed: all 4 stand").waitFor({ timeout: 60_000 });
  await far.page.getByTestId("silence").waitFor({ state: "detached" });
  await direct.reaches("Emergency stop");
});

test("a page whose scripts stand still stays the operator, and its run goes on", async () => {
  const { console, mlab } = await begin({ mission: "demo_c", options: ["--speed", "1"] });
  await console.main.click();
  await console.reaches("Running");
  const debug = await console.page.context().newCDPSession(console.page);
  await debug.send("Debugger.enable");
  const paused = new Promise((resolve) => debug.once("Debugger.paused", resolve));
  await debug.send("Debugger.pause");
  await paused;
  const other = await look(mlab);
  await other.watching.waitFor();
  await other.passes(3);
  await other.reaches("Running");
  await debug.send("Debugger.resume");
  await console.reaches("Running");
  expect(await console.main.filter({ hasText: "Pause" }).isEnabled()).toBe(true);
  expect(await console.watching.count()).toBe(0);
});
