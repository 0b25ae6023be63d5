// One line of MDL: completed and checked as it is typed, sent with Enter.
import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import type { Completions_Item } from "../../core/protocol.ts";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart, useWhyNoOrder } from "../session/session.ts";
import { DiagnosticsView, TargetsView } from "./targets_view.tsx";
import { type Suggestions, type TypedLine, useTypedLine, type Verdict } from "./use_typed_line.ts";
import "./command.css";

export function CommandLine() {
  const why = useWhyNoOrder("send them");
  const isConnected = usePart("link").state === "open";
  const input = useRef<HTMLInputElement>(null);
  const typed = useTypedLine(input);
  const { line, suggestions, at, verdict } = typed;
  const [isFocused, setFocused] = useState(false);
  const isOpen = isFocused && (suggestions !== null || verdict !== null);
  return (
    <div className="command-line">
      <Icon name="command" />
      <input
        ref={input}
        id="command-line"
        role="combobox"
        aria-label="Command line"
        aria-expanded={isOpen && suggestions !== null}
        aria-controls="command-suggestions"
        aria-autocomplete="list"
        aria-activedescendant={at >= 0 ? `command-suggestion-${at}` : undefined}
        autoComplete="off"
        spellCheck={false}
        disabled={!isConnected}
        placeholder={
          !isConnected
            ? "No connection"
            : why === undefined
              ? "Type a command: UNIT scouts MOVETO 310 205"
              : `Commands are checked here. ${why}`
        }
        value={line}
        onChange={({ target }) => typed.type(target.value, target.selectionStart ?? target.value.length)}
        onKeyDown={(event) => press(typed, event)}
        onFocus={({ target }) => {
          setFocused(true);
          typed.inspect(target.selectionStart ?? line.length);
        }}
        onBlur={() => setFocused(false)}
      />
      <kbd>/</kbd>
      {isOpen && (
        <div className="command-pop">
          {suggestions && <SuggestionList suggestions={suggestions} at={at} onChoose={typed.accept} />}
          {verdict && <VerdictView verdict={verdict} />}
        </div>
      )}
    </div>
  );
}

function press(typed: TypedLine, event: KeyboardEvent<HTMLInputElement>): void {
  const { line, suggestions, at } = typed;
  const items = suggestions?.items ?? [];
  const chosen = at >= 0 ? items[at] : undefined;
  const act = {
    Enter: () => (chosen ? typed.accept(chosen) : void typed.send()),
    Tab: () => {
      const item = items[at] ?? items[0];
      if (event.shiftKey || line === "" || !item) return false;
      typed.accept(item);
    },
    ArrowUp: () => move(typed, -1, event.altKey),
    ArrowDown: () => move(typed, 1, event.altKey),
    Escape: () => leave(typed, event.currentTarget),
    " ": () => event.ctrlKey && typed.inspect(event.currentTarget.selectionStart ?? line.length),
  }[event.key];
  if (act && act() !== false) event.preventDefault();
}

/** Through the suggestions, or the lines that were sent before. */
function move(typed: TypedLine, direction: -1 | 1, isAlt: boolean): void {
  const { line, at, suggestions } = typed;
  const isBrowsing = line === "" || typed.isRecalled() || isAlt;
  if (isBrowsing && at < 0 && !(line === "" && direction > 0)) typed.browse(direction);
  else typed.mark(Math.max(-1, Math.min((suggestions?.items.length ?? 0) - 1, at + direction)));
}

/** Away with what is shown, then with what is typed, then out of the line. */
function leave({ suggestions, verdict, line, forget, change }: TypedLine, input: HTMLInputElement): void {
  if (suggestions || verdict) forget();
  else if (line !== "") change("");
  else input.blur();
}

function SuggestionList({
  suggestions,
  at,
  onChoose,
}: {
  suggestions: Suggestions;
  at: number;
  onChoose: (item: Completions_Item) => void;
}) {
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    list.current?.children[at]?.scrollIntoView({ block: "nearest" });
  }, [at]);
  return (
    <div
      ref={list}
      id="command-suggestions"
      role="listbox"
      aria-label="Completions"
      className="command-suggestions"
      tabIndex={-1}
    >
      {suggestions.items.map((item, i) => (
        <div
          key={`${item.kind} ${item.text}`}
          id={`command-suggestion-${i}`}
          role="option"
          tabIndex={-1}
          aria-selected={i === at}
          className="command-suggestion"
          // Before the field loses the focus.
          onMouseDown={(event) => {
            event.preventDefault();
            onChoose(item);
          }}
        >
          <span className="mono">{item.text}</span>
          <span className="small muted ellipsis grow">{item.help}</span>
          <span className="small muted">{item.kind}</span>
        </div>
      ))}
    </div>
  );
}

function VerdictView({ verdict }: { verdict: Verdict }) {
  const isBad = verdict.error !== "" || verdict.diagnostics.some((diagnostic) => !diagnostic.isWarning);
  return (
    <div className="command-verdict" role="status">
      <h3>{verdict.isSent ? "Sent to" : isBad ? "Can't be sent yet" : "Enter sends this to"}</h3>
      {verdict.targets && !isBad && <TargetsView targets={verdict.targets} />}
      {verdict.diagnostics.length > 0 && <DiagnosticsView line={verdict.line} diagnostics={verdict.diagnostics} />}
      {verdict.error !== "" && verdict.diagnostics.length === 0 && <p className="problem">{sentence(verdict.error)}</p>}
    </div>
  );
}
