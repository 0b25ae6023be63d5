// What running adds to the menus of a node, a wire, a state or a transition.

import { atCondition, atTransition } from "../../console/breakpoints/break_points.ts";
import { Breakpoint_Condition_Comparison as Comparison } from "../../core/protocol.ts";
import type { Action } from "../../designer/session/action.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { isOfLibrary } from "../../designer/session/pages.ts";
import type { Drawing, Mark } from "../../designer/session/protocol.ts";
import { transitionOf } from "../../designer/states/flow.ts";
import { isNoTrigger } from "../../designer/states/trigger_words.ts";
import { heldAt, stateOf } from "../run/interventions.ts";
import { knownLive, type Live } from "../run/live.ts";
import { breakAtTransition, breaksWhen, isOnSame, markAt, marksOfPage } from "../run/marks.ts";
import { joined } from "../run/places.ts";
import { showPane } from "../run/run_context.ts";
import { situationOf } from "../run/situation.ts";
import { type Target, targetOf } from "../run/targets.ts";

export function liveMenu(designer: Designer, id: string): Action[] {
  const live = knownLive(designer);
  const { drawing } = designer;
  const target = drawing && targetOf(drawing, id);
  if (!live || !target) return [];
  switch (target.kind) {
    case "transition":
      return [
        transitionBreak(live, target.from, target.to, id),
        ...conditionBreaks(live, drawing, id),
        forceAction(live, target.to, target.from),
      ];
    case "state":
      return [
        transitionBreak(live, "", target.name, id),
        transitionBreak(live, target.name, "", id),
        forceAction(live, target.name),
      ];
    case "value":
      return valueActions(live, drawing, target, id);
  }
}

/** The place in which the page runs; nothing: it does not run. */
function placeOf(live: Live): string | undefined {
  const { place, places } = live.store.getState();
  return places.includes(place) ? place : undefined;
}

/** Why nothing can be marked on the page. */
function blockedBy(live: Live): string | undefined {
  if (placeOf(live) !== undefined) return undefined;
  const { errors, hasSubject } = situationOf(live);
  if (!hasSubject || isOfLibrary(live.designer.state.document)) return "Run it first";
  return errors > 0 ? "It does not compile" : undefined;
}

/** The state in which the selected robot is on the page; empty: not known. */
export function activeState(live: Live): string {
  const place = placeOf(live);
  return place === undefined ? "" : stateOf(live.model.detail(live.follower.robot), place);
}

/** Sends the selected robot to a state; `from`: only out of this one. */
function forceAction(live: Live, to: string, from?: string): Action {
  const sequence = placeOf(live);
  const now = activeState(live);
  const isThere = now === to;
  const known =
    from === undefined ? (isThere ? `Begin ${to} anew now` : `Go to ${to} now`) : `Go from ${from} to ${to} now`;
  const robot = live.model.get("roster").nameOf(live.follower.robot);
  const elsewhere = from !== undefined && now !== from ? `${robot} is in ${now}` : undefined;
  return {
    id: from === undefined ? "force" : "force-transition",
    label: known,
    group: "Run",
    icon: "right",
    blocked: sequence === undefined || now === "" ? "Run it first" : elsewhere,
    run: () => void live.intervening.force(sequence ?? "", to),
  };
}

/** What is marked of the page, where it runs. */
function marksHere(live: Live): Mark[] {
  const { marks, document, page } = live.designer.state;
  return marksOfPage(marks[document] ?? [], page, placeOf(live));
}

/** How many breakpoints there are on a value of the page. */
export function breaksOnValue(live: Live, drawing: Drawing, id: string): number {
  const at = markAt(drawing, id);
  return marksHere(live).filter((mark) => at && mark.breakpoint && isOnSame(mark, at)).length;
}

function transitionBreak(live: Live, from: string, to: string, id: string): Action {
  const known = breakAtTransition(marksHere(live), from, to);
  const when = from === "" ? `when ${to} begins` : to === "" ? `when ${from} ends` : `${from} → ${to}`;
  return breakAction(live, `break ${from} ${to}`, known, {
    set: `Break ${when}`,
    remove: `Remove the breakpoint ${when}`,
    run: () => live.marks.setBreakpoint((place) => atTransition(place, from, to), id),
  });
}

interface BreakWords {
  readonly set: string;
  readonly remove: string;
  readonly run: () => Promise<void>;
}

