// Writes a recording with a writer that is not ours.
//
//   node write.mjs FOLDER SCRIPT.json FILE
//
// FOLDER has node_modules in it. SCRIPT.json: { messages: [{ topic, sequence, log_time, publish_time, data }], chunk_size,
// is_compressed, use_chunks }; it gets an attachment and metadata, too.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, script, file] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const { McapWriter } = require("@mcap/core");
const zstd = require("@foxglove/wasm-zstd");
await zstd.isLoaded;

const { messages, chunk_size, is_compressed, use_chunks } = JSON.parse(readFileSync(script, "utf8"));
const pieces = [];
let size = 0n;
const writer = new McapWriter({
  writable: {
    position: () => size,
    write: async (bytes) => {
      pieces.push(Buffer.from(bytes));
      size += BigInt(bytes.length);
    },
  },
  useChunks: use_chunks,
  chunkSize: chunk_size,
  compressChunk: is_compressed
    ? (data) => ({ compression: "zstd", compressedData: new Uint8Array(zstd.compress(data)) })
    : undefined,
});
const bytes = (text) => new TextEncoder().encode(text);
await writer.start({ profile: "", library: "somebody else's" });
const schemaId = await writer.registerSchema({ name: "text", encoding: "jsonschema", data: bytes('{"type": "string"}') });
const channels = new Map();
for (const one of messages) {
  if (!channels.has(one.topic))
    channels.set(
      one.topic,
      await writer.registerChannel({ topic: one.topic, schemaId, messageEncoding: "json", metadata: new Map([["unit", "m"]]) }),
    );
  await writer.addMessage({
    channelId: channels.get(one.topic),
    sequence: one.sequence,
    logTime: BigInt(one.log_time),
    publishTime: BigInt(one.publish_time),
    data: bytes(one.data),
  });
}
await writer.addAttachment({ name: "mission.mdl", mediaType: "text/plain", logTime: 5n, createTime: 4n, data: bytes("theirs") });
await writer.addMetadata({ name: "versions", metadata: new Map([["seed", "7"]]) });
await writer.end();
writeFileSync(file, Buffer.concat(pieces));
