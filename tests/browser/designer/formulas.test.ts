// Formulas: arithmetic is a box with its words in a field, wired from what it reads.
import { expect, test } from "vitest";
import { begin } from "./designer.ts";

const kApproach = `assemblage Approach(goal: Point, near: length = 2 m) {
  let way = DetectGoal(goal);
  let share = length(way) / (3 * near);
  cooperate {
    share: MoveToGoal(way);
    1 / 2: Noise(persistence = 2 * 3 s);
  }
}
`;

test("a formula has its words in a field, and a wire from each node that they name", async () => {
  const { designer } = await begin({
    file: "approach.cdl",
    prepare: (project) => project.write("approach.cdl", kApproach),
    width: 1280,
    height: 800,
  });
  await designer.on("Approach");
  const share = designer.node("share");
  await share.waitFor();
  await designer.hasWires(6);
  await share.getByText("share").first().click();
  const words = designer.details.getByRole("textbox", { name: /^formula/i });
  await expect.poll(() => words.inputValue()).toBe("length(way) / (3 * near)");
  await words.fill("clamp(length(way) / near, 0.2, 1)");
  await words.press("Enter");
  await expect.poll(() => words.inputValue()).toBe("clamp(length(way) / near, 0.2, 1)");
  await designer.hasWires(6);
  // What it no longer names has no wire.
  await words.fill("near / 4 m");
  await words.press("Enter");
  await designer.hasWires(5);
  expect(designer.troubles).toEqual([]);
});
