// Finding on the page: as one types, what has it is marked; Enter goes from one to the next.
import { useReactFlow } from "@xyflow/react";
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

function Bar({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const flow = useReactFlow();
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(-1);
  const field = useRef<HTMLInputElement>(null);
  const found = findOnPage(drawing, query);
  const key = found.join("\n");
  useEffect(() => {
    canvasStore.setState({ found: key === "" ? kNothing : new Set(key.split("\n")) });
  }, [key]);
  useEffect(() => {
    field.current?.focus();
    return () => canvasStore.setState({ found: kNothing });
  }, []);
  const close = () => {
    designer.store.setState({ isFinding: false });
    offerFocus(nodeElement(designer.state.selection[0] ?? "") ?? document.querySelector<HTMLElement>(".canvas"));
  };
  const go = (step: 1 | -1) => {
    if (found.length === 0) return;
    const next = at < 0 ? (step > 0 ? 0 : found.length - 1) : (at + step + found.length) % found.length;
    setAt(next);
    const id = found[next]!;
    designer.select([id]);
    // Of a transition the state that it leaves.
    const shown = flow.getNode(id) ? id : (id.split("/")[0] ?? "");
    const zoom = flow.getZoom();
    void flow.fitView({
      nodes: [{ id: shown }],
      minZoom: Math.max(zoom, 0.5),
      maxZoom: Math.max(zoom, 0.5),
      duration: 150,
    });
  };
  const keys = (event: KeyboardEvent) => {
    const steps: Record<string, () => void> = {
      Enter: () => go(event.shiftKey ? -1 : 1),
      ArrowDown: () => go(1),
      ArrowUp: () => go(-1),
      Escape: close,
    };
    const act = steps[event.key];
    const isAgain = event.key.toLowerCase() === "f" && (event.ctrlKey || event.metaKey);
    if (!act && !isAgain) return;
    event.preventDefault();
    event.stopPropagation();
    if (act) act();
    else field.current?.select();
  };
  return (
    <search className="find-bar" aria-label="Find on this page">
      <Icon name="search" />
      <input
        ref={field}
        aria-label="Find on this page"
        placeholder="Find on this page"
        value={query}
        onChange={(event) => {
          setQuery(event.target.value);
          setAt(-1);
        }}
        onKeyDown={keys}
      />
      <span className="small muted" role="status">
        {query.trim() === ""
          ? ""
          : found.length === 0
            ? "nothing"
            : at < 0
              ? found.length
              : `${at + 1} of ${found.length}`}
      </span>
      <IconButton icon="up" label="The one before" isDisabled={found.length === 0} onPress={() => go(-1)} />
      <IconButton icon="down" label="The next one" isDisabled={found.length === 0} onPress={() => go(1)} />
      <IconButton icon="close" label="End finding" onPress={close} />
    </search>
  );
}
