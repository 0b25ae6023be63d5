// A console that was killed is gone on with: from the start page of the next one.
import { expect, onTestFinished, test } from "vitest";
import { begin, look } from "./begin.ts";
import { Mlab } from "./mlab.ts";

test("the start page continues a run that a kill has cut off", async () => {
  const { console, mlab, project } = await begin({ mission: "demo_c" });
  await console.reaches("Ready");
  await console.startRobots();
  await console.page.close();
  const state = await mlab.kill();
  const next = await Mlab.startAgain(state, "--project", project.folder);
  onTestFinished(async () => {
    await next.stop();
  });
  const after = await look(next);
  const runs = after.page.getByRole("region", { name: "Unfinished runs" });
  await runs.getByRole("button", { name: /Continue ‘demo_c’, stopped at/ }).click();
  const log = await after.panel("Log");
  await log.getByText("the run goes on as it stood at").first().waitFor();
  await after.steps.getByText(/^1 of /).waitFor();
  expect(await log.getByText(/: single step$/).count()).toBeGreaterThan(0);
  await runs.waitFor({ state: "detached" });
});
