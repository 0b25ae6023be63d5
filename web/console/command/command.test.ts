import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { TargetsSchema } from "../../core/protocol.ts";
import { Recall, withLine } from "./history.ts";
import { targetLines } from "./targets.ts";

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
          replaces: "OCCUPY AA-AA1",
        },
      ],
    });
    expect(targetLines(targets)).toEqual([
      {
        unit: "scouts",
        does: "MOVETO PP-A",
        meant: "3 robots (1–3)",
        skipped: ["robots 4, 5: it is parked", "robot 9: it is stopped"],
        replaces: "OCCUPY AA-AA1",
      },
    ]);
  });
  it("say so where nobody is meant", () => {
    expect(targetLines(create(TargetsSchema, { units: [{ name: "a" }] }))[0]?.meant).toBe("no robots");
  });
});
