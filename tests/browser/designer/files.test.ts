// Files: what is not saved survives, what changes on disk is noticed, examples become copies.
import { rmSync } from "node:fs";
import { expect, onTestFinished, test } from "vitest";
import { Mlab } from "../mlab.ts";
import { begin, look } from "./designer.ts";

const kOne = "assemblage One() {\n  cooperate {\n    1: Noise(persistence = 10 s);\n  }\n}\n";

const opened = () => begin({ file: "one.cdl", prepare: (project) => project.write("one.cdl", kOne) });

test("what is not saved survives a closed tab and a killed server", async () => {
  const { designer, mlab, project } = await opened();
  await designer.on("One");
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  await designer.button("Not saved").waitFor();
  await designer.page.goto("about:blank");
  const state = await mlab.kill();
  const again = await Mlab.edit([project.path("one.cdl"), "--project", project.folder], state);
  onTestFinished(async () => {
    await again.stop();
  });
  const page = await look(again.url);
  await page.on("One");
  await page.named("Noise").getByText("3 s").waitFor();
  await page.button("Not saved").waitFor();
  expect(project.read("one.cdl")).toBe(kOne);
});

test("a page that was left open goes on with the next server where the killed one stood", async () => {
  const { designer, mlab, project } = await opened();
  await designer.on("One");
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  await designer.button("Not saved").waitFor();
  const state = await mlab.kill();
  await designer.page.getByText(/Connection lost/).waitFor();
  const port = new URL(mlab.url).port;
  const again = await Mlab.edit([project.path("one.cdl"), "--project", project.folder, "--port", port], state);
  onTestFinished(async () => {
    await again.stop();
  });
  expect(again.url).toBe(mlab.url);
  await designer.page.getByText(/Connection lost/).waitFor({ state: "detached" });
  await designer.named("Noise").getByText("3 s").waitFor();
  await designer.setValue(designer.named("Noise"), "persistence", "4 s");
  await designer.named("Noise").getByText("4 s").waitFor();
  await designer.leave();
});

test("a file that is changed on disk is taken over, or asked about where there is something to lose", async () => {
  const { designer, project } = await opened();
  await designer.on("One");
  project.write("one.cdl", kOne.replace("10 s", "20 s"));
  await designer.named("Noise").getByText("20 s").waitFor();
  await designer.page.getByText("was changed on the disk; this is the new text").waitFor();
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  project.write("one.cdl", `// From elsewhere.\n${kOne}`);
  await designer.button("Take the disk's").click();
  await designer.named("Noise").getByText("10 s").waitFor();
});

test("what was never saved is listed by what it holds, and thrown away when that is wanted", async () => {
  const { designer } = await begin();
  const { page } = designer;
  const recent = page.getByRole("region", { name: "Recent" });
  await designer.newAssemblage("Drift");
  await page.getByRole("heading", { name: "Drift", level: 1 }).waitFor();
  await page.goto("about:blank");
  await page.goBack();
  await designer.on("Drift");
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "Close: back to the start page" }).click();
  await recent.getByRole("button", { name: "Drift not saved yet" }).waitFor();
  const dialog = page.getByRole("dialog", { name: "Throw Drift away?" });
  await designer.button("Throw Drift away").click();
  await dialog.getByRole("button", { name: "Keep it" }).click();
  await dialog.waitFor({ state: "detached" });
  await designer.button("Throw Drift away").click();
  await dialog.getByRole("button", { name: "Throw it away" }).click();
  await page.getByText("What you have opened appears here.").waitFor();
  await page.reload();
  await page.getByText("What you have opened appears here.").waitFor();
});

test("what is kept of a file that is gone is thrown away when that is wanted", async () => {
  const { designer, mlab, project } = await opened();
  await designer.on("One");
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  await designer.button("Not saved").waitFor();
  await designer.page.goto("about:blank");
  const state = await mlab.kill();
  rmSync(project.path("one.cdl"));
  const again = await Mlab.edit(["--project", project.folder], state);
  onTestFinished(async () => {
    await again.stop();
  });
  const next = await look(again.url);
  await next.button("Throw One away").click();
  const dialog = next.page.getByRole("dialog", { name: "Throw One away?" });
  await dialog.getByText("Its file is gone: what it holds is lost.").waitFor();
  await dialog.getByRole("button", { name: "Throw it away" }).click();
  await next.page.getByText("What you have opened appears here.").waitFor();
});

