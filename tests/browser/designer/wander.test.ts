// The wander of Figure 4, from an empty canvas, with the mouse.
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { begin } from "./designer.ts";

const kWander = `assemblage Wander(curious: gain = 0.8, cautious: gain = 0.5) {
  let sense_obstacles = sense_obstacles(range = 2 m);
  cooperate {
    curious: Noise(persistence = 10 s);
    cautious: AvoidStaticObstacles(readings = sense_obstacles, sphere = 1 m, safety_margin = 0.5 m);
    curious: Probe(readings = sense_obstacles);
  }
}
`;

test("the wander of Figure 4 is built with the mouse from an empty canvas", async () => {
  const { designer, project } = await begin();
  const { page } = designer;
  await designer.newAssemblage("Wander");
  for (const [name, value] of [
    ["curious", "0.8"],
    ["cautious", "0.5"],
  ]) {
    await designer.details.getByRole("button", { name: "Add a parameter" }).click();
    const dialog = page.getByRole("dialog");
    await dialog.getByRole("textbox", { name: "Name" }).fill(name!);
    await dialog.getByRole("textbox", { name: "Default" }).fill(value!);
    await dialog.getByRole("button", { name: "Add", exact: true }).click();
    await dialog.waitFor({ state: "detached" });
  }
  await designer.dragFromPalette("Noise", 330, 60);
  await designer.dragFromPalette("AvoidStaticObstacles", 330, 190);
  await designer.dragFromPalette("Probe", 330, 360);
  await designer.dragFromPalette("sense_obstacles", 130, 300);
  await designer.dragFromPalette("cooperate", 600, 200);

  const sensor = designer.named("sense_obstacles");
  const avoid = designer.named("AvoidStaticObstacles");
  const probe = designer.named("Probe");
  const sum = designer.named("cooperate");
  await designer.setValue(sensor, "range", "2 m");
  await designer.setValue(designer.named("Noise"), "persistence", "10 s");
  await designer.setValue(avoid, "sphere", "1 m");
  await designer.setValue(avoid, "safety margin", "0.5 m");
  await designer.wire(designer.output(sensor), designer.input(avoid, "readings"));
  await designer.hasWires(1);
  await designer.wire(designer.output(designer.named("sense_obstacles")), designer.input(probe, "readings"));
  await designer.hasWires(2);
  await designer.wire(designer.output(designer.named("Noise")), designer.input(sum, "members"));
  await designer.hasWires(3);
  await designer.wire(designer.output(designer.named("AvoidStaticObstacles")), designer.input(sum, "members"));
  await designer.hasWires(4);
  await designer.wire(designer.output(designer.named("Probe")), designer.input(sum, "members"));
  await designer.hasWires(5);
  await designer.setWeight(sum, 0, "curious");
  await designer.setWeight(sum, 1, "cautious");
  await designer.setWeight(sum, 2, "curious");
  await page.keyboard.press("f");
  await atRest(() => designer.result.boundingBox());
  await designer.wire(designer.output(sum), designer.result);
  await designer.hasWires(6);
  await expect.poll(() => designer.verdict.textContent()).not.toMatch(/error/);

  await designer.saveAs("wander");
  await expect.poll(() => project.read("wander.cdl").split("\nlayout ")[0]).toBe(kWander);
  expect(project.read("wander.cdl")).toMatch(/layout Wander \{\n( {2}\w+ -?\d+ -?\d+;\n){5}\}/);
});
