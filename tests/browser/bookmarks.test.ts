// Moments that people mark: in a run, in its recording, and over whatever ends the console.
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { expect, onTestFinished, test } from "vitest";
import { begin, look } from "./begin.ts";
import type { Console } from "./console.ts";
import { Mlab } from "./mlab.ts";

const line = ({ page }: Console) => page.getByRole("region", { name: "Time line" });
const list = ({ page }: Console) => page.getByRole("region", { name: "Bookmarks" });
const rows = (console: Console) => list(console).getByRole("list").getByRole("listitem");

/** With the note that is written then. */
async function mark(console: Console, note: string): Promise<void> {
  await line(console)
    .getByRole("button", { name: /^Bookmark this moment/ })
    .click();
  await list(console)
    .getByRole("textbox", { name: /^Note of/ })
    .fill(note);
  await console.page.keyboard.press("Enter");
  await list(console).getByText(note).waitFor();
}

/** The only recording of the consoles that remembered things there. */
function recordingBelow(folder: string): string {
  const found = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".mcap"));
  expect(found).toHaveLength(1);
  return join(folder, found[0]!);
}

test("a bookmark with its note is seen by all, stays over a reload and a kill, and is in the recording, where it is edited", async () => {
  const { console, mlab, project } = await begin({ mission: "demo_c" });
  const other = await look(mlab);
  await console.main.click();
  await console.reaches("Running");
  await expect.poll(() => console.time()).toBeGreaterThan(5);
  await mark(console, "robot 2 <b>hesitates</b>");
  const { page } = console;
  // Whoever keeps a note by Enter stays at now.
  await mark(console, "by the key alone");
  await list(console)
    .getByRole("button", { name: /^Remove the bookmark/ })
    .last()
    .click();
  await expect.poll(() => rows(console).count()).toBe(1);
  expect(await page.getByRole("status").filter({ hasText: "You are looking at" }).count()).toBe(0);

  // To the other one, who can't change it.
  await line(other).getByRole("button", { name: "Bookmarks: 1" }).click();
  await list(other).getByText("robot 2 <b>hesitates</b>").waitFor();
  expect(
    await line(other)
      .getByRole("button", { name: /^Bookmark this moment: Only the operator/ })
      .isDisabled(),
  ).toBe(true);

  // It is an event of the line: one goes there by the key, and marks another moment there.
  await page.reload();
  await line(console).getByRole("button", { name: "Bookmarks: 1" }).waitFor();
  await line(console)
    .getByRole("button", { name: /^Events on the line/ })
    .click();
  await page.getByText("Bookmarks", { exact: true }).first().waitFor();
  await page.keyboard.press("Escape");
  await line(console).getByRole("button", { name: "Bookmarks: 1" }).click();
  await rows(console).first().getByRole("button").first().click();
  await page.getByRole("status").filter({ hasText: "You are looking at" }).waitFor();
  await expect.poll(() => rows(console).first().locator("[aria-current]").count()).toBe(1);
  await line(console).getByRole("slider").focus();
  await page.keyboard.press("Home");
  await mark(console, "the beginning");
  await expect.poll(() => rows(console).count()).toBe(2);

  // What was removed comes back.
  await list(console).getByRole("button", { name: "Remove the bookmark of 0:00.0" }).click();
  await expect.poll(() => rows(console).count()).toBe(1);
  await list(console).getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => rows(console).count()).toBe(2);

  await page.close();
  await other.page.close();
  const state = await mlab.kill();
  const next = await Mlab.startAgain(state, "--project", project.folder);
  const after = await look(next);
  await after.page.getByRole("button", { name: /^Continue ‘demo_c’/ }).click();
  await line(after).getByRole("button", { name: "Bookmarks: 2" }).waitFor();
  await after.page.close();
  await next.end();

  const recording = recordingBelow(state);
  const replayed = await Mlab.replay(recording);
  const shown = await look(replayed);
  await line(shown).getByRole("button", { name: "Bookmarks: 2" }).click();
  await list(shown)
    .getByRole("button", { name: /^Write the note of 0:00\.0/ })
    .click();
  await list(shown)
    .getByRole("textbox", { name: /^Note of/ })
    .fill("where it began");
  await shown.page.keyboard.press("Enter");
  await list(shown).getByText("where it began").waitFor();
  await shown.page.close();
  await replayed.stop();

  const again = await Mlab.replay(recording);
  onTestFinished(async () => {
    await again.stop();
    await next.stop();
  });
  const last = await look(again);
  await line(last).getByRole("button", { name: "Bookmarks: 2" }).click();
  await list(last).getByText("where it began").waitFor();
  await list(last).getByText("robot 2 <b>hesitates</b>").waitFor();
});
