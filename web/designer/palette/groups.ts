// The palette's components in groups, and found by a few letters.
import { ranked } from "../../ui/commands/search.ts";
import type { Component } from "../session/protocol.ts";
import { canBeDone, isTrigger } from "../states/member.ts";

export interface Group {
  name: string;
  components: Component[];
}

/** What one has made oneself, then what a first skill is made of: motors, eyes, something that puts them together. */
const kOrder = ["This file", "This project", "Motor schemas", "Sensors", "Operators"];
const kLater = ["Assemblages", "Perception", "Triggers", "Logic", "Actuators"];

/** First in their groups: most robots need them, and there are many others. */
const kOften = [
  "Noise",
  "AvoidStaticObstacles",
  "Probe",
  "MoveToGoal",
  "MoveTo",
  "MoveAhead",
  "Stand",
  "sense_obstacles",
];

/** What a beginner wants first comes first; groups that nobody has heard of are between the two. */
export function groupsOf(components: readonly Component[]): Group[] {
  const groups = new Map<string, Component[]>();
  for (const component of components) {
    const name = component.group || "Others";
    groups.set(name, [...(groups.get(name) ?? []), component]);
  }
  return [...groups]
    .map(([name, members]) => ({ name, components: oftenFirst(members) }))
    .sort((a, b) => rankOf(a.name) - rankOf(b.name));
}

function oftenFirst(members: readonly Component[]): Component[] {
  const often = kOften.flatMap((name) => members.filter((one) => one.name === name));
  return [...often, ...members.filter((one) => !often.includes(one))];
}

function rankOf(group: string): number {
  const [early, late] = [kOrder.indexOf(group), kLater.indexOf(group)];
  return early >= 0 ? early : kOrder.length + 1 + late;
}

/** Whether a group is unfolded that nobody has touched: the palette of a dataflow page begins short. */
export function isOpenAtFirst(group: string, isStates: boolean): boolean {
  return isStates || !kLater.includes(group);
}

/** Of those, what is called so; exactly so before all else, then the best first. */
export function matchingComponents(query: string, components: readonly Component[]): Component[] {
  const wanted = query.trim().toLowerCase();
  const isExact = (one: Component) => [one.name, one.title].some((name) => name.toLowerCase() === wanted);
  const names = ranked(query, components, (one) => `${one.title || one.name} ${one.name} ${one.aliases.join(" ")}`);
  if (wanted === "") return names;
  if (names.length > 0) return [...names.filter(isExact), ...names.filter((one) => !isExact(one))];
  return ranked(query, components, (one) => one.help).slice(0, 20);
}

/** What a state can do, or a node of dataflow can be. */
export function isForPage(component: Component, isStates: boolean): boolean {
  return !isStates || canBeDone(component);
}

/** The same, and what can be dropped on a transition. */
export function isInPalette(component: Component, isStates: boolean): boolean {
  return isForPage(component, isStates) || isTrigger(component);
}

/** It gives nothing: a device of a class, or driven by a robot; no other page takes it. */
export function isActuator({ group }: Component): boolean {
  return group === "Actuators";
}

/** The first sentence of a component's documentation. */
export function firstSentence(help: string): string {
  const end = /[.!?](\s|$)/.exec(help);
  return (end ? help.slice(0, end.index + 1) : help).replaceAll(/\s+/g, " ").trim();
}
