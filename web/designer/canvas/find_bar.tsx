// Finding on the page: as one types, what has it is marked; Enter goes from one to the next.
import { type ReactFlowInstance, useReactFlow } from "@xyflow/react";
import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import { IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { findOnPage } from "../names/find.ts";
import { offerFocus } from "../session/panes.ts";
import type { Drawing } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { canvasStore } from "../sight/canvas_store.ts";
import { nodeElement } from "../sight/view.ts";

export function FindBar({ drawing }: { drawing: Drawing }) {
  const isShown = usePart((state) => state.isFinding);
  return isShown ? <Bar drawing={drawing} /> : null;
}

const kNothing: ReadonlySet<string> = new Set();

/** What is found as somebody types, and which of it is looked at. */
function useFinding(drawing: Drawing) {
  const designer = useDesigner();
  const flow = useReactFlow();
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(-1);
  const found = findOnPage(drawing, query);
  const key = found.join("\n");
  useEffect(() => {
    canvasStore.setState({ found: key === "" ? kNothing : new Set(key.split("\n")) });
  }, [key]);
  useEffect(() => () => canvasStore.setState({ found: kNothing }), []);
  return {
    query,
    at,
    count: found.length,
    search: (next: string) => {
      setQuery(next);
      setAt(-1);
    },
    go: (step: 1 | -1) => {
      if (found.length === 0) return;
      const next = at < 0 ? (step > 0 ? 0 : found.length - 1) : (at + step + found.length) % found.length;
      setAt(next);
      const id = found[next]!;
      designer.select([id]);
      show(flow, id);
    },
  };
}

/** In the middle, no farther away than it can be read; of a transition the state that it leaves. */
function show(flow: ReactFlowInstance, id: string): void {
  const shown = flow.getNode(id) ? id : (id.split("/")[0] ?? "");
  const zoom = Math.max(flow.getZoom(), 0.5);
  void flow.fitView({ nodes: [{ id: shown }], minZoom: zoom, maxZoom: zoom, duration: 150 });
}

function Bar({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const { query, at, count, search, go } = useFinding(drawing);
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.focus(), []);
  const close = () => {
    designer.store.setState({ isFinding: false });
    offerFocus(nodeElement(designer.state.selection[0] ?? "") ?? document.querySelector<HTMLElement>(".canvas"));
  };
  const keys = (event: KeyboardEvent) => {
    const steps: Record<string, () => void> = {
      Enter: () => go(event.shiftKey ? -1 : 1),
      ArrowDown: () => go(1),
      ArrowUp: () => go(-1),
      Escape: close,
    };
    const isAgain = event.key.toLowerCase() === "f" && (event.ctrlKey || event.metaKey);
    const act = steps[event.key] ?? (isAgain ? () => field.current?.select() : undefined);
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  };
  return (
    <search className="find-bar" aria-label="Find on this page">
      <Icon name="search" />
      <input
        ref={field}
        aria-label="Find on this page"
        placeholder="Find on this page"
        value={query}
        onChange={(event) => search(event.target.value)}
        onKeyDown={keys}
      />
      <span className="small muted" role="status">
        {query.trim() === "" ? "" : foundWords(count, at)}
      </span>
      <IconButton icon="up" label="The one before" isDisabled={count === 0} onPress={() => go(-1)} />
      <IconButton icon="down" label="The next one" isDisabled={count === 0} onPress={() => go(1)} />
      <IconButton icon="close" label="End finding" onPress={close} />
    </search>
  );
}

function foundWords(count: number, at: number): string {
  if (count === 0) return "nothing";
  return at < 0 ? String(count) : `${at + 1} of ${count}`;
}
