// What the main button does when it is pressed.
import { kPreflightPlace } from "../preflight/place.ts";
import { showPanel } from "../session/layout.ts";
import { backToNow, control, takeOperator } from "../session/orders.ts";
import type { Session } from "../session/session.ts";
import { mainButton } from "./main_button.ts";
import { situationOf } from "./situation.ts";

export function pressMainButton(session: Session): void {
  const { does } = mainButton(situationOf(session.model, session.ui.get("isStarting")));
  switch (does.kind) {
    case "control":
      control(session, does.action);
      return;
    case "answer":
      document.querySelector<HTMLElement>("[data-question] [data-proceed]")?.focus();
      return;
    case "take-operator":
      takeOperator(session);
      return;
    case "now":
      backToNow(session);
      return;
    case "preflight":
      session.ui.set("layout", showPanel(session.ui.get("layout"), kPreflightPlace));
      return;
    case "show-errors":
      showErrors(session);
      return;
    case "nothing":
      return;
  }
}

/** Brings the first error of the mission into the text editor. */
export function showErrors(session: Session): void {
  for (const document of session.model.get("documents")?.documents ?? []) {
    const error = document.diagnostics.find((diagnostic) => !diagnostic.isWarning);
    if (!error) continue;
    session.ui.set("reveal", { document: document.path, line: error.line });
    return;
  }
}