/** Sets a breakpoint, or takes away the one that is there. */
function breakAction(live: Live, id: string, known: Mark | undefined, { set, remove, run }: BreakWords): Action {
  return {
    id,
    label: known ? remove : set,
    group: "Run",
    icon: known ? "close" : "pause",
    blocked: known ? undefined : blockedBy(live),
    run: () => void (known ? live.marks.removeBreakMark(known) : run()),
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
  const transition = { ...markAt(drawing, id) };
  const conditions = (transitionOf(drawing, id)?.conditions ?? []).filter(({ text }) => !isNoTrigger(text));
  return conditions.map(({ text, live: below, isNegated }) => {
    const value = isNegated ? "false" : "true";
    const known = marksHere(live).find(
      (mark) => isOnSame(mark, { ...transition, trigger: below }) && breaksWhen(mark, value),
    );
    const called = text.length > kLongestLabel ? `${text.slice(0, kLongestLabel - 1)}…` : text;
    const action = breakAction(live, `break-when ${text}`, known, {
      set: `Break when ${called}`,
      remove: `Remove the breakpoint on ${called}`,
      run: () => live.marks.setBreakpoint((one) => atCondition(joined(one, below), Comparison.EQUAL, value), id, below),
    });
    const isThere = place === undefined || ports.has(joined(place, below));
    return isThere ? action : { ...action, blocked: "It has no value of its own" };
  });
}

function valueActions(live: Live, drawing: Drawing, target: Target & { kind: "value" }, id: string): Action[] {
  const blocked = blockedBy(live);
  const { designer } = live;
  const at = markAt(drawing, id);
  const marks = marksHere(live).filter((mark) => at && isOnSame(mark, at));
  const pinned = marks.find(({ breakpoint }) => !breakpoint);
  const actions: Action[] = [
    {
      id: "pin",
      label: pinned ? "Take the probe away" : "Pin a probe",
      group: "Run",
      icon: pinned ? "close" : "plot",
      blocked: pinned ? undefined : blocked,
      run: () => void (pinned ? live.marks.unpin(designer.state.document, pinned.id) : live.marks.pin(id, target.live)),
    },
  ];
  if (target.type === "bool") {
    const known = marks.find((mark) => breaksWhen(mark, "true"));
    actions.push(
      breakAction(live, "break-true", known, {
        set: "Break when it becomes true",
        remove: "Remove the breakpoint",
        run: () =>
          live.marks.setBreakpoint((place) => atCondition(joined(place, target.live), Comparison.EQUAL, "true"), id),
      }),
    );
  } else {
    actions.push({
      id: "break-value",
      label: "Break on its value…",
      group: "Run",
      icon: "pause",
      blocked,
      run: () => typeInDetails(live, id, ".break-when input"),
    });
  }
  const held = holdAction(live, target, id);
  if (held) actions.push(held);
  if (target.type === "Vector") {
    actions.push({
      id: "field",
      label: "Movement field on the map",
      group: "Run",
      icon: "command",
      blocked: live.model.get("scene") ? undefined : "Run it first",
      run: () => {
        designer.select([id]);
        showPane(live.designer);
        live.store.setState({ showsField: true, field: null, fieldError: "" });
      },
    });
  }
  return actions;
}

/** Nothing: it can't be held. */
function holdAction(live: Live, target: Target & { kind: "value" }, id: string): Action | undefined {
  const place = placeOf(live);
  if (place === undefined) return undefined;
  const { robot } = live.follower;
  const path = joined(place, target.live);
  const port = live.model
    .get("roster")
    .portsOf(robot)
    .find((one) => one.path === path);
  if (!port?.canBeHeld) return undefined;
  const isHeld = heldAt(live.model.get("held"), robot, path) !== undefined;
  return {
    id: "hold",
    label: isHeld ? "Release the value" : "Hold at a value…",
    group: "Run",
    icon: isHeld ? "release" : "lock",
    run: () => {
      if (isHeld) void live.intervening.release(robot, path);
      else typeInDetails(live, id, ".hold-value input, .hold-value button");
    },
  };
}

/** Selects the node, and puts the focus into a field of its details. */
function typeInDetails({ designer }: Live, id: string, field: string): void {
  designer.select([id]);
  designer.show({ details: true });
  // It stands there once the details are drawn.
  setTimeout(() => window.document.querySelector<HTMLElement>(field)?.focus(), 100);
}
