// Lists that frames carry as bytes, little endian: copied once, because a message's bytes aren't aligned.

/** Whole float32 values. */
export function toFloats(bytes: Uint8Array): Float32Array {
  const count = Math.floor(bytes.length / 4);
  const floats = new Float32Array(count);
  new Uint8Array(floats.buffer).set(bytes.subarray(0, count * 4));
  return floats;
}

/** Whole float64 values. */
export function toDoubles(bytes: Uint8Array): Float64Array {
  const count = Math.floor(bytes.length / 8);
  const doubles = new Float64Array(count);
  new Uint8Array(doubles.buffer).set(bytes.subarray(0, count * 8));
  return doubles;
}

/** A point for each of some robots (stations, wanted velocities) or objects: `words` 32-bit words a record, x and y second. */
export class PointTable {
  count = 0;
  private ids = new Uint32Array(0);
  private floats = new Float32Array(0);
  private readonly words: number;

  constructor(words = 3) {
    this.words = words;
  }

  accept(bytes: Uint8Array): void {
    const size = this.words * 4;
    this.count = Math.floor(bytes.length / size);
    if (this.count * this.words > this.ids.length) {
      const buffer = new ArrayBuffer(this.count * size);
      this.ids = new Uint32Array(buffer);
      this.floats = new Float32Array(buffer);
    }
    new Uint8Array(this.ids.buffer).set(bytes.subarray(0, this.count * size));
  }

  id(row: number): number {
    return this.ids[row * this.words]!;
  }
  x(row: number): number {
    return this.floats[row * this.words + 1]!;
  }
  y(row: number): number {
    return this.floats[row * this.words + 2]!;
  }
  /** The fourth word of a record: of an object who carries it, 0 for nobody. */
  last(row: number): number {
    return this.ids[row * this.words + this.words - 1]!;
  }
}
