// Bodies, devices and societies by drawing and forms: somebody who types no CDL builds what Figures 9 and 10 show.
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { begin, type DesignerPage } from "./designer.ts";

const kBuilt = `robot Searcher is SearcherBody {
  movement = Wander();
}

class SearcherBody {
  body {
    radius = 40 cm;
    max_turn_rate = 90 deg/s;
    drive = differential;
    axle = 0.5 m;
  }
  actuator wheels: DriveAndSpin(max_velocity = 0.8 m/s) binds movement;
  sensor obstacles: DetectObstacles() binds sense_obstacles;
  sensor robots: DetectRobots() binds sense_robots;
}

operator FarSighted {
  sense_obstacles = DetectObstacles(range = 60 m);
}

society Search: caste {
  caste {
    team of 2 Searcher;
    team of 3 Searcher;
  } by FarSighted;
};
`;

const field = ({ details }: DesignerPage, name: string | RegExp) => details.getByRole("textbox", { name });

async function type(designer: DesignerPage, name: string | RegExp, value: string): Promise<void> {
  await field(designer, name).fill(value);
  await field(designer, name).press("Enter");
}

/** In a list that opens. */
async function pick(designer: DesignerPage, label: string | RegExp, option: RegExp, at = 0): Promise<void> {
  await designer.details.getByRole("button", { name: label }).nth(at).click();
  await designer.page.getByRole("option", { name: option }).click();
}

async function chooseFrom(designer: DesignerPage, title: string, letters: string): Promise<void> {
  const list = designer.page.getByRole("combobox", { name: title });
  await list.fill(letters);
  await designer.page.getByRole("option").first().waitFor();
  await list.press("Enter");
}

async function nothingSelected({ page }: DesignerPage): Promise<void> {
  await page.locator("body").press("Escape");
}

test("a robot with body and devices, and a society of two teams, without a word of text", async () => {
  const { designer, project } = await begin({ width: 1280, height: 900 });
  const { page, details, palette } = designer;
  await designer.button("New configuration").click();
  await designer.declare("Robot", "Searcher");
  await designer.place("Wander");
  await designer.wire(designer.output(designer.named("Wander")), page.locator('[data-handleid="v"].target'));
  await designer.hasWires(1);
  await nothingSelected(designer);
  // What it asks for is shown, and that nothing serves it.
  await details.getByText("the robot has no class yet").first().waitFor();

  await details.getByRole("button", { name: "New class…" }).click();
  const dialog = page.getByRole("dialog");
  expect(await dialog.getByRole("textbox", { name: "Name" }).inputValue()).toBe("SearcherBody");
  await dialog.getByRole("button", { name: "Add" }).click();
  await designer.on("SearcherBody");
  await designer.node("obstacles").waitFor();

  await type(designer, /^radius/, "40 cm");
  await type(designer, /^max turn rate/, "90");
  await details.getByRole("button", { name: "differential" }).click();
  await type(designer, /^axle/, "0.5 m");
  // What a body can't be is said where it is typed, and changes nothing.
  await type(designer, /^radius/, "3 s");
  await details.getByText("`radius` is in m").waitFor();
  await field(designer, /^radius/).press("Escape");

  await designer.select(designer.node("base"));
  await type(designer, "Name", "wheels");
  await designer.node("wheels").waitFor();
  await type(designer, /^max velocity/, "0.8 m/s");

  // One device more: what it serves, then what the library has for it, and why the rest does not fit.
  await palette.getByRole("button", { name: /^sense_robots/ }).click();
  const list = page.getByRole("combobox", { name: "What serves sense_robots?" });
  await list.fill("detect obstacles");
  await page.getByRole("option", { name: /it takes a list of robots, and this is a list of obstacles/ }).waitFor();
  await chooseFrom(designer, "What serves sense_robots?", "detect robots");
  await designer.node("robots").waitFor();
  await expect.poll(() => field(designer, "Name").inputValue()).toBe("robots");

  await designer.toFile();
  await palette.getByRole("button", { name: /^Operator of societies/ }).click();
  await dialog.getByRole("textbox", { name: "Name" }).fill("FarSighted");
  await dialog.getByRole("button", { name: "Add" }).click();
  await designer.on("FarSighted");
  await designer.button("Serve a binding point").last().click();
  await chooseFrom(designer, "What does the device serve?", "sense_obstacles");
  await chooseFrom(designer, "What serves sense_obstacles?", "detect obstacles");
  await designer.node("sense_obstacles").waitFor();
  await type(designer, /^range/, "60 m");
  await field(designer, /^range/).blur();

  await designer.toFile();
  await designer.declare("Society", "Search");
  await type(designer, "How many", "2");
  await palette.getByRole("button", { name: /^Searcher/ }).click();
  await expect.poll(() => details.getByRole("textbox", { name: "How many" }).count()).toBe(2);
  const second = details.getByRole("textbox", { name: "How many" }).nth(1);
  await second.fill("3");
  await second.press("Enter");
  await page.locator('.react-flow__node[data-id="Searcher_2"]', { hasText: "3 robots" }).waitFor();
  await atRest(() => designer.node("Searcher_2").boundingBox());
  await designer.select(designer.node("Searcher"));
  await designer.node("Searcher_2").click({ position: { x: 70, y: 10 }, modifiers: ["Shift"] });
  await details.getByRole("button", { name: "Make a caste of them" }).click();
  await details.getByText("Caste 1", { exact: true }).waitFor();
  await pick(designer, /Coordinated by/, /^FarSighted/, 1);
  await expect.poll(() => designer.verdict.textContent()).not.toMatch(/error|Checking/);

  await designer.saveAs("search");
  await expect.poll(() => project.read("search.cdl").split("\nlayout ")[0]).toBe(kBuilt);
  await designer.run();
  await designer.simulator.getByText("5 robots", { exact: true }).waitFor();
});

