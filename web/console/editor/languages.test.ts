import { create } from "@bufbuild/protobuf";
import { StringStream } from "@codemirror/language";
import { describe, expect, it } from "vitest";
import { PlanSchema } from "../../core/protocol.ts";
import { kMdlParser, kOdlParser } from "./languages.ts";
import { stepAtLine } from "./step_at.ts";

function tokens(parser: typeof kMdlParser, line: string): string[] {
  const stream = new StringStream(line, 2, 2);
  const found: string[] = [];
  while (!stream.eol()) {
    stream.start = stream.pos;
    const style = parser.token(stream, null);
    if (style) found.push(`${style} ${stream.current()}`);
  }
  return found;
}

describe("the colours of MDL", () => {
  it("tell label, keyword, task, name and formation apart", () => {
    expect(tokens(kMdlParser, "  2a. UNIT scouts MOVETO ATK-AP1 FORMATION Column -- on")).toEqual([
      "labelName 2a.",
      "keyword UNIT",
      "variableName scouts",
      "typeName MOVETO",
      "variableName ATK-AP1",
      "keyword FORMATION",
      "atom Column",
      "comment -- on",
    ]);
  });
  it("know numbers, times and strings", () => {
    expect(tokens(kMdlParser, `UNTIL +1:30 SPEED -3.5 "a name"`)).toEqual([
      "keyword UNTIL",
      "number +1:30",
      "keyword SPEED",
      "number -3.5",
      `string "a name"`,
    ]);
  });
  it("end on any line", () => {
    for (const line of ['"open', "\u0000é😀", "---", "1..2", "<a> (b) ="])
      expect(tokens(kMdlParser, line)).toBeDefined();
  });
});

describe("the colours of ODL", () => {
  it("tell features and their words apart", () => {
    expect(tokens(kOdlParser, "HALLWAY east CENTERLINE 3.5 18 WIDTH 1.7")).toEqual([
      "typeName HALLWAY",
      "variableName east",
      "keyword CENTERLINE",
      "number 3.5",
      "number 18",
      "keyword WIDTH",
      "number 1.7",
    ]);
  });
});

describe("the step at the cursor", () => {
  const plan = create(PlanSchema, {
    steps: [
      { label: "0", document: "a.mdl", line: 10 },
      { label: "1", document: "a.mdl", line: 12 },
    ],
  });
  it("is the last one above", () => {
    expect([9, 10, 11, 12, 99].map((line) => stepAtLine(plan, "a.mdl", line))).toEqual([undefined, 0, 0, 1, 1]);
  });
  it("is none in another text", () => expect(stepAtLine(plan, "b.odl", 50)).toBeUndefined());
});
