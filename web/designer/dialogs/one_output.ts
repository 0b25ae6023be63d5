// An assemblage gives one value: what of a selection others read, and what has to be chosen as well so that one is left.

interface Reading {
  readonly from: string;
  readonly to: string;
}

/** Of the chosen, those that something else reads, or nothing at all. */
export function outputsOf(chosen: ReadonlySet<string>, wires: readonly Reading[]): string[] {
  return [...chosen].filter((name) => {
    const readers = wires.filter((wire) => wire.from === name).map((wire) => wire.to);
    return readers.length === 0 || readers.some((reader) => !chosen.has(reader));
  });
}

/**
 * The chosen with what they lead to, as little of it as leaves one output; nothing where they never come together.
 *
 * @param nodes  what can be a part of an assemblage: what wires lead to and is none of these is the page's end
 */
export function withOneOutput(
  chosen: readonly string[],
  wires: readonly Reading[],
  nodes: ReadonlySet<string>,
): string[] | undefined {
  const all = new Set(chosen);
  for (;;) {
    const outputs = outputsOf(all, wires);
    if (outputs.length <= 1) return [...all];
    const readers = new Set(
      wires
        .filter((wire) => outputs.includes(wire.from) && nodes.has(wire.to) && !all.has(wire.to))
        .map((wire) => wire.to),
    );
    if (readers.size === 0) return undefined;
    for (const reader of readers) all.add(reader);
  }
}
