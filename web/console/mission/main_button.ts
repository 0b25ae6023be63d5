// The main button: it always says what it will do, and there is always one next thing to do.
import { Control_Action, type Status, Status_Mode, Status_Outcome } from "../../core/protocol.ts";
import { list } from "../../ui/words/format.ts";
import { isGettingReady } from "./state.ts";
import { kStepOfOrder } from "./steps.ts";

export interface MainButton {
  label: string;
  /** Its first words, where there is little room; none: the whole label. */
  short?: string;
  /** One line under it: what that means now. */
  hint: string;
  does:
    | { kind: "control"; action: Control_Action }
    | { kind: "answer" } // goes to the oldest question
    | { kind: "take-operator" }
    | { kind: "now" } // back from another moment
    | { kind: "show-errors" }
    | { kind: "preflight" } // to the checklist, which is to be signed first
    | { kind: "nothing" };
  tone: "go" | "hold" | "danger" | "quiet";
  icon: "checklist" | "play" | "pause" | "question" | "restart" | "hand" | "warning" | "release" | "right";
}

export interface Situation {
  status: Status | undefined;
  isOperator: boolean;
  /** There is one, this browser or another. */
  hasOperator: boolean;
  /** Another moment than now is shown. */
  isElsewhen: boolean;
  isConnected: boolean;
  openQuestions: number;
  errors: number;
  nextLabel: string; // label of the step that Execute would start; empty: none
  /** Why the mission may not move its vehicles yet, as a sentence; empty: it may. */
  whyNotStart: string;
  /** It was told to start, and has not answered yet. */
  isStarting: boolean;
  /** Names of vehicles of which nothing was heard lately. */
  silentVehicles: readonly string[];
  hasVehicles: boolean;
  /** This browser has asked for the operator's place and waits. */
  hasAsked: boolean;
}

const nothing = { kind: "nothing" } as const;

export function mainButton(situation: Situation): MainButton {
  const { status } = situation;
  if (!situation.isConnected || !status) {
    return {
      label: "No connection",
      hint: "The server does not answer.",
      does: nothing,
      tone: "quiet",
      icon: "play",
    };
  }
  if (situation.isElsewhen) {
    return {
      label: "Back to now",
      hint: "You are looking at another moment: nothing is ordered there.",
      does: { kind: "now" },
      tone: "hold",
      icon: "right",
    };
  }
  if (!situation.isOperator && status.mode !== Status_Mode.NO_MISSION) return watching(situation);
  if (isGettingReady(status)) {
    return {
      label: "Getting ready",
      hint: "Programs of robots are made, and machines of a fleet are waited for.",
      does: nothing,
      tone: "quiet",
      icon: "play",
    };
  }
  switch (status.mode) {
    case Status_Mode.NO_MISSION:
      return withoutMission(situation);
    case Status_Mode.READY:
      if (situation.isStarting) return starting(situation);
      return situation.whyNotStart === "" ? execute("Starts with step", situation) : checklist(situation);
    case Status_Mode.RUNNING:
      return control(
        "Pause",
        status.stopsAfterStep ? "It stops by itself after this step." : "All robots stand until you resume.",
        Control_Action.PAUSE,
        "hold",
        "pause",
      );
    case Status_Mode.PAUSED:
      if (!isUnderWay(status)) return execute("Goes on with step", situation);
      return control("Resume", "Goes on where it stands.", Control_Action.RESUME, "go", "play");
    case Status_Mode.WAITING:
      return waiting(status, situation);
    case Status_Mode.STOPPED:
      return {
        ...control("Release the stop", "The run is paused then.", Control_Action.RELEASE_STOP, "danger", "release"),
        short: "Release",
      };
    case Status_Mode.ENDED:
      return control("Restart", endHint(status.outcome), Control_Action.RESTART, "hold", "restart");
  }
}

