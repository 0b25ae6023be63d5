// The guided first tour: from an empty canvas to a robot that wanders. Each step says what to do, and knows when it is done
// by what stands in the drawing, however it came there.

import { type Drawing, Drawing_Kind, kResult } from "../session/protocol.ts";
import { drawingOf, type State } from "../session/state.ts";

export interface Step {
  title: string;
  text: string;
  /** What of the page it is about: a selector. */
  at?: string;
  /** What of the drawing it speaks of: components, or the Result. They are brought into sight. */
  nodes?: readonly string[];
  /** Which component of the palette comes next; empty: none. */
  next?: (state: State) => string;
  /** Done; the tour goes on by itself. Without: by a button. */
  isDone?: (state: State) => boolean;
}

const kMotors = ["Noise", "AvoidStaticObstacles", "Probe"];

export const kTourSteps: readonly Step[] = [
  {
    title: "A first skill",
    text: "In a few minutes a robot will wander about in the simulator. Everything here can be undone with Ctrl Z, so try things. The file is empty: add an assemblage, which is a skill, and call it Wander.",
    at: "[aria-label='New in this file']",
    isDone: (state) => state.page !== "" && drawingOf(state)?.kind === Drawing_Kind.DATAFLOW,
  },
  {
    title: "Three motor schemas",
    text: "A motor schema says where the robot wants to go. Drag Noise (a random direction), Avoid static obstacles (away from what is in the way) and Probe (towards free space) from the left onto the canvas. Or press / and type a few letters of the name.",
    at: "[aria-label='Components']",
    next: (state) => missing(state, kMotors),
    isDone: (state) => kMotors.every((name) => has(drawingOf(state), name)),
  },
  {
    title: "An operator",
    text: "Now something that makes one movement out of three: place Cooperate, which is below Operators. It adds up what its members want, each with a weight.",
    at: "[aria-label='Components']",
    next: (state) => missing(state, ["cooperate"]),
    isDone: (state) => has(drawingOf(state), "cooperate"),
  },
  {
    title: "Wires",
    text: "Drag from the round output at the right of Noise to “+ add” of cooperate. While you drag, the inputs that fit light up. Then the same with the other two.",
    at: ".canvas",
    nodes: [...kMotors, "cooperate"],
    isDone: (state) => readersOf(drawingOf(state), kMotors).size >= 3,
  },
  {
    title: "Eyes",
    text: "Avoid static obstacles and Probe have to see obstacles: place Sense obstacles, which is below Sensors, and lead its output to the readings of both.",
    at: ".canvas",
    next: (state) => missing(state, ["sense_obstacles"]),
    isDone: (state) => isFed(drawingOf(state), "AvoidStaticObstacles") && isFed(drawingOf(state), "Probe"),
  },
  {
    title: "The result",
    text: "Lead the output of cooperate to Result: that is what Wander makes a robot do.",
    at: ".canvas",
    nodes: ["cooperate", kResult],
    isDone: (state) => (drawingOf(state)?.resultNode ?? "") !== "",
  },
  {
    title: "Values",
    text: "Click on a value, such as persistence of Noise, to change it: how long the robot keeps a direction. At the top right you see whether anything is wrong.",
    at: "[data-testid='verdict']",
    nodes: ["Noise"],
  },
  {
    title: "Run",
    text: "Press Run: robots start in the simulator beside the canvas and do what you have drawn. Save keeps it as a file that missions can use. That was the tour.",
    at: "[data-tour='run']",
  },
];

function has(drawing: Drawing | undefined, component: string): boolean {
  return drawing?.nodes.some((node) => node.component === component || node.name === component) ?? false;
}

/** The names of the nodes that a step speaks of, as they stand on the page. */
export function nodesOf(step: Step, drawing: Drawing | undefined): string[] {
  const spoken = step.nodes ?? [];
  const named = (drawing?.nodes ?? []).filter(({ component }) => spoken.includes(component)).map(({ name }) => name);
  return spoken.includes(kResult) ? [...named, kResult] : named;
}

/** The first of them that does not stand on the page yet. */
function missing(state: State, components: readonly string[]): string {
  return components.find((name) => !has(drawingOf(state), name)) ?? "";
}

/** Of these components, those that lead somewhere. */
function readersOf(drawing: Drawing | undefined, components: readonly string[]): Set<string> {
  const names = new Map((drawing?.nodes ?? []).map((node) => [node.name, node.component]));
  const led = (drawing?.wires ?? []).map((wire) => names.get(wire.from) ?? "");
  return new Set(led.filter((component) => components.includes(component)));
}

function isFed(drawing: Drawing | undefined, component: string): boolean {
  const node = drawing?.nodes.find((one) => one.component === component || one.name === component);
  return node !== undefined && drawing!.wires.some((wire) => wire.to === node.name && wire.port === "readings");
}
