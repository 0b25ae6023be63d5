// Files that somebody else changes while they are open: taken over, or asked about where there is something to lose.
import { rmSync } from "node:fs";
import { expect, test } from "vitest";
import { begin, look } from "./begin.ts";
import { expectWithin } from "./within.ts";

const kComment = "-- From another editor.";

test("an overlay that changes on disk is taken over, and undo brings the old one back", async () => {
  const { console, project } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const before = project.read("democ.odl");
  project.write("democ.odl", `${kComment}\n${before}`);
  const banner = page.getByText("democ.odl was changed on the disk; this is the new text.");
  await banner.waitFor();
  const panel = await console.panel("Text");
  await panel.getByRole("tab", { name: /democ\.odl/ }).click();
  await panel.getByText(kComment).waitFor();
  expect(await console.button("Not saved").count()).toBe(0);
  await page.getByRole("button", { name: "Dismiss" }).click();
  await banner.waitFor({ state: "detached" });
  await console.button("Undo take over the changed file").click();
  await panel.getByText(kComment).waitFor({ state: "detached" });
  await console.button("Not saved").waitFor();
});

test("where something is unsaved people are asked: both are merged, or one gives way", async () => {
  const { console, mlab, project } = await begin({ mission: "demo_c" });
  const { page } = console;
  await console.reaches("Ready");
  const type = async (line: string) => {
    const text = (await console.panel("Text")).getByRole("textbox", { name: /^Text of / });
    await text.click();
    await page.keyboard.press("Control+End");
    await page.keyboard.insertText(line);
    await console.button("Not saved").waitFor();
  };
  await type("\n-- typed here");
  project.write("demo_c.mdl", `${kComment}\n${project.read("demo_c.mdl")}`);
  const banner = page
    .getByRole("alert")
    .filter({ hasText: "demo_c.mdl was changed on the disk, and you have changes" });
  await banner.waitFor();
  for (const [width, height] of [
    [1280, 800],
    [640, 400],
    [320, 568],
  ] as const) {
    await page.setViewportSize({ width, height });
    for (const name of ["Merge both", "Take the disk's", "Keep mine"])
      await expectWithin(banner.getByRole("button", { name }));
    await expectWithin(console.stop);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  const watcher = await look(mlab);
  await watcher.page.getByText("there are changes that are not saved").waitFor();
  expect(await watcher.page.getByRole("button", { name: "Merge both" }).count()).toBe(0);

  await banner.getByRole("button", { name: "Merge both" }).click();
  await banner.waitFor({ state: "detached" });
  await console.button("Save").first().click();
  await console.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("demo_c.mdl")).toContain(kComment);
  expect(project.read("demo_c.mdl")).toContain("-- typed here");

  await type("\n-- more");
  project.write("demo_c.mdl", "-- nothing is left\n");
  await banner.getByRole("button", { name: "Keep mine" }).click();
  await banner.waitFor({ state: "detached" });
  await expect.poll(() => project.read("demo_c.mdl")).toContain("-- more");
  rmSync(project.path("demo_c.mdl"));
  await page.getByText("demo_c.mdl is gone from the disk. Save writes it anew.").waitFor();
  await page.getByRole("status").getByRole("button", { name: "Save" }).click();
  await expect.poll(() => project.read("demo_c.mdl")).toContain("-- more");
});
