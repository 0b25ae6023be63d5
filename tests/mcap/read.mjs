// Reads a recording with readers that are not ours: one that goes by the summary and the indexes, and one that takes the
// file as a stream. Both look at every checksum.
//
//   node read.mjs FOLDER FILE
//
// FOLDER has node_modules in it. Prints { header, statistics, indexed, middle, backwards, streamed, attachments,
// metadata, channels }: four lists of messages, those between the statistics' times and all of them; the streamed ones in
// the order of the file. Messages of `protobuf` channels are decoded by the schema in the file.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, file] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const { loadDecompressHandlers, protobufFromBinaryDescriptor } = require("@mcap/support");

const bytes = new Uint8Array(readFileSync(file));
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => bytes.slice(Number(offset), Number(offset + size)),
};
const decompressHandlers = await loadDecompressHandlers();
const text = (data) => Buffer.from(data).toString("utf8");

function dataOf(channel, schema, data) {
  if (channel.messageEncoding !== "protobuf") return text(data);
  const type = protobufFromBinaryDescriptor(schema.data).lookupType(schema.name);
  return JSON.stringify(type.decode(data).toJSON());
}

function told(message, channels, schemas) {
  const channel = channels.get(message.channelId);
  return {
    topic: channel.topic,
    sequence: message.sequence,
    log_time: Number(message.logTime),
    publish_time: Number(message.publishTime),
    data: dataOf(channel, schemas.get(channel.schemaId), message.data),
  };
}

const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
async function indexed(options) {
  const out = [];
  for await (const message of reader.readMessages({ validateCrcs: true, ...options }))
    out.push(told(message, reader.channelsById, reader.schemasById));
  return out;
}

function streamed() {
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  const channels = new Map();
  const schemas = new Map();
  const out = [];
  // In pieces, as from a network.
  for (let at = 0; at < bytes.length; at += 1000) {
    stream.append(bytes.slice(at, at + 1000));
    for (let record = stream.nextRecord(); record !== undefined; record = stream.nextRecord()) {
      if (record.type === "Schema") schemas.set(record.id, record);
      if (record.type === "Channel") channels.set(record.id, record);
      if (record.type === "Message") out.push(told(record, channels, schemas));
    }
  }
  if (!stream.done()) throw new Error("the stream reader waits for more");
  return out;
}

const attachments = [];
for await (const one of reader.readAttachments({ validateCrcs: true }))
  attachments.push({ name: one.name, media_type: one.mediaType, log_time: Number(one.logTime), data: text(one.data) });
const metadata = [];
for await (const one of reader.readMetadata())
  metadata.push({ name: one.name, values: Object.fromEntries(one.metadata) });

const { statistics } = reader;
const { messageStartTime: start, messageEndTime: end } = statistics;
console.log(
  JSON.stringify({
    header: { profile: reader.header.profile, library: reader.header.library },
    statistics: {
      messages: Number(statistics.messageCount),
      chunks: statistics.chunkCount,
      channels: statistics.channelCount,
      schemas: statistics.schemaCount,
    },
    summary_groups: [...reader.summaryOffsetsByOpcode.keys()].sort((a, b) => a - b),
    data_crc: reader.dataSectionCrc ?? 0,
    indexed: await indexed({}),
    middle: await indexed({ startTime: (2n * start + end) / 3n, endTime: (start + 2n * end) / 3n, topics: ["/poses", "/log"] }),
    backwards: await indexed({ reverse: true }),
    streamed: streamed(),
    attachments,
    metadata,
    channels: [...reader.channelsById.values()].map((one) => [one.topic, one.messageEncoding, one.metadata.get("unit") ?? ""]),
  }),
);
