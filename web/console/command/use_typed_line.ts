// The line that is being typed: what could follow, whom it would be sent to, and the lines before it.
import { type Dispatch, type RefObject, type SetStateAction, useCallback, useEffect, useRef, useState } from "react";
import type { Connection } from "../../core/connection.ts";
import {
  Complete_Language,
  type Completions_Item,
  type Diagnostic,
  type Reply,
  type Targets,
} from "../../core/protocol.ts";
import { bytesOf, unitsOf } from "../../ui/text/bytes.ts";
import { useSession, useUi } from "../session/session.ts";
import { keepHistory, Recall, readHistory, withLine } from "./history.ts";

export interface Suggestions {
  begin: number; // [code units]
  items: readonly Completions_Item[];
}

export interface Verdict {
  line: string;
  targets?: Targets;
  diagnostics: readonly Diagnostic[];
  error: string;
  isSent: boolean;
}

export interface TypedLine {
  readonly line: string;
  readonly suggestions: Suggestions | null;
  /** Which of them is marked; -1: none. */
  readonly at: number;
  readonly verdict: Verdict | null;
  /** It is one of those before. */
  isRecalled: () => boolean;
  mark: (at: number) => void;
  /** Another text; `cursor` [code units]: behind it, unless said. */
  change: (text: string, cursor?: number) => void;
  /** As `change`, by typing: the lines before begin anew. */
  type: (text: string, cursor: number) => void;
  inspect: (cursor: number) => void;
  accept: (item: Completions_Item) => void;
  send: () => Promise<void>;
  /** To the line before (-1) or after. */
  browse: (direction: -1 | 1) => void;
  forget: () => void;
}

export function useTypedLine(input: RefObject<HTMLInputElement | null>): TypedLine {
  const { connection } = useSession();
  const [line, setLine] = useState("");
  const { suggestions, at, verdict, inspect, ...inspection } = useInspection(connection);
  const past = useHistory();

  const change = useCallback(
    (text: string, cursor = text.length) => {
      setLine(text);
      void inspect(text, cursor);
    },
    [inspect],
  );
  const draft = useUi("draft");
  useEffect(() => {
    if (!draft) return;
    input.current?.focus();
    change(draft.line);
  }, [draft, change, input]);

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
    inspection.stop();
    const reply = await connection.ask({ case: "typed", value: { line: text, preview: false } });
    if (reply.ok) {
      past.add(text);
      setLine("");
      inspection.setSuggestions(null);
    }
    past.leave();
    inspection.setVerdict(verdictOf(text, reply, reply.ok));
  };
  const browse = (direction: -1 | 1) => {
    const found = past.step(direction, line);
    if (found !== undefined) change(found);
  };
  const type = (text: string, cursor: number) => {
    past.leave();
    change(text, cursor);
  };
  return {
    line,
    suggestions,
    at,
    verdict,
    isRecalled: past.isRecalled,
    mark: inspection.setAt,
    change,
    type,
    inspect: (cursor) => void inspect(line, cursor),
    accept,
    send,
    browse,
    forget: inspection.forget,
  };
}

interface Inspection {
  readonly suggestions: Suggestions | null;
  readonly at: number;
  readonly verdict: Verdict | null;
  setSuggestions: Dispatch<SetStateAction<Suggestions | null>>;
  setAt: Dispatch<SetStateAction<number>>;
  setVerdict: Dispatch<SetStateAction<Verdict | null>>;
  inspect: (text: string, cursor: number) => Promise<void>;
  /** What has been asked is not waited for any more. */
  stop: () => void;
  forget: () => void;
}

/** What the server says of a line, asked once typing pauses. */
function useInspection(connection: Connection): Inspection {
  const [suggestions, setSuggestions] = useState<Suggestions | null>(null);
  const [at, setAt] = useState(-1);
  const [verdict, setVerdict] = useState<Verdict | null>(null);
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
      setSuggestions(suggestionsIn(text, completed));
      setAt(-1);
      setVerdict(checked ? verdictOf(text, checked, false) : null);
    },
    [connection],
  );
  const stop = () => {
    ++newest.current;
  };
  const forget = () => {
    setSuggestions(null);
    setVerdict(null);
    setAt(-1);
  };
  return { suggestions, at, verdict, setSuggestions, setAt, setVerdict, inspect, stop, forget };
}

function suggestionsIn(text: string, { result }: Reply): Suggestions | null {
  if (result.case !== "completions" || result.value.items.length === 0) return null;
  return { begin: unitsOf(text, result.value.begin), items: result.value.items };
}

function verdictOf(line: string, { ok, error, diagnostics, result }: Reply, isSent: boolean): Verdict {
  const targets = result.case === "targets" ? { targets: result.value } : {};
  return { line, diagnostics, error: ok ? "" : error, isSent, ...targets };
}

/** The lines that were sent, kept by the browser. */
function useHistory() {
  const [history, setHistory] = useState(() => readHistory(window.localStorage));
  const recall = useRef<Recall | null>(null);
  return {
    isRecalled: () => recall.current !== null,
    leave: () => {
      recall.current = null;
    },
    step: (direction: -1 | 1, line: string) => {
      recall.current ??= new Recall(history, line);
      return recall.current.step(direction);
    },
    add: (line: string) => {
      const lines = withLine(history, line);
      setHistory(lines);
      keepHistory(window.localStorage, lines);
    },
  };
}
