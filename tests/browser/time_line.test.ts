// Other moments of a run than now, while it goes on.
import { expect, test } from "vitest";
import { begin, look } from "./begin.ts";
import type { Console } from "./console.ts";

const line = ({ page }: Console) => page.getByRole("region", { name: "Time line" });
const slider = (console: Console) => line(console).getByRole("slider", { name: "Moment of the run" });
const banner = ({ page }: Console) => page.getByRole("status").filter({ hasText: "You are looking at" });

/** That the line says is shown [s]. */
async function moment(console: Console): Promise<number> {
  const text = await line(console).getByRole("textbox", { name: "Time that is shown" }).inputValue();
  return text.split(":").reduce((sum, part) => sum * 60 + Number(part), 0);
}

/** Where in the whole run, 0 to 1. */
async function clickAt(console: Console, share: number): Promise<void> {
  const box = await slider(console).boundingBox();
  if (!box) throw new Error("the time line is not shown");
  await console.page.mouse.click(box.x + share * box.width, box.y + box.height / 3);
}

async function running(seconds: number): Promise<Console> {
  const { console } = await begin({ mission: "demo_c" });
  await console.main.click();
  await console.reaches("Running");
  await console.setSpeed("×10");
  await expect.poll(() => console.time()).toBeGreaterThan(seconds);
  return console;
}

test("one looks back while the run goes on, where nothing can be ordered, and returns to now", async () => {
  const console = await running(20);
  const { page } = console;
  await console.select("Robot 1");
  await slider(console).waitFor();
  expect(await slider(console).getAttribute("aria-valuetext")).toMatch(/^now, /);

  await clickAt(console, 0.5);
  await banner(console).waitFor();
  await expect.poll(() => slider(console).getAttribute("aria-valuetext")).not.toMatch(/^now/);
  await console.reaches("Was:");
  await expect.poll(async () => Math.abs((await console.time()) - (await moment(console)))).toBeLessThan(0.2);
  const place = await console.place("Robot 1");
  const at = await moment(console);

  // It stands there, and the run goes on.
  const goesOn = async () => Number((await slider(console).getAttribute("aria-valuemax")) ?? 0);
  const end = await goesOn();
  await expect.poll(goesOn).toBeGreaterThan(end + 5);
  expect(await moment(console)).toBe(at);
  expect(await console.place("Robot 1")).toEqual(place);

  // What orders says why it doesn't.
  expect(await console.button(/^Step: /).isDisabled()).toBe(true);
  await page.getByPlaceholder("You are looking at another moment: go back to now first.").waitFor();
  await page.getByRole("button", { name: /^Command \(not while another moment is shown\)/ }).waitFor();

  await line(console).getByRole("button", { name: "Now", exact: true }).click();
  await banner(console).waitFor({ state: "detached" });
  await expect.poll(() => console.time()).toBeGreaterThan(end);
  expect(await console.button(/^Step: /).isEnabled()).toBe(true);
});

test("the same moment looks the same each time, by steps of cycles, by its time and from the end", async () => {
  const console = await running(15);
  const { page } = console;
  await console.panel("Robots");
  const field = line(console).getByRole("textbox", { name: "Time that is shown" });
  const goTo = async (text: string, time: number) => {
    await field.fill(text);
    await field.press("Enter");
    await expect.poll(() => moment(console)).toBeCloseTo(time, 1);
    await expect.poll(() => console.time()).toBeCloseTo(time, 1);
  };
  await goTo("8", 8);
  const place = await console.place("Robot 2");
  await slider(console).focus();
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => console.time()).toBeLessThan(7.95);
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => console.time()).toBeCloseTo(8, 1);
  await expect.poll(() => console.place("Robot 2")).toEqual(place);
  await page.keyboard.press("Home");
  await expect.poll(() => moment(console)).toBe(0);
  await goTo("0:08.0", 8);
  await expect.poll(() => console.place("Robot 2")).toEqual(place);

  await field.fill("soon");
  await field.press("Enter");
  await page.getByRole("alert").filter({ hasText: "“soon” is no time" }).waitFor();
  await field.press("Escape");
  expect(await moment(console)).toBeCloseTo(8, 1);

  await field.fill("1:75");
  await field.press("Enter");
  const refused = page.getByRole("alert").filter({ hasText: "“1:75” is no time" });
  await refused.waitFor();
  await slider(console).focus();
  await refused.waitFor({ state: "detached" });
  expect(await moment(console)).toBeCloseTo(8, 1);
});

