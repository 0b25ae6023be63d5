// What can be done on the canvas: each its own small test.
import { expect, test } from "vitest";
import { begin, type DesignerPage, look } from "./designer.ts";

const kTwo = `// Kept as it is.
assemblage Two() {
  let near = Detect(Mine);
  cooperate {
    1: Noise(persistence = 10 s);  // drifts
    0.5: AvoidStaticObstacles(readings = sense_obstacles(range = 2 m), sphere = 1 m, safety_margin = 0.3 m);
  }
}
`;

const opened = () =>
  begin({ file: "two.cdl", prepare: (project) => project.write("two.cdl", kTwo), width: 1600, height: 900 });

test("a wire of another type is refused while it is drawn, with the reason, and fitting inputs light up", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  const sum = designer.named("cooperate");
  const noise = designer.named("Noise");
  await designer.hold(designer.output(designer.named("near")), designer.input(sum, "members"));
  await designer.page.getByText("it takes a Vector, and this is a truth value").waitFor();
  await sum.locator(".row.refused").first().waitFor();
  await designer.page.mouse.up();
  await designer.hold(designer.output(noise), designer.result);
  await designer.page.locator(".result.fits").waitFor();
  await designer.page.keyboard.press("Escape");
  await designer.page.mouse.up();
});

test("one value changed is one line of the file, and undo takes it back by its name", async () => {
  const { designer, project } = await opened();
  await designer.on("Two");
  await designer.setValue(designer.named("Noise"), "persistence", "4 s");
  await designer.button(/^Undo .*persistence/).waitFor();
  await designer.page.keyboard.press("Control+s");
  await expect.poll(() => project.read("two.cdl")).toBe(kTwo.replace("10 s", "4 s"));
  await designer.button(/^Undo .*persistence/).click();
  await designer.named("Noise").getByText("10 s").waitFor();
  await designer.button(/^Redo .*persistence/).click();
  await designer.named("Noise").getByText("4 s").waitFor();
});

test("nodes are moved by keys, removed, and brought back", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  const { page } = designer;
  await designer.select(designer.named("Noise"));
  const before = (await designer.named("Noise").boundingBox())!;
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await designer.button(/^Undo move/).waitFor();
  await expect.poll(async () => (await designer.named("Noise").boundingBox())!.y).toBeGreaterThan(before.y);
  await page.keyboard.press("Delete");
  await designer.named("Noise").waitFor({ state: "detached" });
  await page.keyboard.press("Control+z");
  await designer.named("Noise").waitFor();
});

