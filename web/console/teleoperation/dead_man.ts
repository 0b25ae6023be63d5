// The dead-man's switch: the stick counts only while somebody holds it. Whatever lets go of it, or might have, ends the
// motion at once.

import { kCentre, type StickVector } from "./stick.ts";

export type StickSource = "pointer" | "keys" | "gamepad";

export interface StickOutput {
  readonly stick: StickVector;
  readonly robotFrame: boolean;
}

/** Sends what the stick says. */
export type SendStick = (unit: string, output: StickOutput) => void;

/** Milliseconds from one message to the next while the stick is held. */
export const kSendInterval = 50;

/**
 * One unit's stick. The source that took hold of it first keeps it until it lets go. While held, `tick` sends; letting go
 * sends the centre once, at once. Time comes from outside [ms].
 */
export class DeadMan {
  private holder: StickSource | null = null;
  private stick: StickVector = kCentre;
  private frame = true;
  private lastSent = Number.NEGATIVE_INFINITY;

  constructor(
    private readonly unit: string,
    private readonly send: SendStick,
  ) {}

  get heldBy(): StickSource | null {
    return this.holder;
  }

  get value(): StickVector {
    return this.holder === null ? kCentre : this.stick;
  }

  get robotFrame(): boolean {
    return this.frame;
  }

  /** Takes hold, or moves the stick. Refused (false) while another source holds it. */
  hold(source: StickSource, stick: StickVector, now: number): boolean {
    if (this.holder !== null && this.holder !== source) return false;
    const isNew = this.holder === null;
    this.holder = source;
    this.stick = stick;
    if (isNew) this.sendNow(now);
    return true;
  }

  /** Lets go. Nothing happens where this source does not hold it. */
  release(source: StickSource): void {
    if (this.holder === source) this.stop();
  }

  /** Somebody may have let go without our seeing it: focus lost, tab hidden, connection lost, panel closed. */
  stop(): void {
    const wasHeld = this.holder !== null;
    this.holder = null;
    this.stick = kCentre;
    this.lastSent = Number.NEGATIVE_INFINITY;
    if (wasHeld) this.send(this.unit, { stick: kCentre, robotFrame: this.frame });
  }

  /** Changing the frame under a held stick would turn the robot's way at once: it is let go first. */
  setRobotFrame(robotFrame: boolean): void {
    if (robotFrame === this.frame) return;
    this.stop();
    this.frame = robotFrame;
  }

  /** To be called often; sends every kSendInterval while held. */
  tick(now: number): void {
    if (this.holder !== null && now - this.lastSent >= kSendInterval - 1) this.sendNow(now);
  }

  private sendNow(now: number): void {
    this.lastSent = now;
    this.send(this.unit, { stick: this.stick, robotFrame: this.frame });
  }
}
