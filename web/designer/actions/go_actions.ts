// Going from page to page, and from one part of the window to another.
import { componentOf, drawnAt } from "../names/at.ts";
import { showUses } from "../names/uses.ts";
import type { Action } from "../session/action.ts";
import { crumbsIn } from "../session/crumbs.ts";
import type { Designer } from "../session/designer.ts";
import { innerOf } from "../session/inside.ts";
import { outerPath } from "../session/pages.ts";
import { goToPane } from "../session/panes.ts";
import { kClosed } from "./blocks.ts";

export function goActions(designer: Designer): Action[] {
  const { state, drawing } = designer;
  const to = drawing && innerOf(drawing, state.selection[0] ?? "");
  return [
    {
      id: "enter",
      label: "Look inside",
      group: "Go",
      icon: "right",
      shortcut: "enter",
      blocked: to ? undefined : "Select something that has an inside",
      run: () => designer.navigation.enter(to!),
    },
    ...findActions(designer),
    {
      id: "up",
      label: "Up one level",
      group: "Go",
      icon: "rewind",
      shortcut: "u",
      blocked: state.page === "" || !drawing ? "This is the whole file" : undefined,
      run: () => {
        const before = crumbsIn(designer.state).at(-2);
        designer.navigation.goTo(before?.document ?? state.document, before?.page ?? outerPath(state.page) ?? "");
      },
    },
    {
      id: "file-page",
      label: "The whole file",
      group: "Go",
      shortcut: "home",
      blocked: drawing ? undefined : kClosed,
      run: () => designer.navigation.goTo(state.document, ""),
    },
    {
      id: "next-pane",
      label: "To the next part of the page",
      group: "Go",
      shortcut: "f6",
      everywhere: true,
      run: () => goToPane(1),
    },
    {
      id: "previous-pane",
      label: "To the part before",
      group: "Go",
      shortcut: "shift+f6",
      everywhere: true,
      run: () => goToPane(-1),
    },
    {
      id: "link",
      label: "Copy a link to this place",
      group: "Go",
      blocked: drawing ? undefined : kClosed,
      run: () => void copyLink(designer),
    },
  ];
}

function findActions(designer: Designer): Action[] {
  const { state, drawing } = designer;
  const selected = state.selection[0] ?? "";
  const component = componentOf(drawing, selected);
  return [
    {
      id: "uses",
      label: "Find uses",
      group: "Go",
      icon: "search",
      shortcut: "shift+f12",
      blocked: drawing ? undefined : kClosed,
      run: () => void showUses(designer, drawnAt(designer, selected)),
    },
    {
      id: "component-uses",
      label: component ? `Find uses of ${component}` : "Find uses of the component",
      group: "Go",
      icon: "search",
      blocked: component ? undefined : "Select a node of a component",
      run: () => void showUses(designer, drawnAt(designer, selected, true)),
    },
    {
      id: "find",
      label: "Find on this page",
      group: "Go",
      icon: "search",
      shortcut: "ctrl+f",
      blocked: drawing ? undefined : kClosed,
      run: () => {
        designer.store.setState({ isFinding: true });
        document.querySelector<HTMLInputElement>(".find-bar input")?.select();
      },
    },
  ];
}

async function copyLink(designer: Designer): Promise<void> {
  const { document, page, selection } = designer.state;
  designer.navigation.goTo(document, page, selection[0] ?? "");
  await navigator.clipboard
    .writeText(window.location.href)
    .catch(() => designer.tell("The browser does not let the page write to the clipboard."));
  designer.say("Copied the link");
}
