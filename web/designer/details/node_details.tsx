import type { ReactNode } from "react";
import { Button } from "../../ui/controls/controls.tsx";
import { ungroup } from "../actions/editing.ts";
import { ownCopy } from "../actions/place_actions.ts";
import { kindOf } from "../drawing/form.ts";
import { typeWords } from "../drawing/value_words.ts";
import { drawnAt } from "../names/at.ts";
import { renameNow } from "../names/rename.ts";
import type { Designer } from "../session/designer.ts";
import type { FieldOf } from "../session/extensions.ts";
import { lastPart } from "../session/pages.ts";
import { type Drawing, type Node, Node_Shape } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly, usePart } from "../session/use.ts";
import { InputList } from "./input_list.tsx";
import { Heading, Section, SentField } from "./parts.tsx";

export function NodeDetails({ drawing, node }: { drawing: Drawing; node: Node }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const help = useHelp(node);
  return (
    <div className="details">
      <Heading name={node.title || node.name} kind={kindLine(node)} help={help} />
      {page !== "" && node.shape !== Node_Shape.ACTUATOR && node.shape !== Node_Shape.BINDING && (
        <SentField
          label="Name"
          value={lastPart(node.name)}
          send={(name) =>
            void renameNow(
              designer,
              drawnAt(designer, node.name),
              name,
              () => void designer.edit("", { case: "rename", value: { page, node: node.name, name } }),
            )
          }
        />
      )}
      <NodeButtons designer={designer} node={node} isReadOnly={isReadOnly} />
      {node.inputs.length > 0 && <Inputs drawing={drawing} node={node} />}
      {node.type !== "" && (
        <Section title="Output">
          <p className="small">
            {typeWords(node.type, node.unit)}
            <span className="muted"> · {readersOf(drawing, node.name)}</span>
          </p>
        </Section>
      )}
    </div>
  );
}

function Inputs({ drawing, node }: { drawing: Drawing; node: Node }) {
  const Live = useDesigner().extensions.inputs;
  const list = (fieldOf: FieldOf, chooser: ReactNode) => (
    <Section title="Inputs">
      {chooser}
      <InputList drawing={drawing} node={node} fieldOf={fieldOf} />
    </Section>
  );
  return Live ? <Live node={node}>{list}</Live> : list(() => undefined, null);
}

function kindLine(node: Node): string {
  const kind = kindOf(node.shape);
  return node.component && node.component !== node.name ? `${node.component}, ${kind}` : kind;
}

/** The node's own, or else its component's. */
function useHelp(node: Node): string {
  const component = usePart((state) =>
    state.palettes[state.document]?.components.find((one) => one.name === node.component),
  );
  return node.help || component?.help || "";
}

function readersOf(drawing: Drawing, name: string): string {
  const to = drawing.wires
    .filter((wire) => wire.from === name)
    .map((wire) => (wire.to.startsWith("$") ? "the result" : lastPart(wire.to)));
  if (drawing.resultNode === name && !to.includes("the result")) to.push("the result");
  return to.length === 0 ? "leads nowhere yet" : `leads to ${[...new Set(to)].join(", ")}`;
}

function NodeButtons({ designer, node, isReadOnly }: { designer: Designer; node: Node; isReadOnly: boolean }) {
  const { page, document } = designer.state;
  const canOpen = node.inner !== undefined;
  const isLibrary = canOpen && node.inner!.document !== "" && node.inner!.document !== document;
  return (
    <div className="columns" style={{ gap: 4 }}>
      {canOpen && (
        <Button icon="right" onPress={() => designer.navigation.enter(node.inner!)}>
          Look inside
        </Button>
      )}
      {!isReadOnly && page !== "" && node.type !== "" && (
        <Button icon="draw" onPress={() => designer.store.setState({ dialog: "connect", subject: node.name })}>
          Connect…
        </Button>
      )}
      {!isReadOnly && isLibrary && (
        <Button icon="file" onPress={() => void ownCopy(designer, node.name)}>
          Make my own copy
        </Button>
      )}
      {!isReadOnly && page !== "" && canOpen && node.shape === Node_Shape.ASSEMBLAGE && (
        <Button onPress={() => void ungroup(designer, node.name)}>Ungroup</Button>
      )}
      {!isReadOnly && page !== "" && (
        <Button
          onPress={() => designer.store.setState({ dialog: "place", placing: { x: 0, y: 0, replace: node.name } })}
        >
          Replace…
        </Button>
      )}
    </div>
  );
}
