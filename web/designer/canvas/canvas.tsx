// The canvas: what stands on the page that is shown, to be moved, wired and entered.
import {
  applyEdgeChanges,
  applyNodeChanges,
  Background,
  BackgroundVariant,
  type Connection,
  type Edge,
  type EdgeChange,
  type FinalConnectionState,
  type Node as FlowNode,
  MiniMap,
  type NodeChange,
  ReactFlow,
  SelectionMode,
  useReactFlow,
  useStore,
  useStoreApi,
} from "@xyflow/react";
import { type CSSProperties, type DragEvent, type MouseEvent, useEffect, useMemo, useRef, useState } from "react";
import { arrangeChange } from "../arrange/arrange.ts";
import { kPitch, onPitch } from "../arrange/elk.ts";
import { type CanvasNode, type CanvasWire, nodesOf, wiresOf } from "../drawing/flow.ts";
import { dropAt, kDragged } from "../palette/touch_drag.ts";
import { innerOf } from "../session/inside.ts";
import { isEmptyDrawing } from "../session/pages.ts";
import { isTabbed, offerFocus } from "../session/panes.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { canvasStore, distanceAt, useCanvas } from "../sight/canvas_store.ts";
import { forgetMoved, isArranged, keepMoved, usePlaces } from "../sight/use_places.ts";
import { boundsOf, fitReadably, holdsAll, kFarthest, kFit, nodeElement, setView } from "../sight/view.ts";
import { askFits, connectChange, disconnectChange, endOf, reasonAgainst, stopFits } from "../sight/wiring.ts";
import { stateNodes, transitionEdges, transitionId } from "../states/flow.ts";
import { scaleAt } from "../states/label.ts";
import { NodeView, spokenNode } from "../views/node_view.tsx";
import { NoteView, ResultView } from "../views/small_views.tsx";
import { StateView, spokenState } from "../views/state_view.tsx";
import { TransitionView } from "../views/transition_view.tsx";
import { ValueEditor } from "../views/value_editor.tsx";
import { WireView } from "../views/wire_view.tsx";
import { ConnectReason } from "./connect_reason.tsx";
import { ContextMenu, openMenu } from "./context_menu.tsx";
import { FarWires } from "./far_wires.tsx";
import { useGivenHandles } from "./given_handles.ts";
import { selectionAfter, stillThere } from "./selected.ts";

const kNodeTypes = { node: NodeView, result: ResultView, note: NoteView, state: StateView };
const kEdgeTypes = { wire: WireView, transition: TransitionView };
const kMiniSize = { width: 160, height: 110 };
const kSmallMini = { width: 100, height: 72 }; // beside panes that take the room
const kPaneSize = 60; // no pane takes less than twice of it, no line more [px]

