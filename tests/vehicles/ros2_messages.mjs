// Reads messages of ROS 2 and writes them again, by an implementation that is not ours and with ROS's own definitions.
//
//   node ros2_messages.mjs FOLDER
//
// FOLDER has node_modules in it. Each line of its standard input is the name of a type and a message's bytes in hexadecimal; it is
// answered by a line of JSON: the message, and the bytes that it is written as.
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(`${process.argv[2]}/`);
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { ros2jazzy } = require("@foxglove/rosmsg-msgs-common");

// The type's own definition first, then those of all that it is made of.
function definitions(type, found = new Map()) {
  if (found.has(type)) return found;
  found.set(type, ros2jazzy[type]);
  for (const member of ros2jazzy[type].definitions) if (member.isComplex) definitions(member.type, found);
  return found;
}

for await (const line of createInterface({ input: process.stdin })) {
  const [type, hex] = line.split(" ");
  const all = [...definitions(type).values()];
  const message = new MessageReader(all).readMessage(Buffer.from(hex, "hex"));
  const bytes = new MessageWriter(all).writeMessage(message);
  const plain = (_key, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value);
  console.log(JSON.stringify({ message, bytes: Buffer.from(bytes).toString("hex") }, plain));
}
