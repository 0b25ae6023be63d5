import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { Control_Action, Status_Mode, Status_Outcome, StatusSchema } from "../../core/protocol.ts";
import { mainButton, type Situation, skipWords, stepWords } from "./main_button.ts";
import { kStepOfOrder } from "./steps.ts";

function at(mode: Status_Mode, more: Partial<Situation> = {}, status = {}): ReturnType<typeof mainButton> {
  return mainButton({
    status: create(StatusSchema, { mode, ...status }),
    isOperator: true,
    isElsewhen: false,
    isConnected: true,
    openQuestions: 0,
    errors: 0,
    nextLabel: "2",
    whyNotStart: "",
    isStarting: false,
    silentVehicles: [],
    hasVehicles: false,
    hasAsked: false,
    hasOperator: true,
    ...more,
  });
}

describe("Step and Skip", () => {
  const standing = create(StatusSchema, { steps: [{ outcome: Status_Outcome.DONE }] });
  const running = create(StatusSchema, { steps: [{ outcome: Status_Outcome.UNDER_WAY }] });
  it("say what they do to the step that runs", () => {
    expect(stepWords(running)).toContain("Finishes the step that runs");
    expect(skipWords(running)).toContain("Gives up the step that runs");
  });
  it("speak of the next one where nothing runs", () => {
    const order = create(StatusSchema, { steps: [{ step: kStepOfOrder, outcome: Status_Outcome.UNDER_WAY }] });
    for (const status of [standing, order, null]) {
      expect(stepWords(status)).toContain("next step");
      expect(skipWords(status)).toContain("Passes over");
    }
  });
});

describe("the main button", () => {
  it("executes, pauses, resumes", () => {
    expect(at(Status_Mode.READY)).toMatchObject({ label: "Execute", does: { action: Control_Action.EXECUTE } });
    expect(at(Status_Mode.RUNNING)).toMatchObject({ label: "Pause", does: { action: Control_Action.PAUSE } });
    const steps = [{ outcome: Status_Outcome.UNDER_WAY }];
    expect(at(Status_Mode.PAUSED, {}, { steps })).toMatchObject({
      label: "Resume",
      does: { action: Control_Action.RESUME },
    });
  });
  it("leads to the checklist while that keeps vehicles from moving, and no longer once it has begun", () => {
    const whyNotStart = "nobody has signed it.";
    expect(at(Status_Mode.READY, { whyNotStart })).toMatchObject({ does: { kind: "preflight" }, short: "Checklist" });
    expect(at(Status_Mode.READY, { whyNotStart }).hint).toContain(whyNotStart);
    expect(at(Status_Mode.RUNNING, { whyNotStart })).toMatchObject({ label: "Pause" });
    expect(at(Status_Mode.READY, { whyNotStart, isOperator: false })).toMatchObject({ label: "Ask for control" });
  });
  it("says what a start waits for, and is not pressed twice", () => {
    const starting = { isStarting: true, hasVehicles: true };
    expect(at(Status_Mode.READY, starting)).toMatchObject({ label: "Starting", does: { kind: "nothing" } });
    expect(at(Status_Mode.READY, starting).hint).toBe("Looks at the vehicles once more.");
    const hint = (silentVehicles: string[]) => at(Status_Mode.READY, { ...starting, silentVehicles }).hint;
    expect(hint(["veh-1"])).toBe("Waits for the vehicle veh-1.");
    expect(hint(["veh-1", "veh-2"])).toBe("Waits for the vehicles veh-1 and veh-2.");
    expect(at(Status_Mode.RUNNING, starting)).toMatchObject({ label: "Pause" });
  });
  it("resumes a step beside which an order has ended", () => {
    const steps = [{ outcome: Status_Outcome.UNDER_WAY }, { step: kStepOfOrder, outcome: Status_Outcome.DONE }];
    expect(at(Status_Mode.PAUSED, {}, { steps })).toMatchObject({ label: "Resume" });
  });
  it("goes on with the next step where it stands between two", () => {
    const steps = [{ outcome: Status_Outcome.DONE }];
    expect(at(Status_Mode.PAUSED, {}, { steps })).toMatchObject({
      label: "Execute",
      hint: "Goes on with step 2.",
      does: { action: Control_Action.EXECUTE },
    });
  });
  it("says that a single step stops by itself", () =>
    expect(at(Status_Mode.RUNNING, {}, { stopsAfterStep: true }).hint).toContain("stops by itself"));
  it("leads to the question that the mission waits for", () => {
    expect(at(Status_Mode.WAITING, { openQuestions: 1 })).toMatchObject({
      label: "Answer: Proceed?",
      does: { kind: "answer" },
    });
  });
  it("says which step comes next", () => expect(at(Status_Mode.READY).hint).toBe("Starts with step 2."));
  it("releases an emergency stop and nothing else", () => {
    expect(at(Status_Mode.STOPPED)).toMatchObject({ does: { action: Control_Action.RELEASE_STOP }, tone: "danger" });
  });
  it("says how the mission ended and begins it anew", () => {
    expect(at(Status_Mode.ENDED, {}, { outcome: Status_Outcome.FAILED }).hint).toContain("failed");
    expect(at(Status_Mode.ENDED).does).toEqual({ kind: "control", action: Control_Action.RESTART });
  });
  it("offers control to who only watches, once", () => {
    expect(at(Status_Mode.RUNNING, { isOperator: false })).toMatchObject({
      label: "Ask for control",
      does: { kind: "take-operator" },
    });
    expect(at(Status_Mode.RUNNING, { isOperator: false, hasOperator: false }).label).toBe("Take control");
    expect(at(Status_Mode.RUNNING, { isOperator: false, hasAsked: true }).does).toEqual({ kind: "nothing" });
  });
  it("shows the errors of a mission that can't run", () => {
    expect(at(Status_Mode.NO_MISSION, { errors: 3 }).does).toEqual({ kind: "show-errors" });
    expect(at(Status_Mode.NO_MISSION).does).toEqual({ kind: "nothing" });
  });
  it("says that a mission is getting ready, and is no button before that", () => {
    for (const mode of [Status_Mode.NO_MISSION, Status_Mode.ENDED]) {
      expect(at(mode, {}, { isBeingMade: true })).toMatchObject({ label: "Getting ready", does: { kind: "nothing" } });
    }
    expect(at(Status_Mode.NO_MISSION, { isOperator: false }, { isBeingMade: true }).label).toBe("Getting ready");
    expect(at(Status_Mode.STOPPED, {}, { isBeingMade: true }).does).toMatchObject({
      action: Control_Action.RELEASE_STOP,
    });
  });
  it("does nothing without a connection", () => {
    expect(at(Status_Mode.RUNNING, { isConnected: false }).does).toEqual({ kind: "nothing" });
  });
});

it("leads back to now from another moment, whoever looks there", () => {
  expect(at(Status_Mode.RUNNING, { isElsewhen: true })).toMatchObject({ label: "Back to now", does: { kind: "now" } });
  expect(at(Status_Mode.ENDED, { isElsewhen: true, isOperator: false }).does).toEqual({ kind: "now" });
});
