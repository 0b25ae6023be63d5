import { expect, test } from "vitest";
import { helpElement } from "./help.ts";

const kHelp = `\`\`\`cdl
procedure AvoidRobots(
  readings: Robots
) -> Vector
\`\`\`

Pushes the robot **away** from \`others\`.

| input | unit | default | meaning |
|---|---|---|---|
| readings |  |  | what to keep away from |
| sphere |  |  | where the push starts |

Source: Balch and Arkin 1998`;

test("code, paragraphs and tables are elements, without columns that say nothing", () => {
  const element = helpElement(kHelp, document);
  expect([...element.children].map((child) => child.tagName)).toEqual(["PRE", "P", "TABLE", "P"]);
  expect(element.querySelector("pre")!.textContent).toBe("procedure AvoidRobots(\n  readings: Robots\n) -> Vector\n");
  expect(element.querySelector("strong")!.textContent).toBe("away");
  const rows = [...element.querySelector("table")!.rows].map((row) => [...row.cells].map((cell) => cell.textContent));
  expect(rows).toEqual([
    ["input", "meaning"],
    ["readings", "what to keep away from"],
    ["sphere", "where the push starts"],
  ]);
});

test("what looks like HTML, a link or a picture is text", () => {
  const element = helpElement("a < b <img src=x> [x](http://x) ![x](x) <http://x>", document);
  expect(element.querySelectorAll("img, a").length).toBe(0);
  expect(element.textContent).toContain("a < b <img src=x> [x](http://x)");
});
