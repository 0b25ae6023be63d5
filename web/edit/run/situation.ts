// How things stand between the text that is shown and what the simulator holds.
import { Status_Mode } from "../../core/protocol.ts";
import { type LastTrial, type LiveState, setupKey } from "./live_state.ts";
import type { Situation } from "./run_button.ts";
import type { RunContext } from "./run_context.ts";
import { subjectOf } from "./subject.ts";

export function situationOf({ designer, model, store }: RunContext): Situation {
  const state = store.getState();
  const { tried } = state;
  const document = designer.document;
  const isOurs =
    tried !== null &&
    designer.navigation.nowCalled(tried.document) === document?.path &&
    isMission(tried.mission, model.get("documents")?.documents[0]?.path);
  return {
    isConnected: model.get("link").state === "open",
    isRecording: model.isRecording(),
    isElsewhen: model.isElsewhen(),
    isBusy: state.isBusy,
    errors: document?.problems.filter(({ diagnostic }) => !diagnostic?.isWarning).length ?? 0,
    hasSubject: subjectOf(document?.declarations ?? [], state.subject, designer.state.page) !== undefined,
    isOurs,
    isCurrent: isOurs && tried.revision === document?.revision && !isOtherSetup(tried, state),
    isSameSetup: isOurs && !isOtherSetup(tried, state),
    mode: model.get("status")?.mode ?? Status_Mode.NO_MISSION,
  };
}

/** Whether what runs, how many or where was changed since; another page alone is none: it may be only looked at. */
function isOtherSetup(tried: LastTrial, state: LiveState): boolean {
  return tried.setup !== setupKey(state.subject, state);
}

/** Whether the mission that was tried is the one that the simulator holds now. */
function isMission(tried: string, held: string | undefined): boolean {
  return tried === "" || held === tried;
}
