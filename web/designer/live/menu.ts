// What running adds to the menus of a node, a wire, a state or a transition.
import { Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import type { Action } from "../actions/action.ts";
import type { Designer } from "../designer.ts";
import type { Drawing } from "../protocol.ts";
import { transitionOf } from "../states/flow.ts";
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
      return [transitionBreak(live, target.from, target.to, id), ...conditionBreaks(live, drawing, id)];
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

const kLongestLabel = 48; // letters of a trigger in a menu

/** On the trigger's value, and on those of the conditions that it is made of. */
function conditionBreaks(live: Live, drawing: Drawing, id: string): Action[] {
  const place = placeOf(live);
  const ports = new Set(
    live.model
      .get("roster")
      .portsOf(live.follower.robot)
      .map(({ path }) => path),
  );
  return (transitionOf(drawing, id)?.conditions ?? []).map(({ text, live: below, isNegated }) => {
    const path = place === undefined ? "" : joined(place, below);
    const value = isNegated ? "false" : "true";
    const known = onPort(live.model.get("breakpoints"), path).find(
      ({ what }) => what.case === "condition" && what.value.value === value,
    );
    const called = text.length > kLongestLabel ? `${text.slice(0, kLongestLabel - 1)}…` : text;
    const noPort = ports.has(path) ? undefined : "It has no value of its own";
    return {
      id: `break-when ${text}`,
      label: known ? `Remove the breakpoint on ${called}` : `Break when ${called}`,
      group: "Run",
      icon: known ? ("close" as const) : ("pause" as const),
      blocked: place === undefined ? "Run it first" : noPort,
      run: () =>
        void (known
          ? live.removeBreakpoint(known.id)
          : live.setBreakpoint(atCondition(path, Comparison.EQUAL, value), id, below)),
    };
  });
}

function valueActions(live: Live, target: Target & { kind: "value" }, id: string): Action[] {
  const place = placeOf(live);
  const path = place === undefined ? "" : joined(place, target.live);
  const blocked = path === "" ? "Run it first" : undefined;
  const { designer } = live;
  const pinned = live.store.getState().pins.find((pin) => pin.port === path);
  const actions: Action[] = [
    {
      id: "pin",
      label: pinned ? "Take the probe away" : "Pin a probe",
      group: "Run",
      icon: pinned ? "close" : "plot",
      blocked,
      run: () => void (pinned ? live.unpin(pinned) : live.pin(id, path)),
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
