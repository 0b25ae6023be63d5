import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { DeadMan, type StickOutput } from "./dead_man.ts";
import { bearingText, distanceText, meanPose, objectiveFrom } from "./objective.ts";
import { clampStick, driveKeyOf, readGamepad, stickOfKeys, stickOfPointer, withDeadZone } from "./stick.ts";

function recorded() {
  const sent: StickOutput[] = [];
  return { sent, man: new DeadMan("scouts", (_, output) => sent.push(output)) };
}

describe("the dead-man's switch", () => {
  it("sends at once when it is taken, then twenty times a second, and the centre when it is let go", () => {
    const { sent, man } = recorded();
    man.hold("pointer", { x: 0, y: 1 }, 0);
    for (let now = 0; now <= 1000; now += 10) man.tick(now);
    expect(sent).toHaveLength(21);
    man.release("pointer");
    expect(sent.at(-1)).toEqual({ stick: { x: 0, y: 0 }, robotFrame: true });
    for (let now = 1000; now <= 2000; now += 10) man.tick(now);
    expect(sent).toHaveLength(22);
  });

  it("belongs to who took it first", () => {
    const { man } = recorded();
    expect(man.hold("keys", { x: 1, y: 0 }, 0)).toBe(true);
    expect(man.hold("pointer", { x: 0, y: 1 }, 1)).toBe(false);
    man.release("pointer");
    expect(man.heldBy).toBe("keys");
    man.release("keys");
    expect(man.hold("pointer", { x: 0, y: 1 }, 2)).toBe(true);
  });

  it("is let go when the frame changes", () => {
    const { sent, man } = recorded();
    man.hold("pointer", { x: 0, y: 1 }, 0);
    man.setRobotFrame(false);
    expect(man.heldBy).toBeNull();
    expect(sent.at(-1)?.stick).toEqual({ x: 0, y: 0 });
  });

  it("never leaves a stick off centre behind, whatever happens", () => {
    const source = fc.constantFrom("pointer", "keys", "gamepad") as fc.Arbitrary<"pointer" | "keys" | "gamepad">;
    const event = fc.oneof(
      fc.record({ type: fc.constant("hold" as const), source }),
      fc.record({ type: fc.constant("release" as const), source }),
      fc.record({ type: fc.constantFrom("stop", "tick", "frame") as fc.Arbitrary<"stop" | "tick" | "frame">, source }),
    );
    fc.assert(
      fc.property(fc.array(event), (events) => {
        const { sent, man } = recorded();
        let now = 0;
        for (const e of events) {
          now += 20;
          const happen = {
            hold: () => man.hold(e.source, { x: 0.5, y: 0.5 }, now),
            release: () => man.release(e.source),
            stop: () => man.stop(),
            frame: () => man.setRobotFrame(!man.robotFrame),
            tick: () => man.tick(now),
          };
          happen[e.type]();
          const last = sent.at(-1)?.stick ?? { x: 0, y: 0 };
          expect(man.heldBy === null ? last : man.value).toEqual(
            man.heldBy === null ? { x: 0, y: 0 } : { x: 0.5, y: 0.5 },
          );
        }
      }),
    );
  });
});

describe("the stick", () => {
  it("never leaves the unit circle", () => {
    fc.assert(
      fc.property(fc.double(), fc.double(), (x, y) => {
        const s = clampStick(x, y);
        expect(Math.hypot(s.x, s.y)).toBeLessThanOrEqual(1 + 1e-12);
      }),
    );
  });
  it("follows the pointer with up ahead, and rests in the middle", () => {
    expect(stickOfPointer(0, -50, 50)).toEqual({ x: 0, y: 1 });
    expect(stickOfPointer(500, 0, 50)).toEqual({ x: 1, y: 0 });
    expect(stickOfPointer(1, 1, 50)).toEqual({ x: 0, y: 0 });
    expect(stickOfPointer(10, 10, 0)).toEqual({ x: 0, y: 0 });
  });
  it("begins softly outside its dead zone and reaches the full range", () => {
    expect(withDeadZone({ x: 0.2, y: 0 }, 0.2)).toEqual({ x: 0, y: 0 });
    expect(withDeadZone({ x: 0.6, y: 0 }, 0.2).x).toBeCloseTo(0.5);
    expect(withDeadZone({ x: 1, y: 0 }, 0.2).x).toBeCloseTo(1);
  });
  it("follows keys by their place, opposite ones cancel out", () => {
    expect(driveKeyOf("KeyW")).toBe("up");
    expect(driveKeyOf("ArrowLeft")).toBe("left");
    expect(driveKeyOf("KeyQ")).toBeNull();
    expect(stickOfKeys(new Set(["up", "down"]), false)).toEqual({ x: 0, y: 0 });
    const diagonal = stickOfKeys(new Set(["up", "right"]), false);
    expect(Math.hypot(diagonal.x, diagonal.y)).toBeCloseTo(1);
    expect(stickOfKeys(new Set(["up"]), true).y).toBeCloseTo(1 / 3);
  });
  it("of a gamepad counts while a shoulder button is held", () => {
    const off = { pressed: false, value: 0 };
    const buttons = Array.from({ length: 8 }, () => off);
    expect(readGamepad({ axes: [0, -1], buttons }).held).toBe(false);
    const pressed = buttons.map((b, i) => (i === 5 ? { pressed: true, value: 1 } : b));
    const { stick, held } = readGamepad({ axes: [0, -1], buttons: pressed });
    expect(held).toBe(true);
    expect(stick.y).toBeCloseTo(1);
    expect(readGamepad({ axes: [], buttons: [] })).toEqual({ stick: { x: 0, y: 0 }, held: false });
  });
});

describe("the objective", () => {
  it("lies in a direction as on a compass", () => {
    const north = objectiveFrom({ x: 0, y: 0 }, { x: 0, y: 10 }, 0, false);
    expect([north.distance, north.bearing, north.wind]).toEqual([10, 0, "N"]);
    expect(objectiveFrom({ x: 0, y: 0 }, { x: -5, y: 0 }, 0, false)).toMatchObject({ bearing: 270, wind: "W" });
    expect(objectiveFrom({ x: 0, y: 0 }, { x: -0.001, y: 100 }, 0, false)).toMatchObject({ bearing: 0, wind: "N" });
  });
  it("is straight up on the pad when the robot faces it, in the robot's frame", () => {
    const ahead = objectiveFrom({ x: 0, y: 0 }, { x: 10, y: 0 }, 0, true);
    expect(ahead.needle).toBeCloseTo(0);
    const left = objectiveFrom({ x: 0, y: 0 }, { x: 0, y: 10 }, 0, true);
    expect(left.needle).toBeCloseTo(-Math.PI / 2);
    expect(objectiveFrom({ x: 0, y: 0 }, { x: 10, y: 0 }, 2, false).needle).toBeCloseTo(Math.PI / 2);
  });
  it("is seen from the middle of the unit", () => {
    expect(meanPose([])).toBeNull();
    const mean = meanPose([
      { x: 0, y: 0, heading: 3.1 },
      { x: 2, y: 4, heading: -3.1 },
    ]);
    expect(mean).toMatchObject({ x: 1, y: 2 });
    expect(Math.abs(mean?.heading ?? 0)).toBeCloseTo(Math.PI, 1);
  });
  it("is written as people read it", () => {
    expect(bearingText(7)).toBe("007°");
    expect(distanceText(3.12)).toBe("3.1 m");
    expect(distanceText(312.4)).toBe("312 m");
    expect(distanceText(12345)).toBe("12.3 km");
  });
});