test("what is copied is CDL, and is pasted into another window", async () => {
  const { designer, mlab } = await opened();
  await designer.on("Two");
  await designer.select(designer.named("Noise"));
  await designer.page.keyboard.press("Control+c");
  await expect
    .poll(() => designer.page.evaluate(() => navigator.clipboard.readText()))
    .toContain("Noise(persistence = 10 s)");
  const text = await designer.page.evaluate(() => navigator.clipboard.readText());
  const other = await look(mlab.url.replace(/#.*/, ""));
  await other.on("Two");
  await other.page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
  await other.canvas.hover({ position: { x: 300, y: 400 } });
  await other.page.keyboard.press("Control+v");
  await expect.poll(() => other.page.locator(".react-flow__node", { hasText: "Noise" }).count()).toBe(2);
  // Both windows show the same document.
  await expect.poll(() => designer.page.locator(".react-flow__node", { hasText: "Noise" }).count()).toBe(2);
});

const kBeside = `assemblage One() {
  let walk = Noise();
  let rest = Stand();
  Noise()
}

assemblage Two() {
  Stand()
}

layout One {
  walk 0 0;
  rest 320 40;
  Noise 0 400;
}

layout Two {
  Stand 0 400;
}
`;

/** How the second of two nodes stands to the first [px], and whether they overlap. */
async function standing({ page }: DesignerPage, names: [string, string]) {
  // Both in one moment: the camera may be on its way.
  return page.evaluate((both) => {
    const nodes = both.map((name) => document.querySelector<HTMLElement>(`.react-flow__node[data-id="${name}"]`)!);
    const [a, b] = nodes.map((node) => node.getBoundingClientRect()) as [DOMRect, DOMRect];
    const scale = a.width / nodes[0]!.offsetWidth;
    return {
      dx: Math.round((b.x - a.x) / scale),
      dy: Math.round((b.y - a.y) / scale),
      overlap: a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom,
    };
  }, names);
}

test("nodes that stand side by side are pasted so, in this window and in another", async () => {
  const { designer, mlab, project } = await begin({
    file: "beside.cdl",
    prepare: (its) => its.write("beside.cdl", kBeside),
    width: 1600,
    height: 900,
  });
  await designer.goTo("One");
  const { page } = designer;
  const beside = { dx: 320, dy: 40, overlap: false };
  expect(await standing(designer, ["walk", "rest"])).toEqual(beside);
  await designer.select(designer.node("walk"));
  await designer.node("rest").click({ modifiers: ["Control"], position: { x: 70, y: 10 } });
  await page.keyboard.press("Control+c");
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain("rest 320 40;");
  await page.locator(".react-flow__pane").hover({ position: { x: 40, y: 640 } });
  await page.keyboard.press("Control+v");
  await designer.node("rest_2").waitFor();
  expect(await standing(designer, ["walk_2", "rest_2"])).toEqual(beside);
  // What has come is selected: a second copy stands beside it.
  await expect.poll(() => page.locator(".react-flow__node.selected").count()).toBe(2);
  await page.keyboard.press("Control+d");
  await designer.node("rest_2_2").waitFor();
  expect(await standing(designer, ["walk_2_2", "rest_2_2"])).toEqual(beside);
  expect(await standing(designer, ["walk_2", "walk_2_2"])).toMatchObject({ dx: 40, dy: 40 });

  const text = await page.evaluate(() => navigator.clipboard.readText());
  const other = await look(mlab.url.replace(/#.*/, ""), { width: 1600, height: 900 });
  await other.goTo("Two");
  await other.page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
  await other.page.locator(".react-flow__pane").hover({ position: { x: 400, y: 60 } });
  await other.page.keyboard.press("Control+v");
  await other.node("rest").waitFor();
  expect(await standing(other, ["walk", "rest"])).toEqual(beside);
  await other.page.keyboard.press("Control+s");
  await expect.poll(() => project.read("beside.cdl")).toMatch(/assemblage Two\(\) {\n {2}let walk = Noise\(\);/);
  const layout = project.read("beside.cdl").split("layout Two {")[1] ?? "";
  const at = (name: string) => new RegExp(`  ${name} (-?\\d+) (-?\\d+);`).exec(layout)!.slice(1).map(Number);
  const [walk, rest] = [at("walk"), at("rest")];
  expect([rest[0]! - walk[0]!, rest[1]! - walk[1]!]).toEqual([320, 40]);
  expect(layout).toContain("  Stand 0 400;");
});

test("nodes become an assemblage, which is entered by a double click and taken apart again", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  const { page } = designer;
  await page.keyboard.press("Control+a");
  await designer.named("near").click({ modifiers: ["Control"], position: { x: 70, y: 10 } });
  await page.keyboard.press("Control+g");
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("textbox", { name: "Name" }).fill("Drift");
  await dialog.getByRole("button", { name: "Make it" }).click();
  await designer.named("Drift").waitFor();
  await designer.named("Drift").dblclick({ position: { x: 70, y: 10 } });
  await designer.on("Drift");
  await designer.named("Noise").waitFor();
  await page.keyboard.press("u");
  await page.goBack();
  await designer.toFile();
  await page.getByRole("navigation", { name: "Where you are" }).getByRole("button", { name: "two.cdl" }).waitFor();
});

test("text and drawing follow each other", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  if (!(await designer.text.isVisible())) await designer.button("Text").click();
  await designer.text.getByText("persistence").first().waitFor();
  await designer.text.getByText("10 s").first().click();
  await designer.page.keyboard.press("Control+f");
  await designer.page.getByRole("textbox", { name: "Find" }).pressSequentially("10 s");
  await designer.page.keyboard.press("Enter");
  await designer.page.keyboard.press("Escape");
  await designer.page.keyboard.type("7 s");
  await designer.named("Noise").getByText("7 s").waitFor();
  await designer.setValue(designer.named("Noise"), "persistence", "9 s");
  await designer.text.getByText("persistence = 9 s").waitFor();
});

test("problems lead to their node", async () => {
  const { designer } = await begin({
    file: "bad.cdl",
    prepare: (project) => project.write("bad.cdl", "assemblage Bad() {\n  cooperate {\n    1: Nosie();\n  }\n}\n"),
  });
  await designer.on("Bad");
  await expect.poll(() => designer.verdict.textContent()).toMatch(/\d error/);
  await designer.verdict.click();
  await designer.problems.getByRole("button", { name: /Nosie/ }).first().click();
  await expect.poll(() => designer.page.locator(".react-flow__node.selected").count()).toBe(1);
  await designer.page.locator(".node.has-error").first().waitFor();
});

test("a link leads to a node", async () => {
  const { designer, mlab, project } = await opened();
  await designer.on("Two");
  const url = new URL(mlab.url);
  url.hash = "file=two.cdl&page=Two&node=Noise";
  const other = await look(url.href);
  await other.on("Two");
  await expect.poll(() => other.page.locator(".react-flow__node.selected").getAttribute("data-id")).toBe("Noise");
  expect(project.read("two.cdl")).toBe(kTwo);
});

test("comments and frames are kept in the file", async () => {
  const { designer, project } = await opened();
  await designer.on("Two");
  await designer.page.keyboard.press("Shift+C");
  await designer.page.locator(".note").click();
  const field = designer.details.getByRole("textbox", { name: "Text" });
  await field.fill("Off things");
  await field.press("Control+Enter");
  await designer.page.locator(".note", { hasText: "Off things" }).waitFor();
  await designer.page.keyboard.press("Control+s");
  await expect.poll(() => project.read("two.cdl")).toContain("Off things");
});

test("automatic layout is one step that can be undone", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  await designer.page.keyboard.press("l");
  await designer.button("Undo automatic layout").waitFor();
  const boxes = await designer.page.locator(".react-flow__node").evaluateAll((nodes) =>
    nodes.map((node) => {
      const { x, y, width, height } = node.getBoundingClientRect();
      return { x, y, width, height };
    }),
  );
  for (let i = 0; i < boxes.length; ++i) {
    for (let j = 0; j < i; ++j) {
      const [a, b] = [boxes[i]!, boxes[j]!];
      const isOver = a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
      expect(isOver).toBe(false);
    }
  }
});

test("a mend that the server offers is a button, in the list of problems and beside the node, and mends the text", async () => {
  const bad = "assemblage Bad() {\n  cooperate {\n    1: Nosie();\n    1: Niose();\n  }\n}\n";
  const { designer, project } = await begin({ file: "bad.cdl", prepare: (one) => one.write("bad.cdl", bad) });
  await designer.on("Bad");
  await expect.poll(() => designer.verdict.textContent()).toMatch(/2 errors/);
  await designer.verdict.click();
  const entry = (name: string) => designer.problems.getByRole("listitem").filter({ hasText: name });
  const mend = (name: string) => entry(name).getByRole("button", { name: "Write “Noise”" });
  await mend("Nosie").waitFor();
  await mend("Niose").waitFor();
  await mend("Nosie").click();
  await entry("Nosie").waitFor({ state: "detached" });
  await designer.button("Undo write `Noise`").waitFor();
  await designer.select(designer.named("Niose"));
  await designer.details.getByRole("button", { name: "Write “Noise”" }).click();
  await designer.problems.getByText("Nothing is wrong").waitFor();
  await designer.page.locator("body").press("Control+s");
  await expect.poll(() => project.read("bad.cdl")).toBe(bad.replace("Nosie", "Noise").replace("Niose", "Noise"));
});

test("names in the palette are whole", async () => {
  const { designer } = await begin({ file: "two.cdl", prepare: (project) => project.write("two.cdl", kTwo) });
  await designer.on("Two");
  await designer.palette.getByText("Coordinate by Weighted sum", { exact: true }).waitFor();
  const cut = await designer.palette
    .locator(".palette-title")
    .evaluateAll((names) => names.filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent));
  expect(cut).toEqual([]);
});

test("a slider over many decades goes by ratios, and the field takes any number", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  await designer.select(designer.named("Noise"));
  const slider = designer.details.getByRole("slider", { name: "persistence, slider" });
  const field = designer.details.getByRole("textbox", { name: /^persistence/ });
  await slider.focus();
  await slider.press("ArrowRight");
  const number = async () => Number.parseFloat(await field.inputValue());
  await expect.poll(number).toBeGreaterThan(10);
  expect(await number()).toBeLessThan(12.5);
  await designer
    .named("Noise")
    .getByText(`${await number()} s`)
    .waitFor();
  await slider.focus();
  await slider.press("PageDown");
  await expect.poll(number).toBeLessThan(6);
  await field.fill("1.23456 s");
  await field.press("Enter");
  await designer.named("Noise").getByText("1.23456 s").waitFor();
  expect(await field.inputValue()).toBe("1.23456 s");
});

