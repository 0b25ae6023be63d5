// The robots of the newest frame, as the 16-byte records that came: nothing is unpacked per robot, so that ten thousand
// cost next to nothing, and the renderer hands the same bytes to the graphics card.

import { turnBetween } from "./glide.ts";

const kWords = 4; // 32-bit words in a record
export const kRecordBytes = 16;
export const kRecordBlock = 256;

export const Life = { UNKNOWN: 0, RUNNING: 1, PARKED: 2, STOPPED: 3, FAULTED: 4 } as const;

export const Flag = { CONTACT: 0x08, STUCK: 0x10, TELEOPERATED: 0x20, DONE: 0x40, LOST: 0x80 } as const;

const kTurn = (2 * Math.PI) / 65536;

/** One frame's records, seen as bytes and as numbers. */
class Records {
  readonly bytes: Uint8Array;
  readonly words: Uint32Array;
  readonly floats: Float32Array;
  readonly halves: Uint16Array;

  constructor(readonly capacity: number) {
    const buffer = new ArrayBuffer(Math.ceil(capacity / kRecordBlock) * kRecordBlock * kRecordBytes);
    this.bytes = new Uint8Array(buffer);
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    this.halves = new Uint16Array(buffer);
  }
}

/**
 * Rows are those of the newest frame: a row is only good until the next one. Ids stay. Places and headings are those of
 * the frame, or on the way to them (see glide.ts): `share` says how far.
 */
export class RobotTable {
  /** Robots in the newest frame. */
  count = 0;
  /** Grows with each frame. */
  version = 0;
  private newest = new Records(0);
  private shown = new Records(0); // where the robots were shown when the newest frame came, in its rows
  private spare = new Records(0);
  private isGliding = false;
  private way = 1;
  private rowById = new Int32Array(64);

  /**
   * Takes over a frame's records. A rest that is no whole record is left out.
   *
   * @param reach  who is not farther from where it was shown glides from there [m]; 0: nobody does
   */
  accept(records: Uint8Array, reach = 0): void {
    const count = Math.floor(records.length / kRecordBytes);
    const next = this.spare.capacity >= count ? this.spare : new Records(Math.max(count, this.count * 2));
    next.bytes.set(records.subarray(0, count * kRecordBytes));
    if (reach > 0) this.keepShown(next, count, reach);
    this.isGliding = reach > 0;
    this.way = 1;
    this.spare = this.newest;
    this.newest = next;
    this.count = count;
    ++this.version;
    for (let row = 0; row < count; ++row) {
      const id = next.words[row * kWords]!;
      if (id < this.rowById.length) this.rowById[id] = row;
      else if (id < 1 << 22) {
        const wider = new Int32Array(Math.max(id + 1, this.rowById.length * 2));
        wider.set(this.rowById);
        wider[id] = row;
        this.rowById = wider;
      }
    }
  }

  clear(): void {
    this.count = 0;
    ++this.version;
  }

  /** The newest frame's records, four words each: uint32 id, float32 x, float32 y, uint16 heading, uint8 flags, uint8 0.
   * There is room for whole multiples of kRecordBlock records. */
  get words(): Uint32Array {
    return this.newest.words;
  }
  /** The same where the robots were shown before; good while `share` is below 1. */
  get wordsBefore(): Uint32Array {
    return this.shown.words;
  }

  /** How much of their way robots are shown to have behind them, 0..1. With each frame it is 1 at first. */
  get share(): number {
    return this.way;
  }
  set share(share: number) {
    this.way = this.isGliding ? share : 1;
  }

  id(row: number): number {
    return this.newest.words[row * kWords]!;
  }
  /** [m, world] */
  x(row: number): number {
    return this.between(row * kWords + 1);
  }
  /** [m, world] */
  y(row: number): number {
    return this.between(row * kWords + 2);
  }
  /** [rad, counter-clockwise from east], 0 .. 2 pi */
  heading(row: number): number {
    return this.turns(row) * kTurn;
  }
  /** Life in bits 0 to 2, then those of Flag. */
  flags(row: number): number {
    return this.newest.bytes[row * kRecordBytes + 14]!;
  }
  life(row: number): number {
    return this.flags(row) & 7;
  }

  /** The robot's row in this frame; -1 where it isn't in it. */
  rowOf(id: number): number {
    const row = this.rowById[id];
    return row !== undefined && row < this.count && this.newest.words[row * kWords] === id ? row : -1;
  }

  private between(at: number): number {
    const to = this.newest.floats[at]!;
    if (this.way >= 1) return to;
    const from = this.shown.floats[at]!;
    return from + (to - from) * this.way;
  }

  private turns(row: number): number {
    const at = row * kWords * 2 + 6;
    const to = this.newest.halves[at]!;
    return this.way >= 1 ? to : turnBetween(this.shown.halves[at]!, to, this.way);
  }

  private keepShown(next: Records, count: number, reach: number): void {
    const shown = this.shown.capacity >= count && this.way >= 1 ? this.shown : new Records(next.capacity);
    shown.bytes.set(next.bytes.subarray(0, count * kRecordBytes));
    for (let row = 0; row < count; ++row) {
      const at = row * kWords;
      const before = this.rowOf(next.words[at]!);
      if (before < 0) continue;
      const x = this.x(before);
      const y = this.y(before);
      if (!(Math.abs(x - next.floats[at + 1]!) <= reach && Math.abs(y - next.floats[at + 2]!) <= reach)) continue;
      shown.floats[at + 1] = x;
      shown.floats[at + 2] = y;
      shown.halves[at * 2 + 6] = this.turns(before);
    }
    this.shown = shown;
  }
}

/** One record, for tests and for pages that are fed without a server. */
export function writeRecord(
  view: DataView,
  row: number,
  robot: { id: number; x: number; y: number; heading: number; flags: number },
): void {
  const at = row * kRecordBytes;
  const turns = robot.heading / (2 * Math.PI);
  view.setUint32(at, robot.id, true);
  view.setFloat32(at + 4, robot.x, true);
  view.setFloat32(at + 8, robot.y, true);
  view.setUint16(at + 12, Math.round((turns - Math.floor(turns)) * 65536) & 0xffff, true);
  view.setUint8(at + 14, robot.flags);
}
