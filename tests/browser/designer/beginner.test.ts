// What somebody meets who has never seen the designer before.
import { expect, test } from "vitest";
import { Mlab } from "../mlab.ts";
import { begin, look } from "./designer.ts";

test("the palette begins with what a first skill is made of, and stays as it was folded", async () => {
  const { designer } = await begin();
  const { page, palette } = designer;
  await designer.newAssemblage("Wander");
  const groups = palette.locator(".palette-group");
  await groups.first().waitFor();
  const names = (await groups.allInnerTexts()).map((one) => one.replace(/\d+/, "").trim());
  expect(names.slice(0, 3)).toEqual(["Motor schemas", "Sensors", "Operators"]);
  const logic = palette.getByRole("button", { name: /^Logic/ });
  const motors = palette.getByRole("button", { name: /^Motor schemas/ });
  expect(await logic.getAttribute("aria-expanded")).toBe("false");
  expect(await motors.getAttribute("aria-expanded")).toBe("true");
  await logic.click();
  await motors.click();
  await page.reload();
  await designer.on("Wander");
  await expect.poll(() => logic.getAttribute("aria-expanded")).toBe("true");
  expect(await motors.getAttribute("aria-expanded")).toBe("false");
});

test("a new configuration is called so wherever one looks", async () => {
  const { designer } = await begin();
  await designer.newAssemblage("Wander");
  const crumbs = designer.page.getByRole("navigation", { name: "Where you are" });
  await crumbs.getByRole("button", { name: "New configuration" }).waitFor();
  expect(await designer.page.locator("body").innerText()).not.toContain("new:");
  expect(await designer.page.locator('[title*="new:"]').count()).toBe(0);
});

test("the editor of a value says its unit, its range and its default in words", async () => {
  const { designer } = await begin();
  await designer.newAssemblage("Wander");
  await designer.place("Noise");
  await designer.named("Noise").locator(".row-value").first().click();
  const editor = designer.page.locator(".value-editor");
  await editor.getByText("persistence, in seconds", { exact: true }).waitFor();
  await editor.getByText(/default 6 s/i).waitFor();
});

test("closing the simulator brings back the palette that made room for it", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  const { palette } = designer;
  await designer.toFile();
  await palette.waitFor();
  await designer.button("Run").click();
  await designer.simulator.waitFor();
  await palette.waitFor({ state: "detached" });
  await designer.button("Hide Simulator").click();
  await palette.waitFor();
});

test("an assemblage made of several outputs offers what they lead to, stands where they stood and keeps their places", async () => {
  const { designer } = await begin({
    file: "first.cdl",
    prepare: (project) =>
      project.write(
        "first.cdl",
        `assemblage A() {
  compete by priority {
    cooperate {
      1: Noise();
      1: MoveAhead();
    };
    Stand();
  }
}

layout A {
  compete 900 100;
  Stand 600 400;
  cooperate 500 120;
  cooperate.Noise 200 40;
  cooperate.MoveAhead 200 200;
}
`,
      ),
  });
  const { page } = designer;
  await designer.on("A");
  await designer.select(designer.named("Noise"));
  await page.keyboard.down("Shift");
  await designer.select(designer.named("MoveAhead"));
  await page.keyboard.up("Shift");
  await page.keyboard.press("Control+g");
  const dialog = page.getByRole("dialog");
  await dialog.getByText(/several: Noise, MoveAhead/).waitFor();
  await dialog.getByRole("button", { name: "Take cooperate as well" }).click();
  await dialog.getByText(/several/).waitFor({ state: "detached" });
  await dialog.getByRole("textbox", { name: "Name" }).fill("Drift");
  await dialog.getByRole("button", { name: "Make it" }).click();
  const made = page.locator('.react-flow__node[data-id$="Drift"]');
  await made.waitFor();
  await expect.poll(() => made.getAttribute("class")).toContain("selected");
  await page.keyboard.press("t");
  await expect.poll(() => designer.text.innerText()).toMatch(/layout Drift \{\s+MoveAhead 200 200;\s+Noise 200 40;/);
});

test("the window of a server that was started anew with another token says what to do", async () => {
  const { designer, mlab, project } = await begin();
  await designer.newAssemblage("Wander");
  const port = new URL(mlab.url).port;
  const state = await mlab.kill();
  await designer.page.getByText(/Connection lost/).waitFor();
  const again = await Mlab.edit(["--project", project.folder, "--port", port, "--new-token"], state);
  try {
    await designer.page.getByText(/Open the address that mlab has printed/).waitFor();
    const fresh = await look(again.url);
    await fresh.page.locator("h1, h2").first().waitFor();
    await fresh.leave(); // before its server goes
  } finally {
    await designer.leave();
    await again.stop();
  }
});
