// Where what is not saved can't be kept, the designer says so before anything is lost.
import { expect, onTestFinished, test } from "vitest";
import { Project } from "../begin.ts";
import { Mlab } from "../mlab.ts";
import { expectWithin } from "../within.ts";
import { look } from "./designer.ts";

const kOne = "assemblage One() {\n  cooperate {\n    1: Noise(persistence = 10 s);\n  }\n}\n";

test("the designer says that nothing can be kept, and that there is something to lose", async () => {
  const project = new Project("");
  onTestFinished(() => project.remove());
  project.write("one.cdl", kOne);
  // A file stands where the folder of the user's state would be: nobody can write there, whoever it is.
  project.write("no_folder", "");
  const mlab = await Mlab.edit([project.path("one.cdl"), "--project", project.folder], project.path("no_folder"));
  onTestFinished(async () => {
    await mlab.stop();
  });
  expect(mlab.output).toContain("what is not saved is lost then");
  const designer = await look(mlab.url);
  await designer.on("One");
  const banner = designer.page.getByRole("alert").filter({ hasText: "What is not saved is not kept" });
  await banner.getByText(/no_folder.*can't be made/).waitFor();
  expect(await banner.textContent()).not.toContain("There is something that is not saved");
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  await banner.getByText("There is something that is not saved").waitFor();
  for (const [width, height] of [
    [1280, 800],
    [640, 400],
  ] as const) {
    await designer.page.setViewportSize({ width, height });
    await expectWithin(banner.getByRole("button", { name: "Save" }));
    await expectWithin(designer.page.locator("[data-tour=run]"));
  }
  await banner.getByRole("button", { name: "Save" }).click();
  await designer.button("Not saved").waitFor({ state: "detached" });
  expect(project.read("one.cdl")).toContain("3 s");
});
