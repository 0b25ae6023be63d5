// What running adds to the menus of a node, a wire, a state or a transition.
import { Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import type { Action } from "../actions/action.ts";
import type { Designer } from "../designer.ts";
import { atCondition, atTransition, onPort, onTransition } from "./break_points.ts";
import { knownLive, type Live } from "./live.ts";
import { joined } from "./places.ts";
import { type Target, targetOf } from "./targets.ts";

export function liveMenu(designer: Designer, id: string): Action[] {
  const live = knownLive(designer);
  const { drawing } = designer;
  const target = drawing && targetOf(drawing, id);
  if (!live || !target) return [];
  switch (target.kind) {
    case "transition":
      return [transitionBreak(live, target.from, target.to, id)];
    case "state":
      return [transitionBreak(live, "", target.name, id), transitionBreak(live, target.name, "", id)];
    case "value":
      return valueActions(live, target, id);
  }
}

/** The place in which the page runs; nothing: it does not run. */
function placeOf(live: Live): string | undefined {
  const { place, places } = live.store.getState();
  return places.includes(place) ? place : undefined;
}

function transitionBreak(live: Live, from: string, to: string, id: string): Action {
  const place = placeOf(live);
  const known = onTransition(live.model.get("breakpoints"), place ?? "", from, to);
  const when = from === "" ? `when ${to} begins` : to === "" ? `when ${from} ends` : `${from} → ${to}`;
  return {
    id: `break ${from} ${to}`,
    label: known ? `Remove the breakpoint ${when}` : `Break ${when}`,
    group: "Run",
    icon: known ? "close" : "pause",
    blocked: place === undefined ? "Run it first" : undefined,
    run: () =>
      void (known ? live.removeBreakpoint(known.id) : live.setBreakpoint(atTransition(place ?? "", from, to), id)),
  };
}

function valueActions(live: Live, target: Target & { kind: "value" }, id: string): Action[] {
  const place = placeOf(live);
  const path = place === undefined ? "" : joined(place, target.live);
  const blocked = path === "" ? "Run it first" : undefined;
  const { designer } = live;
  const { document, page } = designer.state;
  const isPinned = live.store.getState().pins.some((pin) => pin.port === path);
  const actions: Action[] = [
    {
      id: "pin",
      label: isPinned ? "Take the probe away" : "Pin a probe",
      group: "Run",
      icon: isPinned ? "close" : "plot",
      blocked,
      run: () => live.togglePin({ port: path, document, page, id }),
    },
  ];
  if (target.type === "bool") {
    const known = onPort(live.model.get("breakpoints"), path).find(
      ({ what }) => what.case === "condition" && what.value.value === "true",
    );
    actions.push({
      id: "break-true",
      label: known ? "Remove the breakpoint" : "Break when it becomes true",
      group: "Run",
      icon: known ? "close" : "pause",
      blocked,
      run: () =>
        void (known
          ? live.removeBreakpoint(known.id)
          : live.setBreakpoint(atCondition(path, Comparison.EQUAL, "true"), id)),
    });
  } else {
    actions.push({
      id: "break-value",
      label: "Break on its value…",
      group: "Run",
      icon: "pause",
      blocked,
      run: () => {
        designer.select([id]);
        designer.show({ details: true });
        // The field stands there once the details are drawn.
        setTimeout(() => breakField()?.focus(), 100);
      },
    });
  }
  if (target.type === "Vector") {
    actions.push({
      id: "field",
      label: "Movement field on the map",
      group: "Run",
      icon: "command",
      blocked: live.model.get("scene") ? undefined : "Run it first",
      run: () => {
        designer.select([id]);
        live.showPane();
        live.store.setState({ showsField: true, field: null, fieldError: "" });
      },
    });
  }
  return actions;
}

function breakField(): HTMLInputElement | null {
  return window.document.querySelector<HTMLInputElement>(".break-when input");
}