export function Canvas({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const flow = useReactFlow();
  useGivenHandles(useStoreApi());
  const [nodes, setNodes] = useState<FlowNode[]>([]);
  const [edges, setEdges] = useState<Edge[]>([]);
  const places = usePlaces(drawing);
  const shown = usePart((state) => state.shown);
  const distance = useCanvas((state) => state.distance);
  const scale = useCanvas((state) => state.scale);
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const isReadOnly = drawing.isReadOnly;
  const page = drawing.page?.path ?? "";
  const isDragging = useRef(false);
  const fittedKind = useRef<Drawing_Kind | null>(null);
  const [isInSight, setInSight] = useState(false);

  // What the drawing has no more is not selected any more: undone, renamed, put into an assemblage.
  const ids = useMemo(() => selectable(drawing), [drawing]);
  useEffect(() => designer.select(stillThere(designer.state.selection, ids)), [ids, designer]);

  useEffect(() => {
    if (!places || isDragging.current) return;
    const selection = new Set(designer.state.selection);
    const mark = (node: FlowNode): FlowNode =>
      (node.selected ?? false) === selection.has(node.id) ? node : { ...node, selected: selection.has(node.id) };
    setNodes((before) =>
      (isStates ? stateNodes(drawing, places, before) : nodesOf(drawing, places, before as CanvasNode[]))
        .map((node) => withLabel(node as FlowNode))
        .map(mark),
    );
    setEdges((before) =>
      isStates ? transitionEdges(drawing, places, before, scale) : wiresOf(drawing, before as CanvasWire[]),
    );
  }, [drawing, places, isStates, designer, scale]);

  // Once, when the page has come into sight or become one of states; later only where somebody asks for it.
  useEffect(() => {
    // On an empty page the camera stays where the first thing is put.
    if (isEmptyDrawing(drawing)) {
      fittedKind.current = drawing.kind;
      setInSight(true);
    }
    if (fittedKind.current === drawing.kind || nodes.length === 0) return;
    if (nodes.some((node) => node.type === "state") !== isStates) return; // still those of before
    fittedKind.current = drawing.kind;
    const only = designer.state.selection.map((id) => ({ id }));
    const fitted = only.length > 0 && nodes.length > 40 ? flow.fitView({ ...kFit, nodes: only }) : fitReadably(flow);
    void fitted.then(() => setInSight(true));
  }, [nodes, flow, designer, drawing, isStates]);

  // What is selected elsewhere (a problem, a link, the details) is selected here.
  const selection = usePart((state) => state.selection);
  useEffect(() => {
    const wanted = new Set(selection);
    const mark = <T extends { id: string; selected?: boolean }>(items: T[]): T[] =>
      items.every((item) => (item.selected ?? false) === wanted.has(item.id))
        ? items
        : items.map((item) =>
            (item.selected ?? false) === wanted.has(item.id) ? item : { ...item, selected: wanted.has(item.id) },
          );
    setNodes(mark);
    setEdges(mark);
  }, [selection]);

  useEffect(() => setView(flow), [flow]);

  // Who works with keys has the focus on what is selected, or on the drawing; else it would be lost with each dialog.
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    if (designer.state.dialog !== "") return;
    const chosen = selection.length === 1 ? nodeElement(selection[0]!) : null;
    const focused = document.activeElement;
    const isOurs = focused === section.current || (focused?.matches(".canvas .react-flow__node") ?? false);
    if (chosen && isOurs && chosen !== focused) chosen.focus({ preventScroll: true });
    else offerFocus(chosen ?? section.current);
  });

  // A pane that opens beside the canvas takes of its place: who has not moved the camera goes on seeing everything. A line
  // that comes and goes above it moves nothing.
  const width = useStore((state) => Math.round(state.width / kPaneSize));
  const height = useStore((state) => Math.round(state.height / kPaneSize));
  const sizeBefore = useRef({ width: 0, height: 0 });
  const isFitted = useRef(true);
  useEffect(() => {
    const before = sizeBefore.current;
    if (Math.abs(width - before.width) < 2 && Math.abs(height - before.height) < 2) return;
    sizeBefore.current = { width, height };
    if (isFitted.current && before.width > 0 && fittedKind.current !== null && !isEmpty.current) void fitReadably(flow);
  }, [width, height, flow]);
  const miniSize = useStore((state) => (state.width > 3.5 * kMiniSize.width ? kMiniSize : kSmallMini));
  const hasRoom = useStore((state) => state.width > 3 * kSmallMini.width && state.height > 3 * kMiniSize.height);

  const isEmpty = useRef(true);
  isEmpty.current = nodes.length === 0;

  const nodesChange = (changes: NodeChange[]) => {
    designer.select(stillThere(selectionAfter(designer.state.selection, changes), ids));
    setNodes((before) => applyNodeChanges(changes, before));
  };
  const edgesChange = (changes: EdgeChange[]) => {
    designer.select(stillThere(selectionAfter(designer.state.selection, changes), ids));
    setEdges((before) => applyEdgeChanges(changes, before));
  };

  const moveEnds = (moved: readonly FlowNode[]) => {
    isDragging.current = false;
    if (moved.length === 0 || isReadOnly) return;
    const changed = moved.filter((node) => nodes.find((one) => one.id === node.id));
    const { changes, places: now } = arrangeChange(drawing, changed, places ?? new Map(), isArranged(drawing));
    keepMoved(drawing, now);
    const name = changed.length === 1 ? `move ${changed[0]!.id}` : `move ${changed.length} nodes`;
    void designer.edit(name, ...changes).then((answer) => !answer.ok && forgetMoved(drawing));
  };

  const connect = ({ source, target, targetHandle }: Connection) => {
    if (isStates) {
      void designer.edit(`transition from ${source} to ${target}`, {
        case: "addTransition",
        value: { page, from: source, to: target, trigger: "" },
      });
      return;
    }
    void designer.edit("", connectChange(page, source, target, targetHandle ?? ""));
  };

  const connectStarts = (
    _: unknown,
    { nodeId, handleId, handleType }: { nodeId: string | null; handleId: string | null; handleType: string | null },
  ) => {
    if (isStates || !nodeId) return;
    void askFits(designer, handleType === "source" ? { node: nodeId } : { to: { node: nodeId, row: handleId ?? "" } });
  };

  /** Let go where nothing is: the search palette offers what fits there. */
  const connectEnds = (event: globalThis.MouseEvent | TouchEvent, end: FinalConnectionState) => {
    const reason = end.toHandle && !end.isValid ? whyNot(end) : "";
    stopFits();
    if (reason) designer.tell(reason, "hold");
    if (end.toHandle || end.toNode || !end.fromHandle || isReadOnly || isStates) return;
    const at = flow.screenToFlowPosition(pointOf(event));
    const from = end.fromHandle;
    designer.store.setState({
      dialog: "place",
      placing: {
        x: onPitch(at.x),
        y: onPitch(at.y),
        ...(from.type === "source" ? { from: from.nodeId } : { to: placeFor(from.nodeId, from.id ?? "") }),
      },
    });
  };

  const reconnect = (old: Edge, { source, target, targetHandle }: Connection) => {
    if (isStates) return;
    const end = endOf(old.id);
    if (end.node === target && end.row === targetHandle && old.source === source) return;
    const cut = disconnectChange(page, end.node, end.row);
    const wire = connectChange(page, source, target, targetHandle ?? "");
    void designer.edit(
      `move a wire of ${source}`,
      ...(end.node === target && end.row === targetHandle ? [wire] : [cut, wire]),
    );
  };

  const drop = (event: DragEvent) => {
    const component = event.dataTransfer.getData(kDragged);
    if (!component || isReadOnly) return;
    event.preventDefault();
    dropAt(designer, component, event.clientX, event.clientY);
  };

  const isLarge = nodes.length > 120;
  const showsFarWires = !isStates && distance !== "near" && edges.length > 150;
  const noEdges = useMemo<Edge[]>(() => [], []);
  return (
    <section
      className={`canvas ${distance} ${isReadOnly ? "read-only" : ""} ${scale > 1 ? "away" : ""} ${scale > 2 ? "farther" : ""}`}
      style={{ "--scale": scale } as CSSProperties}
      aria-label={`Drawing of ${page || "the file"}`}
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
      }}
      onDrop={drop}
      onMouseMove={(event) =>
        canvasStore.setState({ pointer: flow.screenToFlowPosition({ x: event.clientX, y: event.clientY }) })
      }
    >
      <Markers />
      <ReactFlow
        nodes={nodes}
        edges={showsFarWires ? noEdges : edges}
        nodeTypes={kNodeTypes}
        edgeTypes={kEdgeTypes}
        onNodesChange={nodesChange}
        onEdgesChange={edgesChange}
        onNodeDragStart={() => {
          isDragging.current = true;
        }}
        onNodeDragStop={(_, __, moved) => moveEnds(moved)}
        onSelectionDragStart={() => {
          isDragging.current = true;
        }}
        onSelectionDragStop={(_, moved) => moveEnds(moved)}
        onConnect={connect}
        onConnectStart={connectStarts}
        onConnectEnd={connectEnds}
        onReconnect={reconnect}
        onReconnectEnd={(_, wire, __, end) => {
          stopFits();
          if (isReadOnly || isStates || end.toHandle) return;
          const { node, row } = endOf(wire.id);
          void designer.edit(`disconnect ${wire.source}`, disconnectChange(page, node, row));
        }}
        isValidConnection={(wire) =>
          isStates || reasonAgainst(wire.source, wire.target, wire.targetHandle ?? "") === ""
        }
        onEdgeClick={(event: MouseEvent, wire) => {
          if (!event.altKey || isReadOnly) return;
          void cutWire(designer, page, wire.id, isStates);
        }}
        onNodeContextMenu={(event, node) => showMenu(designer, node.id, event)}
        onEdgeContextMenu={(event, wire) => showMenu(designer, wire.id, event)}
        onNodeDoubleClick={(_, node) => {
          // The browser has taken it for a word: what it found to select is in a pane beside the canvas.
          window.getSelection()?.removeAllRanges();
          enter(designer, drawing, node.id);
        }}
        onMove={(event, view) => {
          if (event) isFitted.current = false; // by hand
          noteView(view, nodes.length);
        }}
        onInit={(started) => noteView(started.getViewport(), nodes.length)}
        nodesConnectable={!isReadOnly}
        nodesDraggable={!isReadOnly}
        edgesReconnectable={!isReadOnly && !isStates}
        edgesFocusable={false}
        disableKeyboardA11y
        deleteKeyCode={null}
        selectionKeyCode="Shift"
        multiSelectionKeyCode={["Shift", "Control", "Meta"]}
        panActivationKeyCode={null}
        selectionMode={SelectionMode.Partial}
        panOnDrag={[1, 2]}
        selectionOnDrag
        panOnScroll
        zoomOnDoubleClick={false}
        snapToGrid
        snapGrid={[kPitch, kPitch]}
        minZoom={kFarthest}
        maxZoom={2}
        connectionRadius={26}
        onlyRenderVisibleElements={isLarge}
        elevateNodesOnSelect={false}
        proOptions={{ hideAttribution: true }}
      >
        {shown.grid && <Background variant={BackgroundVariant.Dots} gap={kPitch * 3} size={1.6} />}
        {showsFarWires && <FarWires nodes={nodes} edges={edges} />}
        {shown.minimap && hasRoom && <Overview nodes={nodes} size={miniSize} />}
        <ConnectReason />
      </ReactFlow>
      {!isInSight && <p className="arranging muted">Arranging…</p>}
      <ValueEditor />
      <ContextMenu />
    </section>
  );
}