test("the start page says what an example is for", async () => {
  const { designer } = await begin();
  const examples = designer.page.getByRole("region", { name: "Examples" });
  await examples.getByText("Forage: the configuration of Figures 6 to 10 of GIT-COGSCI-95/02.").waitFor();
  await examples.getByText("forager", { exact: true }).waitFor();
});

test("the browser's own print has the drawing, whole", async () => {
  const { designer } = await opened();
  const { page } = designer;
  const sheet = () => page.locator(".print-sheet svg").count();
  const print = () => page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  // What draws for the printer comes later than the page.
  await expect.poll(() => print().then(sheet)).toBe(1);
  await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
  expect(await sheet()).toBe(0);
});

test("an example is looked at, and saved as a copy of one's own", async () => {
  const { designer, project } = await begin();
  await designer.page
    .getByRole("region", { name: "Examples" })
    .getByRole("button", { name: /forager/ })
    .first()
    .click();
  await designer.page.getByText("An example: look, or save it as your own.").waitFor();
  await designer.button("Make my own copy…").click();
  const dialog = designer.page.getByRole("dialog");
  await dialog.getByRole("textbox", { name: "Name" }).fill("mine");
  await dialog.getByRole("button", { name: "Save", exact: true }).click();
  await dialog.waitFor({ state: "detached" });
  await expect.poll(() => project.read("mine.cdl")).toContain("robot Forager");
});

test("without a connection the page says so, and goes on when it is back", async () => {
  const { designer } = await opened();
  await designer.on("One");
  await designer.page.context().setOffline(true);
  await designer.page.context().setOffline(false);
  await designer.setValue(designer.named("Noise"), "persistence", "5 s");
  await designer.named("Noise").getByText("5 s").waitFor();
});

test("all windows go along with a document that is saved under another name", async () => {
  const { designer, mlab, project } = await begin();
  await designer.newAssemblage("Wander");
  await designer.place("Noise");
  const other = await look(`${mlab.url.replace(/#.*/, "")}${new URL(designer.page.url()).hash}`);
  await other.on("Wander");
  await designer.saveAs("wander");
  await expect.poll(() => project.read("wander.cdl")).toContain("Noise");
  await other.page
    .getByRole("navigation", { name: "Where you are" })
    .getByRole("button", { name: "wander.cdl" })
    .waitFor();
  expect(other.page.url()).toContain("wander.cdl");
  // Both work on in it.
  await other.place("Stand");
  await designer.named("Stand").waitFor();
  await designer.run();
});

test("what was refused is gone once the file's two texts are one again, and is told with the file's own name", async () => {
  const { designer, project } = await opened();
  const { page } = designer;
  await designer.on("One");
  await designer.setValue(designer.named("Noise"), "persistence", "3 s");
  project.write("one.cdl", kOne.replace("10 s", "20 s"));
  await designer.button("Merge both").click();
  await page.getByText(/The same lines were changed/).waitFor();
  await page.keyboard.press("Control+s");
  await page.getByText("one.cdl has been changed by somebody else", { exact: false }).waitFor();
  await designer.button("Keep mine").click();
  await page.locator(".banner").first().waitFor({ state: "detached" });
  expect(project.read("one.cdl")).toContain("3 s");
});

test("steps back lead to a document by the name that it was saved under", async () => {
  const { designer } = await begin();
  const { page } = designer;
  await designer.newAssemblage("Wander");
  await designer.place("Noise");
  await designer.toFile();
  await designer.saveAs("wander");
  await expect.poll(() => page.url()).toContain("wander.cdl");
  await page.goBack();
  await designer.on("Wander");
  await designer.named("Noise").waitFor();
  expect(page.url()).toContain("file=wander.cdl&page=Wander");
});

test("a tall drawing is printed on one sheet, whichever way that lies", async () => {
  const { designer } = await begin({ mission: "forage", file: "forager.cdl" });
  const { page } = designer;
  await designer.toDeclaration("Forage");
  await designer.node("Searching").waitFor();
  const sheets = () => page.locator(".print-sheet svg").count();
  await expect.poll(() => page.evaluate(() => window.dispatchEvent(new Event("beforeprint"))).then(sheets)).toBe(1);
  for (const landscape of [false, true]) {
    const pdf = (await page.pdf({ landscape, format: "A4" })).toString("latin1");
    expect(pdf.match(/\/Type\s*\/Page\b/g)).toHaveLength(1);
  }
});
