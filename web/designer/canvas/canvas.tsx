// The canvas: what stands on the page that is shown, to be moved, wired and entered.
import {
  Background,
  BackgroundVariant,
  type Edge,
  type Node as FlowNode,
  ReactFlow,
  type ReactFlowProps,
  SelectionMode,
  useReactFlow,
  useStoreApi,
} from "@xyflow/react";
import { type CSSProperties, type ReactNode, type RefObject, useEffect, useMemo, useRef } from "react";
import { kPitch } from "../arrange/elk.ts";
import { pageDifference, withGhosts } from "../compare/compared.ts";
import { dropAt, kDragged } from "../palette/touch_drag.ts";
import type { Designer } from "../session/designer.ts";
import { isTabbed, offerFocus } from "../session/panes.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { canvasStore, useCanvas } from "../sight/canvas_store.ts";
import { usePlaces } from "../sight/use_places.ts";
import { kFarthest, nodeElement } from "../sight/view.ts";
import { isTriggerHere, transitionAt } from "../states/drop_trigger.ts";
import { transitionId } from "../states/flow.ts";
import { NodeView } from "../views/node_view.tsx";
import { NoteView, ResultView } from "../views/small_views.tsx";
import { StateView } from "../views/state_view.tsx";
import { TransitionView } from "../views/transition_view.tsx";
import { ValueEditor } from "../views/value_editor.tsx";
import { WireView } from "../views/wire_view.tsx";
import { useCamera } from "./camera.ts";
import { ConnectReason } from "./connect_reason.tsx";
import { ContextMenu, openMenu } from "./context_menu.tsx";
import { useElements } from "./elements.ts";
import { FarWires } from "./far_wires.tsx";
import { connecting, enter, moveNodes } from "./gestures.ts";
import { useGivenHandles } from "./given_handles.ts";
import { Overview } from "./overview.tsx";

/** How React Flow behaves on every page. */
const kBehaviour = {
  nodeTypes: { node: NodeView, result: ResultView, note: NoteView, state: StateView },
  edgeTypes: { wire: WireView, transition: TransitionView },
  edgesFocusable: false,
  disableKeyboardA11y: true,
  deleteKeyCode: null,
  selectionKeyCode: "Shift",
  multiSelectionKeyCode: ["Shift", "Control", "Meta"],
  panActivationKeyCode: null,
  selectionMode: SelectionMode.Partial,
  panOnDrag: [1, 2],
  selectionOnDrag: true,
  panOnScroll: true,
  zoomOnDoubleClick: false,
  snapToGrid: true,
  snapGrid: [kPitch, kPitch],
  minZoom: kFarthest,
  maxZoom: 2,
  connectionRadius: 26,
  elevateNodesOnSelect: false,
  proOptions: { hideAttribution: true },
} satisfies ReactFlowProps;

const kNoEdges: Edge[] = [];

