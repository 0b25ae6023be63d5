import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Targets_Standing_Fate as Fate, TargetsSchema } from "../../core/protocol.ts";
import { Recall, withLine } from "./history.ts";
import { standingLines, targetLines } from "./targets.ts";

describe("the lines typed before", () => {
  it("come back one by one, and the typed one at the end", () => {
    const recall = new Recall(["a", "b"], "");
    expect([recall.step(-1), recall.step(-1), recall.step(-1), recall.step(1), recall.step(1)]).toEqual([
      "b",
      "a",
      undefined,
      "b",
      "",
    ]);
  });
  it("are those that begin as what is typed", () => {
    const recall = new Recall(["UNIT a STOP", "OBSTACLE 1 2 3", "UNIT b STOP"], "unit");
    expect([recall.step(-1), recall.step(-1), recall.step(-1)]).toEqual(["UNIT b STOP", "UNIT a STOP", undefined]);
  });
  it("are kept once", () => {
    expect(withLine(["a", "b"], " a ")).toEqual(["b", "a"]);
    expect(withLine(["a"], "  ")).toEqual(["a"]);
  });
});

describe("the targets of a command", () => {
  it("say who is meant, who is left out and why, and what ends", () => {
    const targets = create(TargetsSchema, {
      units: [
        {
          name: "scouts",
          command: "MOVETO PP-A",
          robots: [1, 2, 3],
          skipped: [
            { robot: 4, reason: "it is parked" },
            { robot: 5, reason: "it is parked" },
            { robot: 9, reason: "it is stopped" },
          ],
        },
      ],
    });
    expect(targetLines(targets)).toEqual([
      {
        unit: "scouts",
        does: "MOVETO PP-A",
        meant: "3 robots (1–3)",
        skipped: ["robots 4, 5: it is parked", "robot 9: it is stopped"],
      },
    ]);
  });
  it("are followed by every other unit and what becomes of it, what changes first", () => {
    const standing = [
      { unit: "b", command: "MOVETO B", fate: Fate.GOES_ON, staying: 2 },
      { unit: "a", command: "MOVETO A", fate: Fate.GOES_ON_WITHOUT, leaving: [2], staying: 1 },
      { unit: "robots 5, 6", command: "OCCUPY X", fate: Fate.ENDS, leaving: [5, 6] },
      { unit: "c", fate: Fate.IDLE, staying: 4 },
      { unit: "d", fate: Fate.IDLE, staying: 4 },
    ];
    const lines = standingLines(create(TargetsSchema, { standing }));
    expect(lines.map((line) => `${line.unit}: ${line.fate}`)).toEqual([
      "a: goes on with MOVETO A without robot 2, 1 left",
      "robots 5, 6: ends OCCUPY X",
      "b: goes on with MOVETO B",
      "c, d: no command before or after",
    ]);
  });
  it("say so where nobody is meant", () => {
    expect(targetLines(create(TargetsSchema, { units: [{ name: "a" }] }))[0]?.meant).toBe("no robots");
  });
});
