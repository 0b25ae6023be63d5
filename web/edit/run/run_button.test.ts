import { expect, test } from "vitest";
import { Status_Mode } from "../../core/protocol.ts";
import { offersChange, offersTakeOver, runButton, type Situation } from "./run_button.ts";

const first: Situation = {
  isConnected: true,
  isRecording: false,
  isElsewhen: false,
  isBusy: false,
  errors: 0,
  hasSubject: true,
  isOurs: false,
  isCurrent: false,
  isSameSetup: false,
  mode: Status_Mode.NO_MISSION,
};
const tried = { ...first, isOurs: true, isCurrent: true, isSameSetup: true };

test("at first it tries, and then it pauses and goes on", () => {
  expect(runButton(first).act).toBe("try");
  expect(runButton({ ...tried, mode: Status_Mode.RUNNING })).toMatchObject({ act: "pause", label: "Pause" });
  expect(runButton({ ...tried, mode: Status_Mode.PAUSED })).toMatchObject({ act: "resume", label: "Go on" });
  expect(runButton({ ...tried, mode: Status_Mode.READY }).act).toBe("execute");
  expect(runButton({ ...tried, mode: Status_Mode.ENDED }).act).toBe("try");
});

test("beside a recording nothing runs", () => {
  const recording = { ...first, isRecording: true, isElsewhen: true, mode: Status_Mode.RUNNING };
  expect(runButton(recording)).toMatchObject({ act: "none", label: "Recording" });
});

test("a text that was changed is tried anew, at the latest when it is paused", () => {
  const changed = { ...tried, isCurrent: false };
  expect(runButton({ ...changed, mode: Status_Mode.PAUSED }).act).toBe("try");
  expect(runButton({ ...changed, mode: Status_Mode.RUNNING }).act).toBe("pause");
  expect(offersChange({ ...changed, mode: Status_Mode.RUNNING })).toBe(true);
  expect(offersChange({ ...changed, errors: 1, mode: Status_Mode.RUNNING })).toBe(false);
  expect(offersChange({ ...tried, mode: Status_Mode.RUNNING })).toBe(false);
});

test("robots can take over a change of the text, and of nothing else", () => {
  const changed = { ...tried, isCurrent: false, mode: Status_Mode.RUNNING };
  expect(offersTakeOver(changed)).toBe(true);
  expect(offersTakeOver({ ...changed, mode: Status_Mode.PAUSED })).toBe(true);
  expect(offersTakeOver({ ...changed, mode: Status_Mode.READY })).toBe(false);
  expect(offersTakeOver({ ...changed, isSameSetup: false })).toBe(false);
  expect(offersTakeOver({ ...changed, errors: 1 })).toBe(false);
  expect(offersTakeOver({ ...changed, isBusy: true })).toBe(false);
  expect(offersTakeOver({ ...changed, isCurrent: true })).toBe(false);
});

test("what does not compile leads to what is wrong, but what runs can still be paused", () => {
  expect(runButton({ ...first, errors: 2 }).act).toBe("problems");
  expect(runButton({ ...tried, isCurrent: false, errors: 2, mode: Status_Mode.RUNNING }).act).toBe("pause");
});

test("nothing happens without a connection, while it compiles, or without something to run", () => {
  expect(runButton({ ...first, isConnected: false }).act).toBe("none");
  expect(runButton({ ...first, isBusy: true })).toMatchObject({ act: "none", label: "Compiling…" });
  expect(runButton({ ...first, hasSubject: false }).act).toBe("none");
});

test("somebody else's mission is said to be replaced", () => {
  expect(runButton({ ...first, mode: Status_Mode.RUNNING })).toMatchObject({
    act: "try",
    hint: "Takes the place of the mission that runs",
  });
});

test("an emergency stop is released first", () => {
  expect(runButton({ ...tried, mode: Status_Mode.STOPPED }).act).toBe("release");
});

test("from another moment of the run it leads back to now, and offers nothing else", () => {
  const elsewhen = { ...tried, isCurrent: false, isElsewhen: true, mode: Status_Mode.RUNNING };
  expect(runButton(elsewhen)).toMatchObject({ act: "now", label: "Back to now" });
  expect([offersChange(elsewhen), offersTakeOver(elsewhen)]).toEqual([false, false]);
});
