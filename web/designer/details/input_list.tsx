// The inputs of a node as fields: of one on the page that is shown, and of one in a trigger.
import { IconButton } from "../../ui/controls/controls.tsx";
import { wiredInputsOf } from "../drawing/flow.ts";
import { rowId, rowLabel } from "../drawing/form.ts";
import { typeWords } from "../drawing/value_words.ts";
import type { FieldOf } from "../session/extensions.ts";
import { lastPart } from "../session/pages.ts";
import type { Drawing, Node, Port } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { disconnectChange } from "../sight/wiring.ts";
import { ValueField } from "../views/value_editor.tsx";

interface InputListProps {
  /** The page of the node. */
  drawing: Drawing;
  node: Node;
  fieldOf?: FieldOf;
  /** Nothing is placed on the page to drive an input. */
  isFlow?: boolean;
  canExpose?: boolean;
}

export function InputList({
  drawing,
  node,
  fieldOf = () => undefined,
  isFlow = true,
  canExpose = true,
}: InputListProps) {
  return (
    <ul className="inputs">
      {node.inputs.map((port) => (
        <Input
          key={rowId(port.name, port.index)}
          drawing={drawing}
          node={node}
          port={port}
          fieldOf={fieldOf}
          isFlow={isFlow}
          canExpose={canExpose}
        />
      ))}
    </ul>
  );
}

interface InputProps {
  drawing: Drawing;
  node: Node;
  port: Port;
  fieldOf: FieldOf;
  isFlow: boolean;
  canExpose: boolean;
}

function Input(props: InputProps) {
  const { drawing, node, port, fieldOf, isFlow, canExpose } = props;
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const isWired = (wiredInputsOf(drawing).get(node.name)?.has(rowOf(port)) ?? false) && !port.isExposed;
  if (isWired || (port.isList && port.index === undefined) || (port.isMember && port.value === ""))
    return <WiredInput {...props} isWired={isWired} />;
  return (
    <li className="input-row">
      {fieldOf(port, "value") ?? (
        <ValueField
          page={page}
          node={node}
          port={port}
          what="value"
          isCompact
          canExpose={canExpose}
          onDone={() => {}}
        />
      )}
      {!isReadOnly && isFlow && <Drive className="input-drive" page={page} node={node} port={port} />}
    </li>
  );
}

/** What has no value of its own: a wire leads to it, or could. */
function WiredInput({ drawing, node, port, fieldOf, isFlow, isWired }: InputProps & { isWired: boolean }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const row = rowOf(port);
  const wires = drawing.wires.filter((wire) => wire.to === node.name && rowId(wire.port, wire.index) === row);
  const label = rowLabel(port);
  return (
    <li className="input-row">
      <div className="columns spread" style={{ flexWrap: "nowrap" }}>
        <span className="small ellipsis">
          <b>{label}</b>{" "}
          <span className="muted">
            {wires.length > 0
              ? `from ${wires.map((wire) => lastPart(wire.from)).join(", ")}`
              : typeWords(port.type, port.unit)}
          </span>
        </span>
        {!isReadOnly &&
          isFlow &&
          (isWired ? (
            <IconButton
              icon="close"
              label={`Disconnect ${label}`}
              onPress={() => void designer.edit("", disconnectChange(page, node.name, row))}
            />
          ) : (
            <Drive page={page} node={node} port={port} />
          ))}
      </div>
      {port.isMember &&
        isWired &&
        (fieldOf(port, "weight") ?? (
          <ValueField page={page} node={node} port={port} what="weight" isCompact onDone={() => {}} />
        ))}
    </li>
  );
}

/** Asks for a component that drives the input. */
function Drive({ page, node, port, className }: { page: string; node: Node; port: Port; className?: string }) {
  const designer = useDesigner();
  const to = { node: node.name, port: port.name, ...(port.index === undefined ? {} : { index: port.index }) };
  return (
    <IconButton
      {...(className ? { className } : {})}
      icon="plus"
      label={`Place something for ${rowLabel(port)}`}
      onPress={() => designer.store.setState({ dialog: "place", placing: { ...leftOf(node), page, to } })}
    />
  );
}

function rowOf({ name, index }: Port): string {
  return rowId(name, index);
}

function leftOf(node: Node): { x: number; y: number } {
  return { x: (node.x ?? 0) - 280, y: node.y ?? 0 };
}
