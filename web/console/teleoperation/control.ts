// All sticks of this browser: which unit the keys and the gamepad steer, and everything that must let go at once.

import { DeadMan, type SendStick, type StickSource } from "./dead_man.ts";
import { type DriveKey, type GamepadReading, kCentre, readGamepad, type StickVector, stickOfKeys } from "./stick.ts";

export interface StickState {
  readonly stick: StickVector;
  readonly heldBy: StickSource | null;
  readonly robotFrame: boolean;
}

const kAtRest: StickState = { stick: kCentre, heldBy: null, robotFrame: true };

/** Time comes from outside [ms]; `changed` is called after every change that could be seen. */
export class StickControl {
  private readonly sticks = new Map<string, DeadMan>();
  private readonly keys = new Set<DriveKey>();
  private slow = false;
  private activeUnit = "";
  private readonly listeners = new Set<() => void>();
  private version = 0;

  constructor(
    private readonly send: SendStick,
    private readonly now: () => number,
  ) {}

  /** The units under teleoperation; sticks of others are let go and forgotten. */
  setUnits(units: readonly string[]): void {
    for (const [unit, stick] of this.sticks) {
      if (units.includes(unit)) continue;
      stick.stop();
      this.sticks.delete(unit);
    }
    for (const unit of units) if (!this.sticks.has(unit)) this.sticks.set(unit, new DeadMan(unit, this.send));
    if (!this.sticks.has(this.activeUnit)) this.activate(units[0] ?? "");
    this.changed();
  }

  /** Whom keys and gamepad steer; empty: nobody. */
  get active(): string {
    return this.activeUnit;
  }

  activate(unit: string): void {
    if (unit === this.activeUnit) return;
    this.releaseKeys();
    this.sticks.get(this.activeUnit)?.release("gamepad");
    this.activeUnit = unit;
    this.changed();
  }

  state(unit: string): StickState {
    const stick = this.sticks.get(unit);
    return stick ? { stick: stick.value, heldBy: stick.heldBy, robotFrame: stick.robotFrame } : kAtRest;
  }

  setRobotFrame(unit: string, robotFrame: boolean): void {
    this.sticks.get(unit)?.setRobotFrame(robotFrame);
    this.changed();
  }

  point(unit: string, stick: StickVector): void {
    this.activate(unit);
    this.sticks.get(unit)?.hold("pointer", stick, this.now());
    this.changed();
  }

  releasePointer(unit: string): void {
    this.sticks.get(unit)?.release("pointer");
    this.changed();
  }

  pressKey(key: DriveKey, slow: boolean): void {
    this.keys.add(key);
    this.slow = slow;
    this.applyKeys();
  }

  releaseKey(key: DriveKey, slow: boolean): void {
    this.keys.delete(key);
    this.slow = slow;
    this.applyKeys();
  }

  setSlow(slow: boolean): void {
    if (slow === this.slow) return;
    this.slow = slow;
    if (this.keys.size > 0) this.applyKeys();
  }

  /** The keys may have been let go without our seeing it. */
  releaseKeys(): void {
    this.keys.clear();
    this.sticks.get(this.activeUnit)?.release("keys");
    this.changed();
  }

  /** What the gamepad says now; null: there is none any more. */
  readPad(pad: GamepadReading | null): void {
    const active = this.sticks.get(this.activeUnit);
    if (!active) return;
    const { stick, held } = pad ? readGamepad(pad) : { stick: kCentre, held: false };
    const before = active.heldBy;
    if (held) active.hold("gamepad", stick, this.now());
    else active.release("gamepad");
    if (held || before === "gamepad") this.changed();
  }

  tick(): void {
    for (const stick of this.sticks.values()) stick.tick(this.now());
  }

  /** Focus lost, tab hidden, connection lost: whatever is held may not be any more. */
  stopAll(): void {
    this.keys.clear();
    for (const stick of this.sticks.values()) stick.stop();
    this.changed();
  }

  isHeld(): boolean {
    return [...this.sticks.values()].some((stick) => stick.heldBy !== null);
  }

  /** Fits useSyncExternalStore. */
  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  /** Grows with every change. */
  readonly snapshot = (): number => this.version;

  private applyKeys(): void {
    const active = this.sticks.get(this.activeUnit);
    if (this.keys.size === 0) active?.release("keys");
    else active?.hold("keys", stickOfKeys(this.keys, this.slow), this.now());
    this.changed();
  }

  private changed(): void {
    this.version += 1;
    for (const listener of [...this.listeners]) listener();
  }
}