test("a drawing is exported while it is still being laid out", async () => {
  const { designer, mlab } = await begin({ file: "two.cdl", prepare: (project) => project.write("two.cdl", kTwo) });
  await designer.on("Two");
  const { page } = designer;
  // The layout's program comes late, as on a slow machine.
  let isHeld = true;
  await page.route(/\/worker-[^/]*\.js/, async (route) => {
    while (isHeld) await new Promise((resolve) => setTimeout(resolve, 50));
    await route.continue();
  });
  await page.goto("about:blank");
  await page.goto(mlab.url);
  await page.locator('[aria-label="Drawing of Two"][aria-busy=true]').waitFor();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Search everything" }).fill("as SVG");
  const coming = page.waitForEvent("download");
  await page.keyboard.press("Enter");
  expect(await page.locator(".react-flow__node").count()).toBe(0);
  isHeld = false;
  expect((await coming).suggestedFilename()).toBe("Two.svg");
});

test("a drawing is exported as SVG and as PNG", async () => {
  const { designer } = await opened();
  await designer.on("Two");
  for (const [name, begin] of [
    ["SVG", "<svg "],
    ["PNG", "\u0089PNG".slice(1)],
  ] as const) {
    await designer.page.keyboard.press("Control+k");
    await designer.page.getByRole("combobox", { name: "Search everything" }).fill(`as ${name}`);
    const coming = designer.page.waitForEvent("download");
    await designer.page.keyboard.press("Enter");
    const download = await coming;
    expect(download.suggestedFilename()).toBe(`Two.${name.toLowerCase()}`);
    const stream = await download.createReadStream();
    const chunks: Buffer[] = [];
    for await (const chunk of stream) chunks.push(chunk as Buffer);
    expect(Buffer.concat(chunks).toString("latin1").slice(0, 40)).toContain(begin);
  }
});
