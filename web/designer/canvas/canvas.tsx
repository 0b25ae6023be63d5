// The canvas: what stands on the page that is shown, and what hands do to it, each in a file of its own.
import {
  Background,
  BackgroundVariant,
  type Edge,
  ReactFlow,
  type ReactFlowProps,
  SelectionMode,
  useReactFlow,
  useStoreApi,
} from "@xyflow/react";
import { type CSSProperties, type ReactNode, useMemo, useRef } from "react";
import { kPitch } from "../arrange/elk.ts";
import { pageDifference, withGhosts } from "../compare/compared.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { canvasStore, useCanvas } from "../sight/canvas_store.ts";
import { usePlaces } from "../sight/use_places.ts";
import { kFarthest } from "../sight/view.ts";
import { NodeView } from "../views/node_view.tsx";
import { NoteView, ResultView } from "../views/small_views.tsx";
import { StateView } from "../views/state_view.tsx";
import { TransitionView } from "../views/transition_view.tsx";
import { ValueEditor } from "../views/value_editor.tsx";
import { WireView } from "../views/wire_view.tsx";
import { useCamera } from "./camera.ts";
import { ConnectReason } from "./connect_reason.tsx";
import { connecting } from "./connecting.ts";
import { ContextMenu, menus } from "./context_menu.tsx";
import { dropping } from "./dropping.ts";
import { useElements } from "./elements.ts";
import { entering } from "./entering.ts";
import { FarWires } from "./far_wires.tsx";
import { selectTabbed, useKeptFocus } from "./focus.ts";
import { useGivenHandles } from "./given_handles.ts";
import { Markers } from "./markers.tsx";
import { useMoving } from "./moving.ts";
import { Overview } from "./overview.tsx";
import { useSelecting } from "./selecting.ts";

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
/** With more wires than these, those far away are drawn in one piece. */
const kManyWires = 150;
/** With more nodes than these, only those in sight are drawn. */
const kManyNodes = 120;

export function Canvas({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const flow = useReactFlow();
  useGivenHandles(useStoreApi());
  const { isReadOnly } = drawing;
  const isStates = drawing.kind === Drawing_Kind.STATES;
  const shown = usePart((state) => state.shown);
  const isNear = useCanvas((state) => state.distance === "near");
  const difference = usePart(pageDifference);
  const places = usePlaces(useMemo(() => withGhosts(drawing, difference), [drawing, difference]));
  const selecting = useSelecting(drawing);
  const moving = useMoving(drawing, places);
  const { nodes, edges, ...changes } = useElements({ drawing, difference }, places, selecting, moving.isMoving);
  const camera = useCamera(drawing, nodes);
  const connects = useMemo(() => connecting(designer, drawing, flow), [designer, drawing, flow]);
  const showsFarWires = !isStates && !isNear && edges.length > kManyWires;
  return (
    <Frame drawing={drawing} ids={selecting.ids} isInSight={camera.isInSight}>
      <ReactFlow
        {...kBehaviour}
        {...connects}
        {...changes}
        {...moving.handlers(nodes)}
        {...menus(designer)}
        {...entering(designer, drawing)}
        nodes={nodes}
        edges={showsFarWires ? kNoEdges : edges}
        onMove={(event, view) => camera.moved(view, Boolean(event))}
        onInit={(started) => camera.moved(started.getViewport(), false)}
        nodesConnectable={!isReadOnly}
        nodesDraggable={!isReadOnly}
        edgesReconnectable={!isReadOnly && !isStates}
        onlyRenderVisibleElements={nodes.length > kManyNodes}
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
      {...dropping(designer, isReadOnly)}
      className={`canvas ${distance} ${isReadOnly ? "read-only" : ""} ${scale > 1 ? "away" : ""} ${scale > 2 ? "farther" : ""}`}
      style={{ "--scale": scale } as CSSProperties}
      aria-label={`Drawing of ${page?.path || "the file"}`}
      aria-busy={!isInSight}
      ref={section}
      tabIndex={-1}
      onFocus={(event) => selectTabbed(designer, ids, event)}
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
