// The box in which everything is found: what can be done, and whatever else a page has to offer.
import { Icon } from "../controls/icons.tsx";
import { type Choice, Chooser } from "./chooser.tsx";
import type { Command } from "./commands.tsx";
import { shownShortcut } from "./keys.ts";
import { ranked, score } from "./search.ts";

/** A choice with how well it fits, and what it does. */
export interface SearchResult extends Choice {
  points: number;
  run: () => void;
}

const kMostOfAGroup = 12;

interface EverythingProps {
  placeholder: string;
  /** What is found, each group with its best first. */
  groups: (query: string) => readonly (readonly SearchResult[])[];
  onClose: () => void;
  onQuery?: (query: string) => void;
  note?: string;
}

/** The group that has the best comes first. */
export function Everything({ placeholder, groups, onClose, onQuery, note = "" }: EverythingProps) {
  const find = (query: string): SearchResult[] =>
    groups(query)
      .filter((group) => group.length > 0)
      .sort((a, b) => b[0]!.points - a[0]!.points)
      .flat();
  return (
    <Chooser<SearchResult>
      title="Search everything"
      placeholder={placeholder}
      find={find}
      onChoose={(_, choice) => choice.run()}
      onClose={onClose}
      note={note}
      {...(onQuery ? { onQuery } : {})}
    />
  );
}

/** All of them where nothing is typed yet. */
export function commandsFound(query: string, commands: readonly Command[]): SearchResult[] {
  const found = ranked(query, commands, (one) => `${one.label} ${one.group}`).map(
    (one): SearchResult => ({
      id: `command ${one.id}`,
      label: one.label,
      group: "Commands",
      tail: one.group,
      points: score(query, one.label),
      run: one.run,
      ...(one.shortcut ? { keys: shownShortcut(one.shortcut) } : {}),
      ...(one.blocked ? { blocked: one.blocked } : {}),
      ...(one.icon ? { icon: <Icon name={one.icon} /> } : {}),
    }),
  );
  return query.trim() === "" ? found : found.slice(0, kMostOfAGroup);
}

/** Those of a list that the query finds, once something is typed. */
export function resultsIn<T>(
  query: string,
  items: readonly T[],
  textOf: (item: T) => string,
  shown: (item: T) => Omit<SearchResult, "points">,
): SearchResult[] {
  if (query.trim() === "") return [];
  return ranked(query, items, textOf)
    .slice(0, kMostOfAGroup)
    .map((item) => {
      const found = shown(item);
      return { ...found, points: score(query, found.label) };
    });
}
