// A node: its outline, what it is called, its inputs with their values.
import { Handle, type NodeProps, Position } from "@xyflow/react";
import { memo } from "react";
import { flowOf } from "../../core/value_types.ts";
import { Icon } from "../../ui/controls/icons.tsx";
import { DifferenceSign, useDifferenceClass } from "../compare/sign.tsx";
import { type CanvasNode, kOutputHandle } from "../drawing/flow.ts";
import { type Form, kindOf, type Row } from "../drawing/form.ts";
import { outlinePath } from "../drawing/outline.ts";
import { typeWords } from "../drawing/value_words.ts";
import { LiveBadge } from "../running/badge.tsx";
import { BreakDot } from "../running/break_dot.tsx";
import { useLive } from "../running/use_live.ts";
import type { Node } from "../session/protocol.ts";
import { useDesigner, useTrouble } from "../session/use.ts";
import { canvasStore, useCanvas } from "../sight/canvas_store.ts";
import { NodeIcon } from "./icons.tsx";

type Props = NodeProps<Extract<CanvasNode, { type?: "node" }>>;

export const NodeView = memo(function NodeView({ data, selected }: Props) {
  const { node, form, page } = data;
  const distance = useCanvas((state) => state.distance);
  const isActive = useLive(page, node.live)?.isActive ?? false;
  const trouble = useTrouble(node.name);
  const differs = useDifferenceClass(node.name);
  const classes = [
    "node",
    `tone-${form.tone}`,
    distance,
    selected ? "selected" : "",
    node.isLoose ? "loose" : "",
    isActive ? "active" : "",
    trouble,
    differs,
  ];
  if (distance === "farthest") {
    return (
      <div className={classes.join(" ")} style={sizeOf(form)}>
        <div className="node-block" />
      </div>
    );
  }
  return (
    <div className={classes.join(" ")} style={sizeOf(form)}>
      <svg className="node-outline" width={form.width} height={form.height} aria-hidden="true">
        <path d={outlinePath(form.outline, form.width, form.height)} />
      </svg>
      <BreakDot page={page} id={node.name} />
      <DifferenceSign name={node.name} inner={node.inner?.path} />
      {distance === "far" ? (
        <div className="node-far">{form.title}</div>
      ) : (
        <Parts node={node} form={form} page={page} />
      )}
    </div>
  );
});

function Parts({ node, form, page }: { node: Node; form: Form; page: string }) {
  return (
    <>
      <div className={`node-head ${form.rows.length === 0 ? "alone" : ""}`} title={node.help || undefined}>
        <span className="node-icon">
          <NodeIcon icon={node.icon} component={node.component} shape={node.shape} />
        </span>
        <span className="node-names">
          <span className="node-title ellipsis">{form.title}</span>
          {form.outputY !== 16 && <span className="node-kind ellipsis">{form.subtitle}</span>}
        </span>
        {node.inner && <EnterButton node={node} />}
      </div>
      {form.rows.map((row) => (
        <InputRow key={row.id} node={node} row={row} />
      ))}
      {form.extras.map((extra) => (
        <Handle
          key={extra.id}
          type="target"
          id={extra.id}
          position={Position.Left}
          className="port extra"
          style={{ top: extra.y }}
          title={extra.id.startsWith("weight") ? "Weight of the member" : extra.id}
        />
      ))}
      {form.symbol.length > 0 && form.rows.length > 1 && (
        <span className="node-symbol" aria-hidden="true">
          {form.symbol}
        </span>
      )}
      {form.outputY >= 0 && <Output node={node} form={form} />}
      {node.isLoose && <LiveBadge page={page} live={node.live} y={form.outputY} />}
    </>
  );
}

function EnterButton({ node }: { node: Node }) {
  const designer = useDesigner();
  return (
    <button
      type="button"
      className="node-enter nodrag"
      tabIndex={-1}
      title={`Look inside of ${node.name}`}
      aria-label={`Look inside of ${node.name}`}
      data-file={node.inner!.document}
      data-page={node.inner!.path}
      onClick={(event) => {
        event.stopPropagation();
        designer.navigation.enter(node.inner!);
      }}
    >
      <Icon name="right" />
    </button>
  );
}

function InputRow({ node, row }: { node: Node; row: Row }) {
  const key = `${node.name}/${row.id}`;
  const fit = useCanvas((state) => (state.fits ? (state.fits.get(key) ?? "?") : ""));
  const isConnecting = useCanvas((state) => state.fits !== null);
  const edit = (what: "value" | "weight") => (event: { stopPropagation(): void }) => {
    event.stopPropagation();
    canvasStore.setState({ editing: { node: node.name, row: row.id, what } });
  };
  const state = !isConnecting || fit === "?" ? "" : fit === "" ? "fits" : "refused";
  const { port } = row;
  const canEdit = row.kind !== "wired" && row.kind !== "more";
  const weight = port.weightWire || port.weight || "1";
  return (
    <div className={`row ${row.kind} ${state}`} style={{ top: row.y - 12 }} data-row={key}>
      <Handle
        type="target"
        id={row.id}
        position={Position.Left}
        className={`port flow-${flowOf(port.type)} ${row.kind}`}
        title={`${row.label}: ${typeWords(port.type, port.unit)}`}
      />
      <span className="row-label ellipsis" title={port.help || undefined}>
        {row.kind === "more" ? `+ ${row.label}` : row.label}
      </span>
      {port.isMember && row.kind !== "more" && (
        <button
          type="button"
          tabIndex={-1}
          className={`row-weight nodrag ellipsis ${port.weight ? "" : "none"}`}
          title={`× ${weight}`}
          aria-label={`Weight of ${row.label}: × ${weight}`}
          onClick={edit("weight")}
        >
          × {weight}
        </button>
      )}
      {canEdit && !(port.isMember && row.value === "") && (
        <button
          type="button"
          tabIndex={-1}
          className="row-value nodrag ellipsis"
          title={shownValue(row)}
          aria-label={`${row.label} of ${node.name}: ${shownValue(row)}`}
          onClick={edit("value")}
        >
          {shownValue(row)}
        </button>
      )}
    </div>
  );
}

function shownValue(row: Row): string {
  return row.value || (row.kind === "needed" ? "needed" : "–");
}

function Output({ node, form }: { node: Node; form: Form }) {
  const fit = useCanvas((state) => state.fits?.get(node.name));
  const state = fit === undefined ? "" : fit === "" ? "fits" : "refused";
  return (
    <Handle
      type="source"
      id={kOutputHandle}
      position={Position.Right}
      className={`port out flow-${flowOf(node.type)} ${state}`}
      style={{ top: form.outputY }}
      title={`${node.name} gives ${typeWords(node.type, node.unit)}`}
    />
  );
}

function sizeOf(form: Form) {
  return { width: form.width, height: form.height };
}

/** What a screen reader says of a node. */
export function spokenNode(node: Node): string {
  const open = node.inputs.filter((port) => port.isRequired && !port.value).length;
  const parts = [
    node.title || node.name,
    node.component && node.component !== node.name ? node.component : "",
    kindOf(node.shape),
  ];
  if (node.type) parts.push(`gives ${typeWords(node.type, node.unit)}`);
  if (node.inputs.length > 0) parts.push(`${node.inputs.length} inputs${open > 0 ? `, ${open} without a value` : ""}`);
  if (node.isLoose) parts.push("not connected");
  return parts.filter((part) => part !== "").join(", ");
}
