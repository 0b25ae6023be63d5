// What may be asked, in groups: what is made to be a trigger first.
import type { Component } from "../session/protocol.ts";
import { isTrigger } from "../states/member.ts";
import { type Group, groupsOf } from "./groups.ts";

const kFirst = ["This file", "This project", "Triggers"];

export function triggerGroups(components: readonly Component[]): Group[] {
  const groups = groupsOf(components.filter(isTrigger));
  const rank = ({ name }: Group) => (kFirst.includes(name) ? kFirst.indexOf(name) : kFirst.length);
  return groups.sort((a, b) => rank(a) - rank(b));
}
