// Reads what a recording holds for viewers, as they do: decoded by the schemas in the file, and each schema held against the
// one that Foxglove publishes.
//
//   node viewers.mjs FOLDER FILE
//
// FOLDER has node_modules in it. Prints { topics, disagreements, types }: of each topic its schema, how many messages it has,
// the first and the last of them; what of a schema is not as published, and how many types were looked at.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, file] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const { McapIndexedReader } = require("@mcap/core");
const { loadDecompressHandlers, protobufFromBinaryDescriptor } = require("@mcap/support");
const { foxgloveEnumSchemas, foxgloveMessageSchemas, generateProto } = require("@foxglove/schemas/internal");
// Theirs is read by the parser that the readers bring along.
const protobuf = createRequire(require.resolve("@mcap/support"))("protobufjs");

const bytes = new Uint8Array(readFileSync(file));
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => bytes.slice(Number(offset), Number(offset + size)),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers: await loadDecompressHandlers() });

const published = new protobuf.Root();
for (const name of ["google/protobuf/timestamp", "google/protobuf/duration"])
  published.addJSON(protobuf.common.get(`${name}.proto`).nested);
for (const schema of Object.values(foxgloveMessageSchemas)) {
  const enums = Object.values(foxgloveEnumSchemas).filter((one) => one.parentSchemaName === schema.name);
  protobuf.parse(generateProto(schema, enums), published, { keepCase: true });
}
published.resolveAll();

const plain = (field) => `${field.id} ${field.repeated ? "repeated " : ""}${(field.resolvedType?.fullName ?? field.type).replace(/^\./, "")}`;
const snake = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

// Of a type and all that it is made of.
function disagreements(root, name, done) {
  if (done.has(name)) return [];
  done.add(name);
  const ours = root.lookupTypeOrEnum(name);
  const theirs = published.lookupTypeOrEnum(name);
  if (ours.values !== undefined)
    return JSON.stringify(ours.values) === JSON.stringify(theirs.values) ? [] : [`${name}: ${JSON.stringify(ours.values)}`];
  const out = [];
  const fields = new Map(ours.fieldsArray.map((field) => [snake(field.name), field.resolve()]));
  for (const field of theirs.fieldsArray) {
    const own = fields.get(field.name);
    fields.delete(field.name);
    if (own === undefined || plain(own) !== plain(field.resolve()))
      out.push(`${name}.${field.name}: ${own === undefined ? "missing" : plain(own)}, published ${plain(field)}`);
    else if (own.resolvedType !== null)
      out.push(...disagreements(root, own.resolvedType.fullName.replace(/^\./, ""), done));
  }
  return out.concat([...fields.keys()].map((left) => `${name}.${left}: not published`));
}

const topics = {};
const found = [];
const types = new Map();
const done = new Set();
for (const schema of reader.schemasById.values()) {
  const root = protobufFromBinaryDescriptor(schema.data);
  root.resolveAll();
  types.set(schema.id, root.lookupType(schema.name));
  if (schema.name.startsWith("foxglove.")) found.push(...disagreements(root, schema.name, done));
}
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const channel = reader.channelsById.get(message.channelId);
  const schema = reader.schemasById.get(channel.schemaId);
  const decoded = types.get(schema.id).decode(message.data).toJSON();
  topics[channel.topic] ??= { schema: schema.name, encoding: schema.encoding, count: 0, first: decoded };
  topics[channel.topic].count += 1;
  topics[channel.topic].last = decoded;
}
console.log(JSON.stringify({ topics, disagreements: found, types: done.size }));