export function Canvas({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const flow = useReactFlow();
  useGivenHandles(useStoreApi());
  const { kind, isReadOnly } = drawing;
  const isStates = kind === Drawing_Kind.STATES;
  const shown = usePart((state) => state.shown);
  const distance = useCanvas((state) => state.distance);
  const difference = usePart(pageDifference);
  const places = usePlaces(useMemo(() => withGhosts(drawing, difference), [drawing, difference]));
  const isDragging = useRef(false);
  const { nodes, edges, ids, nodesChange, edgesChange } = useElements(drawing, difference, places, isDragging);
  const camera = useCamera(drawing, nodes);
  const showsFarWires = !isStates && distance !== "near" && edges.length > 150;
  const connects = useMemo(() => connecting(designer, drawing, flow), [designer, drawing, flow]);

  const moveBegins = () => {
    isDragging.current = true;
  };
  const moveEnds = (moved: readonly FlowNode[]) => {
    isDragging.current = false;
    const changed = moved.filter((node) => nodes.find((one) => one.id === node.id));
    if (moved.length > 0 && !isReadOnly) moveNodes(designer, drawing, changed, places ?? new Map());
  };
  const showMenu = (event: React.MouseEvent, { id }: { id: string }) => {
    event.preventDefault();
    openMenu(designer, id, event);
  };
  return (
    <Frame drawing={drawing} ids={ids} isInSight={camera.isInSight}>
      <ReactFlow
        {...kBehaviour}
        {...connects}
        nodes={nodes}
        edges={showsFarWires ? kNoEdges : edges}
        onNodesChange={nodesChange}
        onEdgesChange={edgesChange}
        onNodeDragStart={moveBegins}
        onNodeDragStop={(_, __, moved) => moveEnds(moved)}
        onSelectionDragStart={moveBegins}
        onSelectionDragStop={(_, moved) => moveEnds(moved)}
        onNodeContextMenu={showMenu}
        onEdgeContextMenu={showMenu}
        onNodeDoubleClick={(_, node) => {
          // The browser has taken it for a word: what it found to select is in a pane beside the canvas.
          window.getSelection()?.removeAllRanges();
          enter(designer, drawing, node.id);
        }}
        onMove={(event, view) => camera.moved(view, Boolean(event))}
        onInit={(started) => camera.moved(started.getViewport(), false)}
        nodesConnectable={!isReadOnly}
        nodesDraggable={!isReadOnly}
        edgesReconnectable={!isReadOnly && !isStates}
        onlyRenderVisibleElements={nodes.length > 120}
      >
        {shown.grid && <Background variant={BackgroundVariant.Dots} gap={kPitch * 3} size={1.6} />}
        {showsFarWires && <FarWires nodes={nodes} edges={edges} />}
        {shown.minimap && <Overview nodes={nodes} />}
        <ConnectReason />
      </ReactFlow>
    </Frame>
  );
}

interface FrameProps {
  drawing: Drawing;
  /** Everything on the page that can be selected. */
  ids: ReadonlySet<string>;
  isInSight: boolean;
  children: ReactNode;
}

/** The part of the page that the drawing has: what comes to it from outside, and what lies over it. */
function Frame({ drawing, ids, isInSight, children }: FrameProps) {
  const designer = useDesigner();
  const flow = useReactFlow();
  const distance = useCanvas((state) => state.distance);
  const scale = useCanvas((state) => state.scale);
  const section = useRef<HTMLElement>(null);
  useKeptFocus(section);
  const { isReadOnly, page } = drawing;
  return (
    <section
      className={`canvas ${distance} ${isReadOnly ? "read-only" : ""} ${scale > 1 ? "away" : ""} ${scale > 2 ? "farther" : ""}`}
      style={{ "--scale": scale } as CSSProperties}
      aria-label={`Drawing of ${page?.path || "the file"}`}
      aria-busy={!isInSight}
      ref={section}
      tabIndex={-1}
      onFocus={({ target }) => {
        // What the Tab key reaches is selected: keys do something to it.
        const id = isTabbed() && target.matches(".react-flow__node") ? target.getAttribute("data-id") : null;
        if (id && ids.has(id) && !designer.state.selection.includes(id)) designer.select([id]);
      }}
      onDragOver={(event) => {
        if (!event.dataTransfer.types.includes(kDragged) || isReadOnly) return;
        event.preventDefault();
        event.dataTransfer.dropEffect = "copy";
        aim(designer, event.clientX, event.clientY);
      }}
      onDrop={(event) => {
        const component = event.dataTransfer.getData(kDragged);
        if (!component || isReadOnly) return;
        event.preventDefault();
        canvasStore.setState({ dragged: "", aimedAt: "" });
        dropAt(designer, component, event.clientX, event.clientY);
      }}
      onMouseMove={(event) =>
        canvasStore.setState({ pointer: flow.screenToFlowPosition({ x: event.clientX, y: event.clientY }) })
      }
    >
      <Markers />
      {children}
      {!isInSight && <p className="arranging muted">Arranging…</p>}
      <ValueEditor />
      <ContextMenu />
    </section>
  );
}

/** Shows which transition takes the trigger that is dragged over it. */
function aim(designer: Designer, x: number, y: number): void {
  const { dragged, aimedAt } = canvasStore.getState();
  const over = isTriggerHere(designer, dragged) ? transitionAt(designer, x, y) : undefined;
  const id = over ? transitionId(over) : "";
  if (id !== aimedAt) canvasStore.setState({ aimedAt: id });
}

/** Who works with keys has the focus on what is selected, or on the drawing; else it would be lost with each dialog. */
function useKeptFocus(section: RefObject<HTMLElement | null>): void {
  const designer = useDesigner();
  useEffect(() => {
    if (designer.state.dialog !== "") return;
    const { selection } = designer.state;
    const chosen = selection.length === 1 ? nodeElement(selection[0]!) : null;
    const focused = document.activeElement;
    const isOurs = focused === section.current || (focused?.matches(".canvas .react-flow__node") ?? false);
    if (chosen && isOurs && chosen !== focused) chosen.focus({ preventScroll: true });
    else offerFocus(chosen ?? section.current);
  });
}

/** Heads of transitions. */
function Markers() {
  return (
    <svg className="markers" aria-hidden="true">
      <defs>
        {["arrow", "arrow-strong", "arrow-live"].map((id) => (
          <marker
            key={id}
            id={id}
            viewBox="0 0 10 10"
            refX="9"
            refY="5"
            markerWidth="9"
            markerHeight="9"
            markerUnits="userSpaceOnUse"
            orient="auto-start-reverse"
          >
            <path d="M0 0L10 5L0 10z" />
          </marker>
        ))}
      </defs>
    </svg>
  );
}