test("a device is led to another binding point, renamed, and taken away by keys", async () => {
  const { designer, project } = await begin({
    file: "cart.cdl",
    prepare: (made) =>
      made.write(
        "cart.cdl",
        `binding look_ahead(range: length = 5 m) -> Obstacles;

class Cart {
  sensor eyes: DetectObstacles() binds sense_obstacles;
  actuator wheels: Drive() binds movement;
}

robot R is Cart {
  movement = AvoidStaticObstacles(look_ahead(), sphere = 1 m, safety_margin = 0.5 m);
}
`,
      ),
  });
  const { page, details } = designer;
  await designer.verdict.waitFor();
  await designer.toDeclaration("Cart");
  // What R asks for stands there, and nothing serves it.
  const open = designer.node("$point.look_ahead");
  await open.getByText("nothing serves it").waitFor();
  await details.getByText("nothing serves it").waitFor();
  await atRest(() => open.boundingBox());
  await designer.wire(designer.output(designer.node("eyes")), designer.input(open, "served_by"));
  await open.getByText("served by").waitFor();
  await expect.poll(() => designer.verdict.textContent()).not.toMatch(/error|Checking/);
  // An actuator is none for it.
  await designer.select(designer.node("wheels"));
  await pick(designer, /Serves/, /look_ahead/);
  await page.getByText(/can’t serve look_ahead: it gives nothing/).waitFor();
  await designer.select(designer.node("eyes"));
  await page.locator("body").press("Delete");
  await designer.node("eyes").waitFor({ state: "detached" });
  await page.keyboard.press("Control+s");
  await expect.poll(() => project.read("cart.cdl")).not.toContain("eyes");
  await designer.button(/^Undo/).click();
  await designer.node("eyes").waitFor();
});

for (const [size, width, height] of [
  ["390 wide", 390, 800],
  ["200 %", 640, 400],
] as const) {
  test(`a class and a society are edited in a window ${size}`, async () => {
    const { designer } = await begin({ mission: "forage", file: "forager.cdl", width, height });
    const { page, details } = designer;
    await designer.verdict.waitFor();
    for (const [declaration, wanted] of [
      ["Collector", /^radius/],
      ["Foragers", "How many"],
    ] as const) {
      await page.goto(`${page.url().split("#")[0]}#file=forager.cdl&page=${declaration}`);
      await designer.on(declaration);
      const toggle = page.locator(".strip-toggle", { hasText: "Details" });
      if ((await toggle.getAttribute("aria-pressed")) !== "true") await toggle.click();
      await field(designer, wanted).first().scrollIntoViewIfNeeded();
      const boxes = await details.locator("input:not([type=range]), button, .card").evaluateAll((all) =>
        all.map((one) => {
          const { left, right } = one.getBoundingClientRect();
          return { words: one.outerHTML.slice(0, 80), left, right };
        }),
      );
      expect(boxes.filter(({ left, right }) => left < -1 || right > width + 1)).toEqual([]);
      await details.getByRole("button", { name: "Hide Details" }).click();
    }
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  });
}