/** Everything on the page that can be selected. */
function selectable(drawing: Drawing): ReadonlySet<string> {
  const { nodes, states, notes } = drawing;
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const wires = isStates ? drawing.transitions.map(transitionId) : wiresOf(drawing, []).map((wire) => wire.id);
  return new Set([...[...nodes, ...states].map((one) => one.name), ...notes.map((note) => note.id), ...wires]);
}

/** Where on the page one is; a page that is seen as a whole needs none. */
function Overview({ nodes, size }: { nodes: readonly FlowNode[]; size: typeof kMiniSize }) {
  const bounds = useMemo(() => boundsOf(nodes), [nodes]);
  const isWhole = useCanvas(({ view }) => holdsAll(view, bounds));
  if (isWhole) return null;
  return (
    <MiniMap
      style={size}
      pannable
      zoomable
      ariaLabel="Overview of the drawing"
      nodeStrokeWidth={0}
      className="minimap"
      nodeClassName={toneClass}
    />
  );
}

function showMenu(designer: ReturnType<typeof useDesigner>, id: string, event: MouseEvent): void {
  event.preventDefault();
  openMenu(designer, id, event);
}

function withLabel(node: FlowNode): FlowNode {
  if (node.ariaLabel) return node;
  const data = node.data as Record<string, never>;
  const label =
    node.type === "node"
      ? spokenNode(data.node!)
      : node.type === "state"
        ? spokenState(data.state!)
        : node.type === "result"
          ? "Result of the page"
          : "Comment";
  return { ...node, ariaLabel: label };
}