/** Pressed once more it would not start sooner. */
function starting({ silentVehicles, hasVehicles }: Situation): MainButton {
  const vehicles = silentVehicles.length === 1 ? "the vehicle" : "the vehicles";
  const waited = hasVehicles ? "Looks at the vehicles once more." : "Waits for the server.";
  return {
    label: "Starting",
    hint: silentVehicles.length > 0 ? `Waits for ${vehicles} ${list(silentVehicles)}.` : waited,
    does: nothing,
    tone: "quiet",
    icon: "play",
  };
}

function checklist({ whyNotStart }: Situation): MainButton {
  return {
    label: "Pre-flight checklist",
    short: "Checklist",
    hint: `The mission moves vehicles. Before it starts: ${whyNotStart}`,
    does: { kind: "preflight" },
    tone: "hold",
    icon: "checklist",
  };
}

function withoutMission({ errors }: Situation): MainButton {
  return errors > 0
    ? {
        label: "Show the errors",
        hint: "The mission can't run before they are mended.",
        does: { kind: "show-errors" },
        tone: "hold",
        icon: "warning",
      }
    : { label: "Execute", hint: "Open a mission first.", does: nothing, tone: "quiet", icon: "play" };
}

/** For an answer, or the end of teleoperation. */
function waiting(status: Status, situation: Situation): MainButton {
  const { openQuestions } = situation;
  if (openQuestions > 0) {
    return {
      label: openQuestions === 1 ? "Answer: Proceed?" : `Answer ${openQuestions} questions`,
      short: openQuestions === 1 ? "Answer" : `Answer ${openQuestions}`,
      hint: "The mission waits for you.",
      does: { kind: "answer" },
      tone: "go",
      icon: "question",
    };
  }
  if (status.teleoperations.length === 0) return execute("Goes on with step", situation);
  const units = status.teleoperations.map((teleoperation) => teleoperation.unit).join(", ");
  return control("Pause", `Waits for the end of teleoperation of ${units}.`, Control_Action.PAUSE, "hold", "pause");
}

/** `words`: what comes before the label of the step that is next. */
function execute(words: string, { nextLabel }: Situation): MainButton {
  return control("Execute", stepHint(words, nextLabel), Control_Action.EXECUTE, "go", "play");
}

/** A step, or an order, has been begun and not ended. */
function isUnderWay(status: Status): boolean {
  return status.steps.some((step) => step.outcome === Status_Outcome.UNDER_WAY);
}

/** Of the plan: orders may be under way beside it. */
function isStepUnderWay(status: Status): boolean {
  return status.steps.some((step) => step.step !== kStepOfOrder && step.outcome === Status_Outcome.UNDER_WAY);
}

/** What Step does now. */
export function stepWords(status: Status | null): string {
  return status && isStepUnderWay(status)
    ? "Finishes the step that runs, and stops there"
    : "Carries out the next step, and stops after it";
}

/** What Skip does now. */
export function skipWords(status: Status | null): string {
  return status && isStepUnderWay(status)
    ? "Gives up the step that runs, and starts the next"
    : "Passes over the next step, without starting anything";
}

function watching({ hasAsked, hasOperator }: Situation): MainButton {
  return hasAsked
    ? {
        label: "Asked for control",
        short: "Asked",
        hint: "The operator has to agree.",
        does: nothing,
        tone: "quiet",
        icon: "hand",
      }
    : {
        label: hasOperator ? "Ask for control" : "Take control",
        hint: `You are watching. ${hasOperator ? "Somebody else" : "Nobody"} is the operator.`,
        does: { kind: "take-operator" },
        tone: "hold",
        icon: "hand",
      };
}

function control(
  label: string,
  hint: string,
  action: Control_Action,
  tone: MainButton["tone"],
  icon: MainButton["icon"],
): MainButton {
  return { label, hint, does: { kind: "control", action }, tone, icon };
}

function stepHint(words: string, label: string): string {
  return label === "" ? "" : `${words} ${label}.`;
}

function endHint(outcome: Status_Outcome): string {
  const how =
    outcome === Status_Outcome.DONE
      ? "The mission is done."
      : outcome === Status_Outcome.FAILED
        ? "The mission failed."
        : "The mission has ended.";
  return `${how} Begins anew, with the same seed.`;
}
