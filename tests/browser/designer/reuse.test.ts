// Assemblages are taken apart, components of the library made one's own, castes given a coordinator.
import { expect, test } from "vitest";
import { begin } from "./designer.ts";
import { looked } from "./looked.ts";

const kThree = `assemblage Urges() {
  cooperate {
    Noise();
    Stand();
  }
}

assemblage Wander() {
  cooperate {
    1: Urges();
    2: AvoidDynamicObstacles();
  }
}
`;

const opened = () => begin({ file: "three.cdl", prepare: (project) => project.write("three.cdl", kThree) });

test("an assemblage is taken apart where it is used, and is as it was by undo", async () => {
  const { designer, project } = await opened();
  await designer.toDeclaration("Wander");
  await designer.select(designer.named("Urges"));
  await designer.details.getByRole("button", { name: "Ungroup", exact: true }).click();
  await designer.named("Noise").waitFor();
  await designer.named("Stand").waitFor();
  expect(await designer.named("Urges").count()).toBe(0);
  // What it was made of is selected, and stands on nothing.
  await expect.poll(() => designer.page.locator(".react-flow__node.selected").count()).toBeGreaterThan(1);
  await expect.poll(async () => (await looked(designer)).over).toEqual([]);
  await designer.page.keyboard.press("Control+s");
  await expect.poll(() => project.read("three.cdl").split("assemblage Wander")[1]).toContain("Noise()");
  await designer.page.keyboard.press("Control+z");
  await designer.named("Urges").waitFor();
});

test("who looks inside of a component of the library makes it his own, and is in his copy", async () => {
  const { designer, project } = await opened();
  const { page } = designer;
  await designer.toDeclaration("Wander");
  await designer.named("AvoidDynamicObstacles").dblclick({ position: { x: 60, y: 8 } });
  await designer.on("AvoidDynamicObstacles");
  await page.getByText("A component of the library: look, but not change.").waitFor();
  await designer.button("Make my own copy in three.cdl").click();
  await page.getByText("A component of the library: look, but not change.").waitFor({ state: "detached" });
  await designer.on("AvoidDynamicObstacles");
  const crumbs = page.getByRole("navigation", { name: "Where you are" }).getByRole("button");
  await expect.poll(() => crumbs.allTextContents()).toEqual(["three.cdl", "Wander", "AvoidDynamicObstacles"]);
  await page.keyboard.press("Control+s");
  await expect.poll(() => project.read("three.cdl")).toContain("assemblage AvoidDynamicObstacles(");
});

test("a caste is given a coordinator, of those that there are", async () => {
  const { designer, project } = await begin({
    mission: "forage",
    file: "forager.cdl",
    prepare: (its) =>
      its.write(
        "forager.cdl",
        `${its.read("forager.cdl")}\nsociety All: caste {\n  Forager;\n  team of 2 Forager;\n};\n`,
      ),
  });
  await designer.toDeclaration("All");
  const field = designer.details.getByRole("button", { name: "Coordinated by" }).first();
  await field.click();
  const offered = designer.page.getByRole("option");
  await offered.first().waitFor();
  expect(await offered.allInnerTexts()).toEqual(["nothing", "DistinctTargets"]);
  await offered.nth(1).click();
  await expect.poll(() => field.innerText()).toBe("DistinctTargets");
  await designer.page.locator("body").press("Control+s");
  await expect.poll(() => project.read("forager.cdl")).toMatch(/society All: caste \{[^}]*\} by DistinctTargets;/);
});
