import { describe, expect, it } from "vitest";
import { StickControl } from "./control.ts";

function control(...units: string[]) {
  const sent: string[] = [];
  let now = 0;
  const made = new StickControl(
    (unit, { stick }) => sent.push(`${unit} ${stick.x.toFixed(1)} ${stick.y.toFixed(1)}`),
    () => now,
  );
  made.setUnits(units);
  return {
    made,
    sent,
    pass: (ms: number) => {
      for (let i = 0; i < ms; i += 10) {
        now += 10;
        made.tick();
      }
    },
  };
}

const kPad = {
  axes: [1, 0],
  buttons: Array.from({ length: 8 }, (_, i) => ({ pressed: i === 4, value: i === 4 ? 1 : 0 })),
};

describe("the sticks", () => {
  it("of several units move at the same time, each for itself", () => {
    const { made, sent, pass } = control("left", "right");
    made.point("left", { x: 0, y: 1 });
    made.point("right", { x: 1, y: 0 });
    pass(50);
    expect(sent).toEqual(["left 0.0 1.0", "right 1.0 0.0", "left 0.0 1.0", "right 1.0 0.0"]);
    made.releasePointer("left");
    expect(sent.at(-1)).toBe("left 0.0 0.0");
    expect(made.isHeld()).toBe(true);
  });

  it("follow keys until the last one is let go", () => {
    const { made, sent } = control("a");
    made.pressKey("up", false);
    made.pressKey("right", false);
    made.releaseKey("up", false);
    expect(made.state("a")).toMatchObject({ heldBy: "keys", stick: { x: 1, y: 0 } });
    made.releaseKey("right", false);
    expect(sent.at(-1)).toBe("a 0.0 0.0");
    expect(made.state("a").heldBy).toBeNull();
  });

  it("stand when another unit becomes the active one", () => {
    const { made, sent } = control("a", "b");
    made.pressKey("up", false);
    made.activate("b");
    expect(sent.at(-1)).toBe("a 0.0 0.0");
    expect(made.state("b").heldBy).toBeNull();
  });

  it("stand when focus, tab or connection is lost", () => {
    const { made, sent, pass } = control("a", "b");
    made.point("a", { x: 0, y: 1 });
    made.activate("b");
    made.pressKey("up", false);
    made.stopAll();
    const before = sent.length;
    expect(sent.slice(-2).sort()).toEqual(["a 0.0 0.0", "b 0.0 0.0"]);
    pass(500);
    expect(sent).toHaveLength(before);
  });

  it("of a unit whose teleoperation has ended are let go", () => {
    const { made, sent } = control("a");
    made.point("a", { x: 0, y: 1 });
    made.setUnits(["b"]);
    expect(sent.at(-1)).toBe("a 0.0 0.0");
    expect(made.active).toBe("b");
    expect(made.state("a").heldBy).toBeNull();
  });

  it("follow a gamepad while its shoulder button is held, and stand when it is unplugged", () => {
    const { made, sent } = control("a");
    made.readPad({ ...kPad, buttons: [] });
    expect(sent).toEqual([]);
    made.readPad(kPad);
    expect(made.state("a")).toMatchObject({ heldBy: "gamepad", stick: { x: 1, y: 0 } });
    made.readPad(null);
    expect(sent.at(-1)).toBe("a 0.0 0.0");
  });
});
