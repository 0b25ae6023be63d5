// What keeps a person from losing the way: nothing moves under the pointer, keys leave dialogs, levels lead
// back.
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { begin, type DesignerPage, look } from "./designer.ts";

const kTwo = `assemblage Urges() {
  cooperate {
    Noise();
    Stand();
  }
}

assemblage Wander() {
  Urges()
}

layout Urges {
  Noise 0 0;
  Stand 40 160;
  cooperate 320 60;
}
`;

const opened = () => begin({ file: "two.cdl", prepare: (project) => project.write("two.cdl", kTwo) });

const crumbs = ({ page }: DesignerPage) =>
  page.getByRole("navigation", { name: "Where you are" }).getByRole("button").allTextContents();

test("who goes inside comes back to where he was", async () => {
  const { designer } = await opened();
  await designer.goTo("Wander");
  await designer.node("Urges").dblclick({ position: { x: 60, y: 8 } });
  await designer.on("Urges");
  expect(await crumbs(designer)).toEqual(["two.cdl", "Wander", "Urges"]);
  await designer.page.keyboard.press("u");
  await designer.on("Wander");
  expect(await crumbs(designer)).toEqual(["two.cdl", "Wander"]);
});

test("the browser leads back page by page, and on again", async () => {
  const { designer } = await opened();
  const { page } = designer;
  await designer.goTo("Wander");
  await designer.node("Urges").dblclick({ position: { x: 60, y: 8 } });
  await designer.on("Urges");
  for (const before of ["Wander", ""]) {
    await page.goBack();
    await designer.on(before);
  }
  for (const next of ["Wander", "Urges"]) {
    await page.goForward();
    await designer.on(next);
  }
  // A link that is typed into the same window.
  await page.evaluate(() => window.location.assign(`${window.location.hash}&node=Noise`));
  await expect.poll(() => page.locator(".react-flow__node.selected").getAttribute("data-id")).toContain("Noise");
});

test("what is told does not move the drawing", async () => {
  const { designer, project } = await opened();
  await designer.goTo("Urges");
  const box = () => designer.node("Noise").boundingBox();
  const before = await atRest(box);
  project.write("two.cdl", `${kTwo}// more\n`);
  await designer.page.getByText("was changed on the disk; this is the new text").waitFor();
  expect(await atRest(box)).toEqual(before);
});

test("Escape leaves a dialog and Enter does what it is for", async () => {
  const { designer, project } = await begin();
  await designer.button("New configuration").click();
  await designer.on("");
  await designer.palette.getByRole("button", { name: /^Assemblage/ }).click();
  const dialog = designer.page.getByRole("dialog");
  const name = dialog.getByRole("textbox", { name: "Name" });
  await name.fill("Wander");
  await name.press("Escape");
  await dialog.waitFor({ state: "detached" });
  await designer.declare("Assemblage", "Wander");
  await designer.page.keyboard.press("Control+s");
  await name.fill("kept");
  await name.press("Enter");
  await dialog.waitFor({ state: "detached" });
  await expect.poll(() => project.read("kept.cdl")).toContain("assemblage Wander");
});

test("Escape takes back what was typed, in fields, in several lines and in comments", async () => {
  const { designer } = await opened();
  const { details, page } = designer;
  await designer.goTo("Urges");
  const help = details.getByRole("textbox", { name: "What it is for" });
  await help.fill("Not meant");
  await help.press("Escape");
  expect(await help.inputValue()).toBe("");
  await designer.select(designer.node("Noise"));
  const persistence = details.getByRole("textbox", { name: /^persistence/ });
  const before = await persistence.inputValue();
  await persistence.fill("99 s");
  await persistence.press("Escape");
  expect(await persistence.inputValue()).toBe(before);
  await persistence.press("Tab"); // what is left is not sent either
  await page.keyboard.press("Shift+C");
  const comment = page.getByRole("textbox", { name: "Text of the comment" });
  await comment.fill("Not meant");
  await comment.press("Escape");
  await comment.waitFor({ state: "detached" });
  await page.getByText("Not saved").waitFor();
  await page.locator("body").press("Control+z"); // the comment; nothing else was done
  await page.getByText("Not saved").waitFor({ state: "detached" });
});

