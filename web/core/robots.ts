// The robots of the newest frame, as the 16-byte records that came: nothing is unpacked per robot, so that ten thousand
// cost next to nothing, and the renderer hands the same bytes to the graphics card.

const kWords = 4; // 32-bit words in a record
export const kRecordBytes = 16;
export const kRecordBlock = 256;

export const Life = { UNKNOWN: 0, RUNNING: 1, PARKED: 2, STOPPED: 3, FAULTED: 4 } as const;

export const Flag = { CONTACT: 0x08, STUCK: 0x10, TELEOPERATED: 0x20, DONE: 0x40, LOST: 0x80 } as const;

const kTurn = (2 * Math.PI) / 65536;

/** Rows are those of the newest frame: a row is only good until the next one. Ids stay. */
export class RobotTable {
  /** Robots in the newest frame. */
  count = 0;
  /** The records: uint32 id, float32 x, float32 y, uint16 heading, uint8 flags, uint8 0. */
  bytes = new Uint8Array(0);
  /** The same bytes, four words a record. There is room for whole multiples of kRecordBlock records. */
  words = new Uint32Array(0);
  private floats = new Float32Array(0);
  private halves = new Uint16Array(0);
  private rowById = new Int32Array(64);

  /** Takes over a frame's records. A rest that is no whole record is left out. */
  accept(records: Uint8Array): void {
    const count = Math.floor(records.length / kRecordBytes);
    if (count * kRecordBytes > this.bytes.length) this.grow(count);
    this.bytes.set(records.subarray(0, count * kRecordBytes));
    this.count = count;
    for (let row = 0; row < count; ++row) {
      const id = this.words[row * kWords]!;
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
  }

  id(row: number): number {
    return this.words[row * kWords]!;
  }
  /** [m, world] */
  x(row: number): number {
    return this.floats[row * kWords + 1]!;
  }
  /** [m, world] */
  y(row: number): number {
    return this.floats[row * kWords + 2]!;
  }
  /** [rad, counter-clockwise from east], 0 .. 2 pi */
  heading(row: number): number {
    return this.halves[row * kWords * 2 + 6]! * kTurn;
  }
  /** Life in bits 0 to 2, then those of Flag. */
  flags(row: number): number {
    return this.bytes[row * kRecordBytes + 14]!;
  }
  life(row: number): number {
    return this.flags(row) & 7;
  }

  /** The robot's row in this frame; -1 where it isn't in it. */
  rowOf(id: number): number {
    const row = this.rowById[id];
    return row !== undefined && row < this.count && this.words[row * kWords] === id ? row : -1;
  }

  private grow(count: number): void {
    const wanted = Math.max(count, this.count * 2);
    const buffer = new ArrayBuffer(Math.ceil(wanted / kRecordBlock) * kRecordBlock * kRecordBytes);
    this.bytes = new Uint8Array(buffer);
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    this.halves = new Uint16Array(buffer);
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
