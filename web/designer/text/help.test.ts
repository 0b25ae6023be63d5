import { expect, test } from "vitest";
import { blocksOf, elementOf } from "./help.ts";

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

test("code, paragraphs and tables are told apart", () => {
  expect(blocksOf(kHelp)).toEqual([
    { kind: "code", text: "procedure AvoidRobots(\n  readings: Robots\n) -> Vector" },
    { kind: "text", text: "Pushes the robot away from others." },
    {
      kind: "table",
      rows: [
        ["input", "meaning"],
        ["readings", "what to keep away from"],
        ["sphere", "where the push starts"],
      ],
    },
    { kind: "text", text: "Source: Balch and Arkin 1998" },
  ]);
});

test("what looks like a mark-up of the page is text", () => {
  const element = elementOf(blocksOf("a < b <img src=x>")[0]!, document);
  expect(element.children.length).toBe(0);
  expect(element.textContent).toBe("a < b <img src=x>");
});

test("a table has a row for each line", () => {
  const element = elementOf(blocksOf(kHelp)[2]!, document);
  expect(element.querySelectorAll("tr").length).toBe(3);
  expect(element.querySelectorAll("th").length).toBe(2);
});