test("scrubbing shows moments on the way, and ends where it was let go", async () => {
  const console = await running(30);
  const { page } = console;
  const box = await slider(console).boundingBox();
  if (!box) throw new Error("the time line is not shown");
  const seen = new Set<string>();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 8);
  await page.mouse.down();
  for (let share = 0.9; share > 0.2; share -= 0.02) {
    await page.mouse.move(box.x + share * box.width, box.y + 8);
    seen.add((await console.runTime.textContent()) ?? "");
  }
  await page.mouse.up();
  await expect.poll(async () => Math.abs((await console.time()) - (await moment(console)))).toBeLessThan(0.2);
  const end = Number(await slider(console).getAttribute("aria-valuemax"));
  expect((await moment(console)) / end).toBeLessThan(0.35);
  expect(seen.size).toBeGreaterThan(3);
});

test("the past is played, both ways, and catches up with now", async () => {
  const console = await running(10);
  await line(console).getByRole("textbox", { name: "Time that is shown" }).fill("4");
  await console.page.keyboard.press("Enter");
  await expect.poll(() => console.time()).toBeCloseTo(4, 1);
  await console.main.filter({ hasText: "Back to now" }).waitFor();
  await line(console).getByRole("button", { name: "Play what was" }).click();
  await expect.poll(() => console.time()).toBeGreaterThan(5);
  await line(console).getByRole("button", { name: "Play backwards" }).click();
  await expect.poll(() => console.time()).toBeLessThan(4.5);
  await expect.poll(() => console.time()).toBe(0);
  await console.page.keyboard.press("e");
  await banner(console).waitFor({ state: "detached" });
});

test("moments are found by a condition, and one that is not understood is told as that", async () => {
  const console = await running(10);
  const { page } = console;
  await line(console).getByRole("button", { name: "Find moments" }).click();
  const panel = page.getByRole("region", { name: "Find moments" });
  const field = panel.getByRole("combobox", { name: "When was it so that" });
  const find = async (condition: string) => {
    await field.fill(condition);
    await page.keyboard.press("Enter");
  };
  await find("robot 1 speed > 0.5");
  await panel.getByText(/moments? (in the whole run|up to)/).waitFor();
  for (const [wrong, told] of [
    ["robot 9 speed > 1", "There is no robot 9"],
    ["all robots speed > 1", "but saw"],
  ] as const) {
    await find(wrong);
    await panel.getByRole("alert").filter({ hasText: told }).waitFor();
    expect(await panel.getByText("It was never so.").count()).toBe(0);
  }
});

test("of a robot whose program has no states, that is told", async () => {
  const console = await running(5);
  await console.select("Robot 3");
  const selection = await console.panel("Selection");
  const states = selection.getByRole("region", { name: "States over the run" });
  await states.getByRole("button", { name: "Show" }).click();
  await states.getByText("Its program has no states").waitFor();
});

test("the emergency stop works from the past, and leads back to now; another browser stays where it is", async () => {
  const { console, mlab } = await begin({ mission: "demo_c" });
  await console.main.click();
  await console.reaches("Running");
  await expect.poll(() => console.time()).toBeGreaterThan(4);
  const other = await look(mlab);
  await slider(other).waitFor();
  await clickAt(other, 0.3);
  await banner(other).waitFor();
  await clickAt(console, 0.3);
  await banner(console).waitFor();
  await console.stop.click();
  await console.reaches("Emergency stop");
  await banner(console).waitFor({ state: "detached" });
  await banner(other).waitFor();
});