test("a dialog shows what the document says by now, and goes with what it is about", async () => {
  const { designer, project } = await opened();
  const { page, details } = designer;
  const text = (initial: string) => kTwo.replace("Urges()", `Urges(eager: gain = ${initial})`);
  project.write("two.cdl", text("0.3"));
  await designer.goTo("Urges");
  await details.getByRole("button", { name: /^eager/ }).click();
  const initial = page.getByRole("dialog").getByRole("textbox", { name: "Default" });
  expect(await initial.inputValue()).toBe("0.3");
  project.write("two.cdl", text("0.4"));
  await expect.poll(() => initial.inputValue()).toBe("0.4");
  await initial.fill("0.7");
  project.write("two.cdl", text("0.5"));
  await details.getByText("= 0.5").waitFor();
  expect(await initial.inputValue()).toBe("0.7");
  project.write("two.cdl", kTwo);
  await page.getByText("eager is not there any more").waitFor();
  expect(await page.getByRole("dialog").count()).toBe(0);
});

test("the words of a comment are typed at once, in a free place", async () => {
  const { designer, project } = await opened();
  await designer.goTo("Urges");
  await designer.page.keyboard.press("Shift+C");
  await designer.page.getByRole("textbox", { name: "Text of the comment" }).waitFor();
  await designer.page.keyboard.type("Two urges");
  await designer.page.keyboard.press("Control+Enter");
  await designer.page.locator(".note", { hasText: "Two urges" }).waitFor();
  await designer.page.locator("body").press("Control+s");
  await expect.poll(() => project.read("two.cdl")).toContain('200 80 "Two urges"');
});

test("a page that has gone leads to the file", async () => {
  const { designer } = await opened();
  await designer.goTo("Urges");
  await designer.page.evaluate(() => {
    window.location.hash = "#file=two.cdl&page=Nothing";
  });
  await designer.page.getByRole("heading", { name: "There is no Nothing" }).waitFor();
  await designer.button("The whole file").click();
  await designer.on("");
});

test("of two windows the one that is worked in has the robots", async () => {
  const { designer, mlab } = await opened();
  await designer.goTo("Wander");
  const other = await look(mlab.url);
  await other.goTo("Wander");
  for (const one of [designer, other]) {
    await one.run();
  }
  await other.button("Pause").click();
  await designer.simulator.getByText("Paused").waitFor();
  await designer.page.keyboard.press("F10");
  expect(await designer.page.getByText("Only the operator").count()).toBe(0);
  expect(await other.page.getByText("Only the operator").count()).toBe(0);
});

test("a page that opens brings its declaration to the top of the text, and help reads as it is meant", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  const { page } = designer;
  await designer.toDeclaration("Forage");
  await page.keyboard.press("t");
  const top = async () => {
    const box = await designer.text.locator(".cm-line", { hasText: "assemblage Forage(" }).boundingBox();
    const pane = await page.locator(".cm-scroller").boundingBox();
    return (box?.y ?? 1e9) - (pane?.y ?? 0);
  };
  await expect.poll(top).toBeLessThan(60);
  await designer.toDeclaration("Wander");
  await expect
    .poll(
      async () => (await designer.text.locator(".cm-line", { hasText: "assemblage Wander(" }).boundingBox())?.y ?? 1e9,
    )
    .toBeLessThan(160);
  await designer.select(designer.named("Noise"));
  await designer.details.locator(".details-help code", { hasText: "persistence" }).waitFor();
  expect(await designer.details.locator(".details-help").innerText()).not.toContain("`");
});

test("a double click on a node selects no text beside the canvas", async () => {
  const { designer } = await opened();
  await designer.toFile();
  await designer.node("Wander").dblclick({ position: { x: 70, y: 10 } });
  await designer.on("Wander");
  expect(await designer.page.evaluate(() => window.getSelection()?.type)).not.toBe("Range");
});

test("what is placed by keys comes where its wire leads on", async () => {
  const { designer } = await opened();
  await designer.goTo("Wander");
  const x = async (name: string) => (await designer.named(name).boundingBox())!.x;
  await designer.place("AvoidStaticObstacles");
  await designer.place("sense_obstacles");
  await expect.poll(async () => (await x("sense_obstacles")) < (await x("AvoidStaticObstacles"))).toBe(true);
  await designer.select(designer.named("AvoidStaticObstacles"));
  await designer.place("cooperate");
  await expect.poll(async () => (await x("cooperate")) > (await x("AvoidStaticObstacles")) + 150).toBe(true);
});
