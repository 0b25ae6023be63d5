import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { PlanSchema, Status_Mode, Status_Outcome, StatusSchema } from "../../core/protocol.ts";
import { isSameRow, kStepOfOrder, missionProgress, runningNow, splitCommand, stepRows } from "./steps.ts";

const plan = create(PlanSchema, {
  steps: ["0", "1", "2"].map((label, i) => ({
    label,
    document: "a.mdl",
    line: 10 + i,
    commands: [{ text: `UNIT scouts MOVETO P${i}`, unit: "scouts" }],
  })),
});

const run = (step: number, outcome: Status_Outcome, more = {}) => ({
  label: String(step),
  step,
  outcome,
  start: 1,
  end: 2,
  commands: [
    { text: "UNIT scouts MOVETO P", unit: "scouts", outcome, progress: 0.5, arrival: 30, remaining: 12, ...more },
  ],
});

describe("the steps", () => {
  it("are all planned, and the first is next, before anything runs", () => {
    const rows = stepRows(plan, create(StatusSchema, { mode: Status_Mode.READY, currentStep: 0 }));
    expect(rows.map((row) => row.state)).toEqual(["next", "planned", "planned"]);
    expect(rows[1]?.line).toBe(11);
  });
  it("carry how the run stands", () => {
    const status = create(StatusSchema, {
      mode: Status_Mode.RUNNING,
      currentStep: 1,
      steps: [run(0, Status_Outcome.DONE), run(1, Status_Outcome.UNDER_WAY)],
    });
    const rows = stepRows(plan, status);
    expect(rows.map((row) => row.state)).toEqual(["done", "running", "planned"]);
    expect(rows[0]?.progress).toBe(1);
    expect(rows[1]).toMatchObject({ progress: 0.5, arrival: 30, end: -1 });
    expect(missionProgress(rows)).toBeCloseTo(0.5);
  });
  it("read alike until something that is shown of one is another", () => {
    const at = (progress: number) =>
      stepRows(
        plan,
        create(StatusSchema, { mode: Status_Mode.RUNNING, steps: [run(0, Status_Outcome.UNDER_WAY, { progress })] }),
      );
    expect(isSameRow(at(0.5)[0]!, at(0.5)[0]!)).toBe(true);
    expect(isSameRow(at(0.5)[0]!, at(0.6)[0]!)).toBe(false);
    expect(isSameRow(at(0.5)[1]!, at(0.6)[1]!)).toBe(true);
  });
  it("show the latest run of a step that was jumped back to", () => {
    const status = create(StatusSchema, {
      mode: Status_Mode.RUNNING,
      currentStep: 0,
      steps: [run(0, Status_Outcome.DONE), run(1, Status_Outcome.REPLACED), run(0, Status_Outcome.UNDER_WAY)],
    });
    expect(stepRows(plan, status).map((row) => row.state)).toEqual(["running", "replaced", "planned"]);
  });
  it("have typed commands among them, where they were given", () => {
    const status = create(StatusSchema, {
      mode: Status_Mode.RUNNING,
      currentStep: 0,
      steps: [run(0, Status_Outcome.UNDER_WAY), { ...run(0, Status_Outcome.UNDER_WAY), step: kStepOfOrder, label: "" }],
    });
    expect(stepRows(plan, status).map((row) => row.step)).toEqual([0, kStepOfOrder, 1, 2]);
    expect(runningNow(status)).toHaveLength(2);
  });
  it("have no measure while a unit is steered by hand", () => {
    const status = create(StatusSchema, {
      mode: Status_Mode.RUNNING,
      steps: [run(1, Status_Outcome.UNDER_WAY, { progress: -1, remaining: -1 })],
    });
    const row = stepRows(plan, status)[1];
    expect(row?.commands[0]?.progress).toBe(-1);
    expect(row?.progress).toBe(0);
  });
  it("that were aborted or failed are not behind us", () => {
    for (const outcome of [Status_Outcome.ABORTED, Status_Outcome.FAILED]) {
      const status = create(StatusSchema, {
        mode: Status_Mode.ENDED,
        steps: [run(0, Status_Outcome.DONE), run(1, outcome)],
      });
      expect(missionProgress(stepRows(plan, status))).toBeCloseTo(1 / 3);
    }
  });
  it("have no next one when the mission is over", () => {
    const rows = stepRows(plan, create(StatusSchema, { mode: Status_Mode.ENDED, currentStep: 0 }));
    expect(rows.every((row) => row.state === "planned")).toBe(true);
  });
  it("know no arrival where one of the commands knows none", () => {
    const status = create(StatusSchema, {
      mode: Status_Mode.RUNNING,
      steps: [
        {
          ...run(0, Status_Outcome.UNDER_WAY),
          commands: [
            { outcome: Status_Outcome.UNDER_WAY, arrival: 20 },
            { outcome: Status_Outcome.UNDER_WAY, arrival: -1 },
          ],
        },
      ],
    });
    expect(stepRows(plan, status)[0]?.arrival).toBe(-1);
  });
  it("are empty without a mission", () => expect(stepRows(undefined, undefined)).toEqual([]));
});

describe("a command's text", () => {
  it("is split into who and what", () => {
    expect(splitCommand('UNIT "the scouts" MOVETO PP-A FORMATION Column')).toEqual({
      unit: "the scouts",
      order: "MOVETO PP-A FORMATION Column",
    });
    expect(splitCommand("QUIT")).toEqual({ unit: "", order: "QUIT" });
  });
});
