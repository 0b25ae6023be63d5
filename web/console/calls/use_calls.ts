import { useEffect, useMemo, useRef } from "react";
import type { Questions_Question } from "../../core/protocol.ts";
import { readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { openAlerts } from "../log/alerts.ts";
import { useIsElsewhen, usePart, useUi } from "../session/session.ts";
import { type Call, Calls } from "./calls.ts";

// Dismissed or not: what was told is told.
const kNoQuestions: readonly Questions_Question[] = [];
const kNone: ReadonlySet<bigint> = new Set();

/** Tells questions, alerts and a server that falls silent outside of the page, while that is switched on. */
export function useCalls(): void {
  // What the page is told when it opens has come before the people who look at it.
  const isKnown = usePart("clients") !== null;
  const isOn = useUi("calls") && isKnown;
  const shown = usePart("questions");
  // Those of another moment have been answered, or not been asked yet.
  const questions = useIsElsewhen() ? kNoQuestions : shown;
  const log = usePart("log");
  const after = usePart("alertsAfter");
  const link = usePart("link");
  const isLost = link.silentSince !== 0 || link.state === "lost";
  const calls = useRef<Calls | null>(null);
  const now = useMemo<Call[]>(
    () => [
      ...questions.map(({ id, text, unit }) => ({
        tag: `question ${id} ${text}`,
        title: unit ? `Question of ${unit}` : "Question",
        text: readableMessage(text),
      })),
      ...openAlerts(log, after, kNone).map(({ number, text }) => ({
        tag: `alert ${number}`,
        title: "Alert",
        text: sentence(text),
      })),
      ...(isLost ? [{ tag: "silence", title: "No answer", text: "The server does not answer." }] : []),
    ],
    [questions, log, after, isLost],
  );
  useEffect(() => {
    if (!isOn) {
      calls.current = null;
    } else if (calls.current) {
      calls.current.see(now);
    } else {
      calls.current = new Calls();
      calls.current.know(now);
    }
  }, [isOn, now]);
}
