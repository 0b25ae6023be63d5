// What differs from another version: on the canvas, in the list below it, and from one to the next by keys.
import { execFileSync } from "node:child_process";
import { expect, test } from "vitest";
import { atRest } from "../at_rest.ts";
import { picture } from "../picture.ts";
import { begin, type DesignerPage } from "./designer.ts";

const kText = `assemblage Drift() -> Vector {
  cooperate {
    1: Noise(persistence = 12 s);
    1: AvoidStaticObstacles(readings = sense_obstacles(range = 4 m), sphere = 2 m, safety_margin = 0.5 m);
    0.5: Stand();
  }
}

assemblage Patrol() -> Vector {
  sequence {
    start Going: Drift();
      when Wait(delay = 9 s) goto Resting;
    Resting: Stand();
  }
}
`;

async function patrol(size = { width: 1280, height: 800 }) {
  const begun = await begin({
    file: "patrol.cdl",
    prepare: (project) => {
      project.write("patrol.cdl", kText);
      project.write("other.cdl", kText.replace("9 s", "5 s").replace("Resting: Stand();", "final Resting: Stand();"));
    },
    ...size,
  });
  await begun.designer.on("");
  return begun;
}

const list = ({ page }: DesignerPage) => page.getByRole("region", { name: "Differences", exact: true });

async function compare(designer: DesignerPage, what: string | RegExp, isFile = false): Promise<void> {
  await designer.page.locator("body").press("Shift+d");
  const dialog = designer.page.getByRole("dialog");
  await dialog.getByRole(isFile ? "option" : "button", { name: what }).click();
  await dialog.waitFor({ state: "detached" });
  await list(designer).waitFor();
}

test("what is edited shows at once how it differs from the saved file, and leaves no trace when that is left", async () => {
  const { designer } = await patrol();
  const { page } = designer;
  await compare(designer, "The saved file");
  await list(designer).getByText("Nothing differs").waitFor();
  await designer.toDeclaration("Drift");
  await designer.setValue(designer.named("Noise"), "persistence", "6 s");
  await list(designer).getByRole("button", { name: "Noise: persistence 12 s → 6 s" }).waitFor();
  await designer.named("Noise").getByText("persistence 12 s → 6 s").waitFor();
  await designer.select(designer.named("Stand"));
  await page.keyboard.press("Delete");
  const ghost = designer.node("-Stand");
  await ghost.waitFor();
  expect(await ghost.locator(".difference-sign").textContent()).toContain("removed");
  await expect.poll(() => page.locator("path.wire.differs.removed").count()).toBe(1);
  await designer.dragFromPalette("MoveAhead", 300, 430);
  await page.locator(".node.differs.added").waitFor();
  await atRest(() => designer.named("MoveAhead").boundingBox());
  await designer.wire(
    designer.output(designer.named("MoveAhead")),
    designer.input(designer.named("cooperate"), "members"),
  );
  await expect.poll(() => page.locator("path.wire.differs.added").count()).toBe(1);
  await designer.canvas.focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("f");
  await picture(page, "compare", { of: "designer" });
  await designer.button("Stop comparing").click();
  await list(designer).waitFor({ state: "detached" });
  await expect.poll(() => page.locator(".differs, .difference-sign").count()).toBe(0);
  expect(designer.troubles).toEqual([]);
});

test("keys go from difference to difference, across pages", async () => {
  const { designer } = await patrol();
  const { page } = designer;
  await compare(designer, "other.cdl", true);
  await expect.poll(() => list(designer).getByRole("listitem").count()).toBe(2);
  await page.locator("body").press("F7");
  await designer.on("Patrol");
  const first = list(designer).getByRole("button", { name: /^transition from Going/ });
  await expect.poll(() => first.getAttribute("aria-current")).toBe("true");
  await page.getByRole("button", { name: /^Transition 1 of Going/ }).waitFor();
  await page.locator("body").press("F7");
  await expect.poll(() => designer.node("Resting").getAttribute("class")).toContain("selected");
  await page.locator("body").press("Shift+F7");
  await expect.poll(() => first.getAttribute("aria-current")).toBe("true");
  await designer.toFile();
  await designer.node("Patrol").locator(".difference-count").getByText("2").waitFor();
  expect(designer.troubles).toEqual([]);
});

test("a revision of git is chosen by its date and subject", async () => {
  const { designer, project } = await patrol();
  const git = (...words: string[]) =>
    execFileSync("git", ["-c", "user.name=T", "-c", "user.email=t@example.org", ...words], { cwd: project.folder });
  git("init", "-q");
  git("add", "patrol.cdl");
  git("commit", "-q", "-m", "slower");
  await designer.toDeclaration("Drift");
  await designer.setValue(designer.named("Noise"), "persistence", "6 s");
  await compare(designer, /slower/);
  await list(designer)
    .getByRole("heading", { name: /^Compared with revision / })
    .waitFor();
  await list(designer).getByRole("button", { name: "Noise: persistence 12 s → 6 s" }).waitFor();
});
