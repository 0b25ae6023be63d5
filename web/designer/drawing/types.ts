// Which colour a wire has: by what flows in it.

export type Flow = "movement" | "flag" | "number" | "percept" | "thing" | "text";

const kNumbers = new Set([
  "double",
  "float",
  "int",
  "gain",
  "number",
  "length",
  "speed",
  "angle",
  "duration",
  "turning",
  "count",
  "Number",
  "Integer",
]);
const kThings = /Object|Track|Robot|Door|Room|Sound|Mark/;

export function flowOf(type: string): Flow {
  const plain = type
    .replace(/^(list of |const )/, "")
    .replace(/<.*>$/, "")
    .trim();
  if (plain === "Vector" || plain === "Action" || plain === "Movement") return "movement";
  if (plain === "bool" || plain === "flag" || plain === "Boolean") return "flag";
  if (kNumbers.has(plain)) return "number";
  if (plain === "Text" || plain === "text") return "text";
  return kThings.test(plain) ? "thing" : "percept";
}
