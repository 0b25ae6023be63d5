// Where what is not saved can't be kept, or not be saved, the page says so before anything is lost.
import { mkdirSync, rmSync } from "node:fs";
import { expect, onTestFinished, test } from "vitest";
import { begin, look, Project } from "./begin.ts";
import type { Console } from "./console.ts";
import { Mlab } from "./mlab.ts";
import { expectWithin } from "./within.ts";

async function type(console: Console, line: string): Promise<void> {
  const text = (await console.panel("Text")).getByRole("textbox", { name: /^Text of / });
  await text.click();
  await console.page.keyboard.press("Control+End");
  await console.page.keyboard.insertText(line);
}

test("the console says that nothing can be kept, and that there is something to lose", async () => {
  const project = new Project("demo_c");
  onTestFinished(() => project.remove());
  // A file stands where the folder of the user's state would be: nobody can write there, whoever it is.
  project.write("no_folder", "");
  const mlab = await Mlab.startAgain(project.path("no_folder"), project.path("demo_c.mdl"), "--speed", "1");
  onTestFinished(async () => {
    await mlab.stop();
  });
  expect(mlab.output).toContain("what is not saved is lost then");
  const console = await look(mlab);
  await console.reaches("Ready");
  const banner = console.page.getByRole("alert").filter({ hasText: "What is not saved is not kept" });
  await banner.getByText(/no_folder.*can't be made/).waitFor();
  expect(await banner.textContent()).not.toContain("There is something that is not saved");
  await type(console, "\n 12. UNIT scouts STOP");
  await banner.getByText("There is something that is not saved").waitFor();
  for (const [width, height] of [
    [1280, 800],
    [640, 400],
    [320, 568],
  ] as const) {
    await console.page.setViewportSize({ width, height });
    await expectWithin(banner.getByRole("button", { name: "Save" }));
    for (const what of [console.stop, console.state]) await expectWithin(what);
  }
  await console.page.setViewportSize({ width: 1280, height: 800 });
  await banner.getByRole("button", { name: "Save" }).click();
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(await banner.textContent()).not.toContain("There is something that is not saved");
  expect(project.read("demo_c.mdl")).toContain("12. UNIT scouts STOP");
});

test("a mission that can't be written stays unsaved, with the reason", async () => {
  const { console, project } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  await type(console, "\n 12. UNIT scouts STOP");
  await console.button("Not saved").waitFor();
  const file = project.path("demo_c.mdl");
  rmSync(file);
  mkdirSync(file);
  await console.panel("Text");
  await console.button("Save").first().click();
  await console.page
    .getByRole("alert")
    .filter({ hasText: /demo_c\.mdl/ })
    .first()
    .waitFor();
  await console.button("Not saved").waitFor();
});
