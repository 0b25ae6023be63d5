// Where something is in a robot's program, as a person would say it.

/** Parts of a path that only say how the program is put together, unless they come last. */
const kScaffold = new Set(["value", "output", "active", "members"]);

/**
 * `movement.Searching.value.spread` is "Searching: spread", `movement.Searching` is "Searching". The actuator that a robot
 * drives leads the path; it is only named where it is all there is, or where it is not the movement.
 */
export function spokenPath(path: string): string {
  const parts = path.split(".").map((part) => part.replace(/\[\d+\]$/, ""));
  if (parts.length < 2) return path;
  const kept = parts.filter(
    (part, i) => part !== "" && !(i === 0 && part === "movement") && !(i < parts.length - 1 && kScaffold.has(part)),
  );
  if (kept.length > 1 && kept.at(-1) === "output") kept.pop();
  const last = kept.pop() ?? path;
  return kept.length === 0 ? last : `${kept.join(", ")}: ${last}`;
}

/** What it is, without the way there: "spread". */
export function spokenEnd(path: string): string {
  return spokenPath(path).split(": ").at(-1)!;
}
