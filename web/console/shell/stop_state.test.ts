import { create } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { Status_Mode, StatusSchema } from "../../core/protocol.ts";
import { isTaken, stopState, stopWords } from "./stop_state.ts";

const running = create(StatusSchema, { mode: Status_Mode.RUNNING });
const stopped = (standing: number, robots = 4) =>
  create(StatusSchema, { mode: Status_Mode.STOPPED, stop: { standing, robots } });

test("a stop that a machine has not confirmed names it", () => {
  const stop = { standing: 4, robots: 4, unreached: ["south"] };
  const state = stopState(create(StatusSchema, { mode: Status_Mode.STOPPED, stop }), false, false);
  expect(state.kind).toBe("stopping");
  expect(stopWords(state)).toBe("not confirmed by south");
});

test("a stop that was sent is not confirmed before the run says so, robot by robot", () => {
  expect(stopState(running, false, false).kind).toBe("none");
  expect(stopWords(stopState(running, true, false))).toBe("sent, not confirmed");
  expect(stopWords(stopState(stopped(1), true, false))).toBe("1 of 4 stand");
  expect(stopWords(stopState(stopped(4), true, false))).toBe("confirmed: all 4 stand");
});

test("a stop that a machine never confirms has been taken all the same, so that nobody sends it again", () => {
  const stop = { standing: 4, robots: 4, unreached: ["south"] };
  expect(isTaken(stopState(create(StatusSchema, { mode: Status_Mode.STOPPED, stop }), true, false))).toBe(true);
  expect(isTaken(stopState(running, true, false))).toBe(false);
  expect(isTaken(stopState(stopped(4), true, true)), "by what was said before it").toBe(false);
});

test("what a silent server said before confirms nothing", () => {
  expect(stopState(running, true, true).kind).toBe("sent");
  expect(stopState(stopped(4), true, true).kind).toBe("sent");
  expect(stopState(stopped(4), false, true).kind).toBe("confirmed");
});

test("where there are no robots there is nothing to wait for", () => {
  expect(stopWords(stopState(stopped(0, 0), true, false))).toBe("confirmed");
});
