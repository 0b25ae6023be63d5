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

function Input({ drawing, node, port, fieldOf, isFlow, canExpose }: InputProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const row = rowId(port.name, port.index);
  const wires = drawing.wires.filter((wire) => wire.to === node.name && rowId(wire.port, wire.index) === row);
  const isWired = (wiredInputsOf(drawing).get(node.name)?.has(row) ?? false) && !port.isExposed;
  const label = rowLabel(port);
  const drive = () =>
    designer.store.setState({
      dialog: "place",
      placing: {
        ...leftOf(node),
        page,
        to: { node: node.name, port: port.name, ...(port.index === undefined ? {} : { index: port.index }) },
      },
    });
  if (isWired || (port.isList && port.index === undefined) || (port.isMember && port.value === "")) {
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
              <IconButton icon="plus" label={`Place something for ${label}`} onPress={drive} />
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
      {!isReadOnly && isFlow && (
        <IconButton className="input-drive" icon="plus" label={`Place something for ${label}`} onPress={drive} />
      )}
    </li>
  );
}

function leftOf(node: Node): { x: number; y: number } {
  return { x: (node.x ?? 0) - 280, y: node.y ?? 0 };
}
