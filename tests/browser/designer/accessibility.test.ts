// No violation that axe knows, in every view, light and dark.
import { expect, test } from "vitest";
import { violations as violationsOf } from "../violations.ts";
import { begin, type DesignerPage } from "./designer.ts";

async function violations(designer: DesignerPage, view: string, colours: "light" | "dark"): Promise<string[]> {
  // A tooltip comes and goes with the pointer.
  await designer.page.mouse.move(800, 898);
  await expect.poll(() => designer.page.getByRole("tooltip").count()).toBe(0);
  return violationsOf(designer.page, view, colours);
}

for (const colours of ["light", "dark"] as const) {
  test(`every view is accessible, ${colours}`, async () => {
    const { designer } = await begin({ mission: "forage", width: 1600, height: 900 });
    const { page } = designer;
    await page.emulateMedia({ colorScheme: colours });
    await page.locator(`[data-theme=${colours}]`).first().waitFor();
    const found = await violations(designer, "start", colours);
    await page
      .getByRole("region", { name: "In this project" })
      .getByRole("button", { name: /forager/ })
      .click();
    await designer.on("");
    await page.locator(".react-flow__node").first().waitFor();
    found.push(...(await violations(designer, "file", colours)));
    for (const [name, declaration] of [
      ["dataflow", "Wander"],
      ["states", "Forage"],
      ["robot", "Forager"],
      ["class", "Collector"],
      ["society", "Foragers"],
    ] as const) {
      await designer.toDeclaration(declaration);
      found.push(...(await violations(designer, name, colours)));
      await page
        .locator(".react-flow__node")
        .first()
        .click({ position: { x: 60, y: 10 } });
      found.push(...(await violations(designer, `${name}, one selected`, colours)));
    }
    await designer.toDeclaration("Wander");
    await page.locator("body").press("Shift+d");
    await page.getByRole("dialog").waitFor();
    found.push(...(await violations(designer, "compare with", colours)));
    await page.getByRole("dialog").getByRole("button", { name: "The saved file" }).click();
    await designer.setValue(designer.named("Noise"), "persistence", "6 s");
    await designer.named("Noise").getByText("persistence 12 s → 6 s").waitFor();
    found.push(...(await violations(designer, "compared", colours)));
    await designer.button("Stop comparing").click();
    if (!(await designer.text.isVisible())) await designer.button("Text").click();
    await designer.button("Problems").click();
    await designer.text.waitFor();
    found.push(...(await violations(designer, "text and problems", colours)));
    for (const [key, title] of [
      ["Control+k", "Search everything"],
      ["?", "Keyboard shortcuts"],
      ["Control+o", "Open a configuration"],
    ] as const) {
      await page.locator("body").press(key);
      await page.getByRole("dialog", { name: title }).waitFor();
      found.push(...(await violations(designer, title, colours)));
      await page.keyboard.press("Escape");
      await page.getByRole("dialog").waitFor({ state: "detached" });
    }
    await page.keyboard.press("Control+f");
    await page.getByRole("textbox", { name: "Find on this page" }).fill("a");
    found.push(...(await violations(designer, "finding", colours)));
    await page.keyboard.press("Escape");
    await designer.toDeclaration("Wander");
    await designer.canvas.press("Shift+F12");
    await page.getByRole("region", { name: "Uses of Wander" }).waitFor();
    found.push(...(await violations(designer, "uses", colours)));
    await designer.select(designer.named("Probe"));
    await page.keyboard.press("F2");
    const dialog = page.getByRole("dialog", { name: /^Rename/ });
    await dialog.getByRole("textbox", { name: "Name" }).fill("Other_Name");
    await dialog.getByText(/random numbers/).waitFor();
    found.push(...(await violations(designer, "renaming", colours)));
    expect(found).toEqual([]);
  });
}

for (const colours of ["light", "dark"] as const) {
  test(`every live view is accessible, ${colours}`, async () => {
    const { designer } = await begin({ mission: "forage", file: "forager.cdl", width: 1600, height: 900 });
    const { page } = designer;
    await page.emulateMedia({ colorScheme: colours });
    await page.locator(`[data-theme=${colours}]`).first().waitFor();
    await designer.toDeclaration("Forage");
    await designer.run();
    await page.locator(".state.active").first().waitFor();
    const found = await violations(designer, "running, states", colours);
    await designer.select(designer.node("Searching"));
    found.push(...(await violations(designer, "running, a state selected", colours)));
    await page.getByRole("button", { name: /^Transition 1 of Searching/ }).click();
    found.push(...(await violations(designer, "running, a transition selected", colours)));
    await designer.details.getByRole("button", { name: "Break Searching → Acquiring" }).click();
    await designer.simulator.getByText("Paused", { exact: true }).waitFor();
    await designer.simulator.getByRole("alert").getByRole("button", { name: "Show" }).waitFor();
    found.push(...(await violations(designer, "paused at a breakpoint", colours)));
    await designer.toDeclaration("Wander");
    await page.locator(".wire-label.live").first().waitFor();
    await designer.select(designer.named("Probe"));
    await designer.details.getByRole("radio", { name: "The robots, now" }).waitFor();
    found.push(...(await violations(designer, "a node selected", colours)));
    await designer.details.getByRole("button", { name: "Pin a probe" }).click();
    await designer.probes.locator(".live-arrow").first().waitFor();
    found.push(...(await violations(designer, "a probe", colours)));
    await designer.button("Movement field of the selection").click();
    await designer.simulator.getByText("Movement field of", { exact: false }).waitFor();
    found.push(...(await violations(designer, "movement field", colours)));
    await designer.button("What runs").click();
    await page.getByRole("dialog").waitFor();
    found.push(...(await violations(designer, "what runs", colours)));
    expect(found).toEqual([]);
  });
}