function toneClass(node: FlowNode): string {
  if (node.type === "state") return "tone-sequence";
  if (node.type !== "node") return `mini-${node.type}`;
  return `tone-${(node.data as { form: { tone: string } }).form.tone}`;
}

function placeFor(node: string, row: string) {
  const found = /^(.*)\[(\d+)\]$/.exec(row);
  return found ? { node, port: found[1]!, index: Number(found[2]) } : { node, port: row };
}

function whyNot(end: FinalConnectionState): string {
  const [from, to] = [end.fromHandle, end.toHandle];
  if (!from || !to) return "";
  return from.type === "source"
    ? reasonAgainst(from.nodeId, to.nodeId, to.id ?? "")
    : reasonAgainst(to.nodeId, from.nodeId, from.id ?? "");
}

function pointOf(event: globalThis.MouseEvent | TouchEvent): { x: number; y: number } {
  const touch = "changedTouches" in event ? event.changedTouches[0] : event;
  return { x: touch?.clientX ?? 0, y: touch?.clientY ?? 0 };
}

function noteView({ x, y, zoom }: { x: number; y: number; zoom: number }, nodes: number): void {
  const element = document.querySelector(".canvas");
  const { width = 800, height = 600 } = element?.getBoundingClientRect() ?? {};
  const distance = distanceAt(zoom, nodes);
  canvasStore.setState({
    distance,
    scale: scaleAt(zoom),
    view: { x: -x / zoom, y: -y / zoom, width: width / zoom, height: height / zoom },
  });
}

export function enter(designer: ReturnType<typeof useDesigner>, drawing: Drawing, name: string): boolean {
  const inner = innerOf(drawing, name);
  if (!inner) return false;
  designer.enter(inner);
  return true;
}

export function cutWire(designer: ReturnType<typeof useDesigner>, page: string, id: string, isStates: boolean) {
  if (isStates) {
    const at = id.lastIndexOf("/");
    return designer.edit("", {
      case: "removeTransition",
      value: { page, from: id.slice(0, at), index: Number(id.slice(at + 1)) },
    });
  }
  const { node, row } = endOf(id);
  return designer.edit("", disconnectChange(page, node, row));
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
