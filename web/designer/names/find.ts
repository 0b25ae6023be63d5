// Finding on the page that is shown: what stands there has these letters in its name, its values, its words.
import type { Drawing, Node, Port } from "../session/protocol.ts";

/** What can be found, by its id as in `State.selection`, with all that is written on it. */
interface Written {
  id: string;
  words: readonly string[];
}

function written(drawing: Drawing): Written[] {
  return [
    ...drawing.nodes.map((node) => ({ id: node.name, words: wordsOf(node) })),
    ...drawing.states.map(({ name, title, member, help }) => ({ id: name, words: [name, title, member, help] })),
    ...drawing.transitions.map(({ from, index, trigger }) => ({ id: `${from}/${index}`, words: [trigger] })),
    ...drawing.notes.map(({ id, text }) => ({ id, words: [text] })),
  ];
}

function wordsOf({ name, title, component, help, inputs }: Node): string[] {
  return [name, title, component, help, ...inputs.flatMap(valueWords)];
}

function valueWords({ name, label, value, weight }: Port): string[] {
  return [name, label, value, weight, value === "" ? "" : `${name} = ${value}`, `${label} ${value}`];
}

/** Ids of what has the words in it, whatever the case; those whose name begins so come first. */
export function findOnPage(drawing: Drawing, query: string): string[] {
  const wanted = query.trim().toLowerCase();
  if (wanted === "") return [];
  const found = written(drawing).filter(({ words }) => words.some((one) => one.toLowerCase().includes(wanted)));
  const isByName = ({ id }: Written) => id.toLowerCase().startsWith(wanted);
  return [...found.filter(isByName), ...found.filter((one) => !isByName(one))].map(({ id }) => id);
}
