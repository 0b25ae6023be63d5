// What comes onto the page: components, wires, groups, comments.

import { groupMembers } from "../palette/societies.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { Drawing_Kind } from "../session/protocol.ts";
import type { Blocks } from "./blocks.ts";
import { addNote, frameSelection, selectionByKind, ungroup } from "./editing.ts";

export function placeActions(designer: Designer, blocks: Blocks): Action[] {
  return [...componentActions(designer, blocks), ...groupActions(designer, blocks), ...noteActions(designer, blocks)];
}

function componentActions(designer: Designer, { fixed, noPlace, notOneNode }: Blocks): Action[] {
  const { store, drawing } = designer;
  const first = selectionByKind(designer).nodes[0] ?? "";
  return [
    {
      id: "place",
      label: "Place a component",
      group: "Place",
      icon: "search",
      shortcut: "/",
      also: ["space"],
      blocked: noPlace,
      run: () => store.setState({ dialog: "place", placing: null }),
    },
    {
      id: "connect",
      label: drawing?.kind === Drawing_Kind.STATES ? "Add a transition" : "Connect",
      group: "Place",
      icon: "draw",
      shortcut: "c",
      blocked: fixed ?? notOneNode,
      run: () => store.setState({ dialog: "connect", subject: first }),
    },
    {
      id: "replace",
      label: "Replace",
      group: "Place",
      blocked: noPlace ?? notOneNode,
      run: () => store.setState({ dialog: "place", placing: { x: 0, y: 0, replace: first } }),
    },
  ];
}

function groupActions(designer: Designer, { fixed, noNode, notOneNode }: Blocks): Action[] {
  const { store, document, drawing } = designer;
  const first = selectionByKind(designer).nodes[0] ?? "";
  const isFlow = drawing?.kind === Drawing_Kind.DATAFLOW || drawing?.kind === Drawing_Kind.ROBOT;
  const isSociety = drawing?.kind === Drawing_Kind.SOCIETY;
  return [
    {
      id: "group",
      label: isSociety ? "Make a caste of the selection" : "Make an assemblage of the selection",
      group: "Place",
      icon: "layers",
      shortcut: "ctrl+g",
      blocked: fixed ?? noNode ?? (isFlow || isSociety ? undefined : "Only dataflow and members can be grouped"),
      run: () => {
        if (isSociety) void groupMembers(designer, drawing, selectionByKind(designer).nodes);
        else store.setState({ dialog: "group", subject: "" });
      },
    },
    {
      id: "ungroup",
      label: "Ungroup",
      group: "Place",
      shortcut: "ctrl+shift+g",
      blocked: fixed ?? notOneNode,
      run: () => void ungroup(designer, first),
    },
    {
      id: "own-copy",
      label: "Make my own copy",
      group: "Place",
      blocked: document?.isReadOnly ? "Save the file as your own first" : notOneNode,
      run: () => void ownCopy(designer, first),
    },
  ];
}

function noteActions(designer: Designer, { fixed }: Blocks): Action[] {
  return [
    {
      id: "comment",
      label: "Add a comment",
      group: "Place",
      icon: "text",
      shortcut: "shift+c",
      blocked: fixed,
      run: () => void addNote(designer),
    },
    {
      id: "frame",
      label: "Frame the selection",
      group: "Place",
      shortcut: "shift+f",
      blocked: fixed,
      run: () => frameSelection(designer),
    },
  ];
}

export async function ownCopy(designer: Designer, name: string): Promise<void> {
  const component = designer.drawing?.nodes.find((node) => node.name === name)?.component ?? "";
  const answer = await designer.edit(`own copy of ${component}`, {
    case: "copyComponent",
    value: { component, name: "" },
  });
  if (answer.ok) designer.say(`${component} is a part of this file now, and can be changed`);
}
