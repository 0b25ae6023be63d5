// A recording as another version of the program may write it: of a format that this one does not compute again.
import { writeFileSync } from "node:fs";

const u16 = (value: number) => Buffer.from([value & 0xff, value >> 8]);
const u32 = (value: number) => {
  const out = Buffer.alloc(4);
  out.writeUInt32LE(value);
  return out;
};
const u64 = (value: bigint) => {
  const out = Buffer.alloc(8);
  out.writeBigUInt64LE(value);
  return out;
};
const text = (value: string) => Buffer.concat([u32(Buffer.byteLength(value)), Buffer.from(value)]);

/** A record of an MCAP file. */
const record = (opcode: number, ...content: Buffer[]) => {
  const body = Buffer.concat(content);
  return Buffer.concat([Buffer.from([opcode]), u64(BigInt(body.length)), body]);
};

function varint(value: number): Buffer {
  const bytes: number[] = [];
  for (let rest = value; ; rest = Math.floor(rest / 128)) {
    if (rest < 128) return Buffer.from([...bytes, rest]);
    bytes.push((rest % 128) + 128);
  }
}
const tag = (field: number, wire: number) => varint(field * 8 + wire);

/** Fields of a message of proto/mlab/history.proto. */
const whole = (field: number, value: number) => Buffer.concat([tag(field, 0), varint(value)]);
const bytes = (field: number, value: Buffer | string) =>
  Buffer.concat([tag(field, 2), varint(Buffer.byteLength(value)), Buffer.from(value as string)]);
const double = (field: number, value: number) => {
  const out = Buffer.alloc(8);
  out.writeDoubleLE(value);
  return Buffer.concat([tag(field, 1), out]);
};
const floats = (field: number, values: number[]) => {
  const out = Buffer.alloc(4 * values.length);
  values.forEach((value, i) => {
    out.writeFloatLE(value, 4 * i);
  });
  return bytes(field, out);
};

interface Kind {
  topic: string;
  field: number;
}
const kText: Kind = { topic: "/mlab/text", field: 3 };
const kBeginning: Kind = { topic: "/mlab/beginning", field: 4 };
const kPoses: Kind = { topic: "/mlab/poses", field: 7 };
const kEvent: Kind = { topic: "/mlab/event", field: 8 };
const kEnd: Kind = { topic: "/mlab/end", field: 9 };
const kKinds = [kText, kBeginning, kPoses, kEvent, kEnd];

/** Two robots go east for a minute, one metre a second. */
export function writeOtherVersion(file: string, texts: readonly { path: string; content: string }[]): void {
  const records: Buffer[] = [record(0x01, text(""), text("another version"))];
  kKinds.forEach(({ topic }, i) => {
    records.push(record(0x04, u16(i + 1), u16(0), text(topic), text("protobuf"), u32(0)));
  });
  let sequence = 0;
  const put = (kind: Kind, cycle: number, ...body: Buffer[]) => {
    const entry = Buffer.concat([whole(1, cycle), double(2, cycle / 10), bytes(kind.field, Buffer.concat(body))]);
    const time = u64(BigInt(cycle) * 100_000_000n);
    records.push(record(0x05, u16(kKinds.indexOf(kind) + 1), u32(++sequence), time, time, entry));
  };
  texts.forEach(({ path, content }, i) => {
    put(kText, 0, whole(1, i + 1), bytes(2, path), bytes(3, content));
  });
  const mission = Buffer.concat([bytes(1, texts[0]?.path ?? ""), ...texts.map((_, i) => bytes(4, varint(i + 1)))]);
  put(kBeginning, 0, whole(1, 2), bytes(2, "9.0.0"), bytes(5, mission));
  for (let second = 0; second <= 60; ++second) {
    if (second === 20) put(kEvent, 200, bytes(1, "robot 2 found something"));
    const x = 100 + second;
    put(
      kPoses,
      10 * second,
      bytes(1, Buffer.from([1, 2])),
      floats(2, [x, x]),
      floats(3, [100, 140]),
      floats(4, [0, 0]),
    );
  }
  put(kEnd, 600, bytes(1, "done"));
  const magic = Buffer.from([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a]);
  const end = [record(0x0f, u32(0)), record(0x02, u64(0n), u64(0n), u32(0))];
  writeFileSync(file, Buffer.concat([magic, ...records, ...end, magic]));
}
