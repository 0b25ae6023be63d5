import { Button } from "../../ui/controls/controls.tsx";
import { alignSelection } from "../actions/arranging.ts";
import { frameSelection } from "../actions/editing.ts";
import type { Edge } from "../arrange/arrange.ts";
import { groupMembers } from "../palette/societies.ts";
import { lastPart } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { Heading, Section } from "./parts.tsx";

const kAligns: readonly (readonly [Edge, string])[] = [
  ["left", "Left"],
  ["centre", "Centre"],
  ["right", "Right"],
  ["top", "Top"],
  ["middle", "Middle"],
  ["bottom", "Bottom"],
  ["across", "Spread across"],
  ["down", "Spread down"],
];

export function GroupDetails({ drawing, selection }: { drawing: Drawing; selection: readonly string[] }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const isFlow = drawing.kind === Drawing_Kind.DATAFLOW || drawing.kind === Drawing_Kind.ROBOT;
  return (
    <div className="details">
      <Heading
        name={`${selection.length} selected`}
        kind={selection.slice(0, 4).map(lastPart).join(", ") + (selection.length > 4 ? " …" : "")}
      />
      {!isReadOnly && (
        <>
          <Section title="Align">
            <div className="columns" style={{ gap: 4 }}>
              {kAligns.map(([edge, label]) => (
                <Button key={edge} onPress={() => alignSelection(designer, edge)}>
                  {label}
                </Button>
              ))}
            </div>
          </Section>
          <Section title="Together">
            <div className="columns" style={{ gap: 4 }}>
              {isFlow && (
                <Button tone="primary" onPress={() => designer.store.setState({ dialog: "group" })}>
                  Make an assemblage of them…
                </Button>
              )}
              {drawing.kind === Drawing_Kind.SOCIETY && (
                <Button tone="primary" onPress={() => void groupMembers(designer, drawing, selection)}>
                  Make a caste of them
                </Button>
              )}
              <Button onPress={() => frameSelection(designer)}>Frame</Button>
            </div>
          </Section>
        </>
      )}
    </div>
  );
}
