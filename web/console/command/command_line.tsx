// One line of MDL: completed and checked as it is typed, sent with Enter.
import { type KeyboardEvent, useCallback, useEffect, useRef, useState } from "react";
import { Complete_Language, type Completions_Item, type Diagnostic, type Targets } from "../../core/protocol.ts";
import { Icon } from "../../ui/controls/icons.tsx";
import { bytesOf, unitsOf } from "../../ui/text/bytes.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { useIsOperator, usePart, useSession, useUi } from "../session/session.ts";
import { keepHistory, Recall, readHistory, withLine } from "./history.ts";
import { DiagnosticsView, TargetsView } from "./targets_view.tsx";
import "./command.css";

interface Suggestions {
  begin: number; // [code units]
  items: readonly Completions_Item[];
}

interface Verdict {
  line: string;
  targets?: Targets;
  diagnostics: readonly Diagnostic[];
  error: string;
  isSent: boolean;
}

export function CommandLine() {
  const session = useSession();
  const { connection } = session;
  const isOperator = useIsOperator();
  const link = usePart("link");
  const draft = useUi("draft");
  const [line, setLine] = useState("");
  const [suggestions, setSuggestions] = useState<Suggestions | null>(null);
  const [at, setAt] = useState(-1);
  const [verdict, setVerdict] = useState<Verdict | null>(null);
  const [isFocused, setFocused] = useState(false);
  const [history, setHistory] = useState(() => readHistory(window.localStorage));
  const recall = useRef<Recall | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const newest = useRef(0);

  const inspect = useCallback(
    async (text: string, cursor: number) => {
      const mine = ++newest.current;
      await new Promise((resolve) => setTimeout(resolve, 120));
      if (mine !== newest.current) return;
      const [completed, checked] = await Promise.all([
        connection.ask({
          case: "complete",
          value: { language: Complete_Language.IMMEDIATE, text, cursor: bytesOf(text, cursor) },
        }),
        text.trim() === "" ? undefined : connection.ask({ case: "typed", value: { line: text, preview: true } }),
      ]);
      if (mine !== newest.current) return;
      const { result } = completed;
      setSuggestions(
        result.case === "completions" && result.value.items.length > 0
          ? { begin: unitsOf(text, result.value.begin), items: result.value.items }
          : null,
      );
      setAt(-1);
      setVerdict(
        checked
          ? {
              line: text,
              diagnostics: checked.diagnostics,
              error: checked.ok ? "" : checked.error,
              isSent: false,
              ...(checked.result.case === "targets" ? { targets: checked.result.value } : {}),
            }
          : null,
      );
    },
    [connection],
  );

  const change = useCallback(
    (text: string, cursor = text.length) => {
      setLine(text);
      void inspect(text, cursor);
    },
    [inspect],
  );

  useEffect(() => {
    if (!draft) return;
    input.current?.focus();
    change(draft.line);
  }, [draft, change]);

  const accept = (item: Completions_Item) => {
    if (!suggestions) return;
    const cursor = input.current?.selectionStart ?? line.length;
    const rest = line.slice(cursor);
    const before = `${line.slice(0, suggestions.begin)}${item.text}${rest.startsWith(" ") ? "" : " "}`;
    change(before + rest, before.length);
    requestAnimationFrame(() => input.current?.setSelectionRange(before.length, before.length));
  };

  const send = async () => {
    const text = line.trim();
    if (text === "") return;
    ++newest.current;
    const reply = await connection.ask({ case: "typed", value: { line: text, preview: false } });
    if (reply.ok) {
      const lines = withLine(history, text);
      setHistory(lines);
      keepHistory(window.localStorage, lines);
      setLine("");
      setSuggestions(null);
    }
    recall.current = null;
    setVerdict({
      line: text,
      diagnostics: reply.diagnostics,
      error: reply.ok ? "" : reply.error,
      isSent: reply.ok,
      ...(reply.result.case === "targets" ? { targets: reply.result.value } : {}),
    });
  };

  const browse = (direction: -1 | 1) => {
    recall.current ??= new Recall(history, line);
    const found = recall.current.step(direction);
    if (found !== undefined) change(found);
  };

  const keys = (event: KeyboardEvent<HTMLInputElement>) => {
    const items = suggestions?.items ?? [];
    const isBrowsing = line === "" || recall.current !== null || event.altKey;
    if (event.key === "Enter") {
      event.preventDefault();
      if (at >= 0 && items[at]) accept(items[at]);
      else void send();
    } else if (event.key === "Tab" && !event.shiftKey && items.length > 0 && line !== "") {
      event.preventDefault();
      accept((items[at] ?? items[0]) as Completions_Item);
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      const direction = event.key === "ArrowUp" ? -1 : 1;
      if (isBrowsing && at < 0 && !(line === "" && direction > 0)) browse(direction);
      else setAt(Math.max(-1, Math.min(items.length - 1, at + direction)));
    } else if (event.key === "Escape") {
      event.preventDefault();
      if (suggestions || verdict) {
        setSuggestions(null);
        setVerdict(null);
        setAt(-1);
      } else if (line !== "") change("");
      else input.current?.blur();
    } else if (event.key === " " && event.ctrlKey) {
      event.preventDefault();
      void inspect(line, event.currentTarget.selectionStart ?? line.length);
    }
  };

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
        disabled={link.state !== "open"}
        placeholder={
          link.state !== "open"
            ? "No connection"
            : isOperator
              ? "Type a command: UNIT scouts MOVETO 310 205"
              : "Commands are checked here; only the operator can send them"
        }
        value={line}
        onChange={(event) => {
          recall.current = null;
          change(event.target.value, event.target.selectionStart ?? event.target.value.length);
        }}
        onKeyDown={keys}
        onFocus={(event) => {
          setFocused(true);
          void inspect(line, event.target.selectionStart ?? line.length);
        }}
        onBlur={() => setFocused(false)}
      />
      <kbd>/</kbd>
      {isOpen && (
        <div className="command-pop">
          {suggestions && <Suggested suggestions={suggestions} at={at} onChoose={accept} />}
          {verdict && <Judged verdict={verdict} />}
        </div>
      )}
    </div>
  );
}

function Suggested({
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

function Judged({ verdict }: { verdict: Verdict }) {
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
