// Where the stick is, from whatever moves it: pointer, keys, gamepad. x to the right, y ahead, inside the unit circle.

export interface StickVector {
  readonly x: number;
  readonly y: number;
}

export const kCentre: StickVector = { x: 0, y: 0 };

/** Shortens to length 1 what is longer; no number is the centre. */
export function clampStick(x: number, y: number): StickVector {
  if (!Number.isFinite(x) || !Number.isFinite(y)) return kCentre;
  const length = Math.hypot(x, y);
  return length > 1 ? { x: x / length, y: y / length } : { x: x + 0, y: y + 0 };
}

/** A pointer on the pad: offset from its middle, y down as on screens, in pixels. Near the middle it is the middle. */
export function stickOfPointer(dx: number, dy: number, radius: number): StickVector {
  if (!(radius > 0)) return kCentre;
  return withDeadZone(clampStick(dx / radius, -dy / radius), 0.06);
}

/** Nothing within `zone`, and from there to the edge the whole range, so that it begins softly. */
export function withDeadZone(stick: StickVector, zone: number): StickVector {
  const length = Math.hypot(stick.x, stick.y);
  if (length <= zone || zone >= 1) return kCentre;
  const scale = (length - zone) / (1 - zone) / length;
  return clampStick(stick.x * scale, stick.y * scale);
}

export type DriveKey = "up" | "down" | "left" | "right";

/** By place on the keyboard, so that WASD is a cross on every layout; null: no drive key. */
export function driveKeyOf(code: string): DriveKey | null {
  switch (code) {
    case "KeyW":
    case "ArrowUp":
      return "up";
    case "KeyS":
    case "ArrowDown":
      return "down";
    case "KeyA":
    case "ArrowLeft":
      return "left";
    case "KeyD":
    case "ArrowRight":
      return "right";
    default:
      return null;
  }
}

/** Opposite keys cancel out. With `slow` at a third of the speed. */
export function stickOfKeys(keys: ReadonlySet<DriveKey>, slow: boolean): StickVector {
  const x = (keys.has("right") ? 1 : 0) - (keys.has("left") ? 1 : 0);
  const y = (keys.has("up") ? 1 : 0) - (keys.has("down") ? 1 : 0);
  const stick = clampStick(x, y);
  return slow ? { x: stick.x / 3, y: stick.y / 3 } : stick;
}

export interface GamepadReading {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** Its left stick, and whether its dead-man's switch (a shoulder button or trigger) is held. */
export function readGamepad(pad: GamepadReading): { stick: StickVector; held: boolean } {
  const stick = withDeadZone(clampStick(pad.axes[0] ?? 0, -(pad.axes[1] ?? 0)), 0.15);
  const held = [4, 5, 6, 7].some((i) => {
    const button = pad.buttons[i];
    return button !== undefined && (button.pressed || button.value > 0.5);
  });
  return { stick, held };
}
