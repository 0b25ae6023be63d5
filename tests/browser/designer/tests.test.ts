// Tests of components in the designer: listed, run, what failed, and the failing cycle on the drawing.
import { expect, test } from "vitest";
import { picture } from "../picture.ts";
import { begin, type DesignerPage } from "./designer.ts";

const kCareful = `assemblage Careful(place: Point) {
  let way = DetectGoal(place);
  sequence {
    start Coming: MoveToGoal(way, success_radius = 50 cm);
      when AreRobotsNear(sense_robots(), range = 3 m) goto Waiting;
    Waiting: Stand();
      when not AreRobotsNear(sense_robots(), range = 3 m) goto Coming;
  }
}
`;

const kTests = `
test "comes" of Careful([20 m, 0 m]) {
  expect state Coming;
}

test "waits while somebody is near" of Careful([20 m, 0 m]) {
  expect for 3 cycles: state Coming;
  given robot(at = [4 m, 0 m]);
  expect state Waiting;
}
`;

const opened = (text: string, size: { width: number; height: number } = { width: 1500, height: 900 }) =>
  begin({ file: "careful.cdl", prepare: (project) => project.write("careful.cdl", text), ...size });

const pane = ({ page }: DesignerPage) => page.getByRole("region", { name: "Tests", exact: true });

const entry = (designer: DesignerPage, name: string, state: string) =>
  pane(designer).getByRole("listitem", { name: `${name}: ${state}`, exact: true });

async function openPane(designer: DesignerPage): Promise<void> {
  await designer.page.getByRole("button", { name: /^Tests/ }).click();
  await pane(designer).waitFor();
}

test("tests run by themselves, and one that failed says what was there instead", async () => {
  const { designer, project } = await opened(kCareful + kTests);
  const { page } = designer;
  await designer.on("Careful");
  await page.keyboard.press("Shift+T");
  await entry(designer, "comes", "Passed").waitFor();
  const failed = entry(designer, "waits while somebody is near", "Failed");
  await failed.getByText("state Waiting").waitFor();
  await failed.getByText("is false in cycle 4").waitFor();
  await failed.getByText("in state it.Coming").waitFor();
  await pane(designer).getByText("2 tests: 1 passed, 1 failed").waitFor();
  await picture(page, "tests", { of: "designer" });
  await failed.getByRole("button", { name: "careful.cdl, line 18" }).click();
  await expect
    .poll(() => designer.text.evaluate((text) => text.ownerDocument.getSelection()?.toString()))
    .toBe("Waiting");
  // What was wrong is mended: nobody has to say that it be run again.
  project.write("careful.cdl", (kCareful + kTests).replace("3 m) goto Waiting", "9 m) goto Waiting"));
  await entry(designer, "waits while somebody is near", "Passed").waitFor();
});

test("the failing cycle is shown on the drawing as a robot would be, and one can go through all cycles", async () => {
  const { designer } = await opened(kCareful + kTests);
  const { page } = designer;
  await designer.on("Careful");
  await openPane(designer);
  const failed = entry(designer, "waits while somebody is near", "Failed");
  await failed.getByRole("button", { name: /^Show cycle 4 of/ }).click();
  const banner = page.getByRole("status").filter({ hasText: "values of the test, not of a robot" });
  await banner.getByText("at cycle 4 of 4").waitFor();
  const active = page.locator(".state.active");
  await active.getByText("Coming").waitFor();
  await picture(page, "test_cycle", { of: "designer" });
  expect(await banner.getByRole("button", { name: "One cycle on" }).isDisabled()).toBe(true);
  await banner.getByRole("button", { name: "One cycle back" }).click();
  await banner.getByText("at cycle 3 of 4").waitFor();
  await page.locator(".canvas").focus();
  await page.keyboard.press(",");
  await banner.getByText("at cycle 2 of 4").waitFor();
  await page.keyboard.press(".");
  await banner.getByText("at cycle 3 of 4").waitFor();
  // Inside of a state the wires have their values.
  await page.locator('.react-flow__node[data-id="Coming"]').dblclick();
  await designer.on("Careful.Coming");
  await expect.poll(() => page.locator(".wire-label, .live-badge").allTextContents()).not.toEqual([]);
  await picture(page, "test_values", { of: "designer" });
  await page.keyboard.press("Escape");
  await banner.waitFor({ state: "detached" });
  await expect.poll(() => page.locator(".live-badge").count()).toBe(0);
});

test("where there are no tests yet a first one is written, and can be taken back", async () => {
  const { designer } = await opened(kCareful);
  const { page } = designer;
  await designer.on("Careful");
  await openPane(designer);
  await pane(designer).getByText("No tests yet.").waitFor();
  await picture(page, "no_tests", { of: "designer" });
  await pane(designer).getByRole("button", { name: "Write a first test" }).click();
  await entry(designer, "Careful near an obstacle", "Passed").waitFor();
  await expect.poll(() => designer.text.textContent()).toContain('test "Careful near an obstacle" of Careful(place');
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await pane(designer).getByText("No tests yet.").waitFor();
});

test("a test that can't be run says why and where", async () => {
  const { designer } = await opened(`${kCareful}\ntest "forgets" of Careful() {\n  expect state Coming;\n}\n`);
  await designer.on("Careful");
  await openPane(designer);
  const entryOf = entry(designer, "forgets", "Can't run");
  await entryOf.getByText("Careful needs place.").waitFor();
  await entryOf.getByRole("button", { name: "Show where" }).click();
  await designer.text.waitFor();
});

test("in a window as narrow as a phone nothing of the tests lies beside it", async () => {
  const { designer } = await opened(kCareful + kTests, { width: 390, height: 800 });
  const { page } = designer;
  await designer.on("Careful");
  await openPane(designer);
  const failed = entry(designer, "waits while somebody is near", "Failed");
  await failed.getByRole("button", { name: /^Show cycle 4 of/ }).click();
  const banner = page.getByRole("status").filter({ hasText: "not of a robot" });
  await banner.getByText("at cycle 4 of 4").waitFor();
  await picture(page, "tests_narrow", { of: "designer" });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(390);
  const header = await pane(designer).getByRole("button", { name: "Hide Tests" }).boundingBox();
  expect(header!.x + header!.width).toBeLessThanOrEqual(390);
});

test("tests are dark where all is dark", async () => {
  const { designer } = await opened(kCareful + kTests);
  await designer.page.emulateMedia({ colorScheme: "dark" });
  await designer.on("Careful");
  await openPane(designer);
  await entry(designer, "waits while somebody is near", "Failed").waitFor();
  await picture(designer.page, "tests_dark", { of: "designer" });
});
