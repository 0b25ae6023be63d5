// Proceed? The oldest on top. Nothing else is blocked while they wait, and none takes the focus by itself.
import { useLayoutEffect, useRef } from "react";
import type { Questions_Question } from "../../core/protocol.ts";
import { Bar, Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { duration, readableMessage } from "../../ui/words/format.ts";
import { commandOfUnit } from "../mission/unit_command.ts";
import { robotPlace, unitPlace } from "../mission/unit_place.ts";
import { answer } from "../session/orders.ts";
import { usePart, useSession, useWhyNoOrder } from "../session/session.ts";
import { countdown } from "./countdown.ts";
import "./questions.css";

export function Questions() {
  const questions = usePart("questions");
  if (questions.length === 0) return null;
  return (
    <section className="questions" aria-label="Questions" aria-live="assertive">
      {questions.map((question, i) => (
        <QuestionCard key={question.id} question={question} isOldest={i === 0} />
      ))}
    </section>
  );
}

function QuestionCard({ question, isOldest }: { question: Questions_Question; isOldest: boolean }) {
  const session = useSession();
  const why = useWhyNoOrder("answer");
  const mayOrder = why === undefined;
  const link = usePart("link");
  const status = usePart("status");
  const isDoing = commandOfUnit(status, question.unit);
  const where = question.robot > 0 ? `Robot ${question.robot}` : question.unit;
  const card = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const element = card.current;
    return () => handFocusOn(element);
  }, []);
  return (
    <section ref={card} className="question" aria-label={readableMessage(question.text)} data-question={question.id}>
      <p className="question-text">{readableMessage(question.text)}</p>
      <div className="question-facts small">
        {where !== "" && (
          <Button
            tone="link"
            aria-label={`Show ${where} on the map`}
            onPress={() =>
              question.robot > 0 ? robotPlace(session, question.robot) : unitPlace(session, [question.unit])
            }
          >
            <Icon name="centre" /> Show
          </Button>
        )}
        <span className="muted">
          {isDoing || question.command}
          {question.asked > 0 ? ` · asked at ${duration(question.asked)}` : ""}
        </span>
      </div>
      <TimeLeft question={question} />
      <div className="question-buttons">
        <Button
          className="go"
          isDisabled={!mayOrder}
          aria-keyshortcuts={isOldest ? "P" : undefined}
          data-proceed=""
          onPress={() => answer(session, question.id, true)}
        >
          PROCEED {isOldest && <kbd>P</kbd>}
        </Button>
        <Button
          className="danger-quiet"
          isDisabled={!mayOrder}
          aria-keyshortcuts={isOldest ? "Shift+P" : undefined}
          onPress={() => answer(session, question.id, false)}
        >
          ABORT {isOldest && <kbd>Shift P</kbd>}
        </Button>
      </div>
      {!mayOrder && (
        <p className="small muted">{link.state === "open" ? why : "Can be answered once the connection is back."}</p>
      )}
    </section>
  );
}

/** Whoever answers by keyboard is not thrown to the top of the page when a card goes away. */
function handFocusOn(card: HTMLElement | null): void {
  if (!card?.contains(document.activeElement)) return;
  const others = [...document.querySelectorAll<HTMLElement>("[data-question] [data-proceed]")];
  const next = others.find((button) => !card.contains(button)) ?? document.querySelector<HTMLElement>(".map");
  next?.focus();
}

function TimeLeft({ question }: { question: Questions_Question }) {
  const time = usePart("time");
  const status = usePart("status");
  const left = countdown(question, Math.max(time, status?.time ?? 0), status);
  if (!left) return null;
  return (
    <div className="rows" style={{ gap: 4 }}>
      <Bar share={left.share} tone="var(--hold)" />
      <span className="small muted number">
        Proceeds by itself in {duration(Math.ceil(left.left))} of mission time
        {Number.isFinite(left.wallLeft) && Math.abs(left.wallLeft - left.left) > 1
          ? ` (${Math.ceil(left.wallLeft)} s here)`
          : ""}
      </span>
    </div>
  );
}
