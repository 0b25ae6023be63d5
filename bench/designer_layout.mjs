// How long automatic layout takes, for pages of several shapes and sizes, by each method: where the limits of
// web/designer/arrange/effort.ts come from. `node bench/designer_layout.mjs`
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { createServer } from "../web/node_modules/vite/dist/node/index.js";

const web = join(dirname(dirname(fileURLToPath(import.meta.url))), "web");
const kLongest = { dataflow: 2000, states: 400 }; // effort beyond which "careful" takes minutes
const seed = 1;

/** The same numbers in 0 .. 1 every time. */
function randomFrom(start) {
  let value = start;
  return () => {
    value = (value * 16807) % 2147483647;
    return value / 2147483647;
  };
}

/** Wires by the number of nodes. */
const kShapes = {
  "dataflow, a tree": (n) => Array.from({ length: n - 1 }, (_, i) => [i + 1, Math.floor(i / 4)]),
  "dataflow, much shared": (n) => {
    const random = randomFrom(seed);
    const after = (i, most) => i + 1 + Math.floor(random() * Math.min(most, n - 1 - i));
    return Array.from({ length: n - 1 }, (_, i) => [
      [i, after(i, 20)],
      [i, after(i, n)],
    ]).flat();
  },
  "states, each third back to the start": (n) =>
    Array.from({ length: n }, (_, i) =>
      i % 3 === 0 && i > 0
        ? [
            [i, (i + 1) % n],
            [i, 0],
          ]
        : [[i, (i + 1) % n]],
    ).flat(),
  "states, there and back": (n) =>
    Array.from({ length: n - 1 }, (_, i) => [
      [i, i + 1],
      [i + 1, i],
    ]).flat(),
};

function graphOf(shape, count) {
  const kind = shape.startsWith("states") ? "states" : "dataflow";
  const box = kind === "states" ? { width: 128, height: 64, outputY: -1 } : { width: 180, height: 80, outputY: 20 };
  const pairs = kShapes[shape](count).filter(([from, to]) => from !== to);
  const inputs = Array.from({ length: count }, () => []);
  const wires = pairs.map(([from, to]) => {
    const port = `in${inputs[to].length}`;
    inputs[to].push({ id: port, y: 30 + inputs[to].length });
    return { from: `${from}`, to: `${to}`, port, ...(kind === "states" ? { label: { width: 120, height: 24 } } : {}) };
  });
  const nodes = Array.from({ length: count }, (_, i) => ({ id: `${i}`, ...box, inputs: inputs[i], isFirst: i === 0 }));
  return { kind, nodes, wires };
}

const server = await createServer({
  root: web,
  logLevel: "error",
  server: { middlewareMode: true },
  appType: "custom",
});
try {
  const { effortOf, methodFor } = await server.ssrLoadModule("/designer/arrange/effort.ts");
  const { toElk } = await server.ssrLoadModule("/designer/arrange/elk.ts");
  const { snakeSpots } = await server.ssrLoadModule("/designer/arrange/grid.ts");
  const { columnSpots } = await server.ssrLoadModule("/designer/arrange/columns.ts");
  const { default: Elk } = await import("../web/node_modules/elkjs/lib/elk.bundled.js");
  const elk = new Elk();
  const timeOf = async (act) => {
    const begin = performance.now();
    await act();
    return `${(performance.now() - begin).toFixed(0)} ms`.padStart(9);
  };
  for (let i = 0; i < 3; ++i) await elk.layout(toElk(graphOf("dataflow, much shared", 40))); // warm
  console.log(`seed ${seed}\n${"page".padEnd(44)}effort   careful     quick      ours  taken`);
  for (const shape of Object.keys(kShapes)) {
    for (const count of [20, 40, 80, 160]) {
      const graph = graphOf(shape, count);
      const effort = effortOf(graph);
      const isTried = effort <= kLongest[graph.kind];
      const careful = isTried ? await timeOf(() => elk.layout(toElk(graph, "careful"))) : "-".padStart(9);
      const quick = await timeOf(() => elk.layout(toElk(graph, "quick")));
      const ours = await timeOf(() => (graph.kind === "states" ? snakeSpots(graph) : columnSpots(graph)));
      console.log(
        `${`${shape}: ${count}`.padEnd(44)}${`${effort}`.padStart(6)} ${careful} ${quick} ${ours}  ${methodFor(graph)}`,
      );
    }
  }
} finally {
  await server.close();
}
