// What is selected, in words and fields; without a selection the page itself.
import { DifferenceDetails } from "../compare/sign.tsx";
import { OwnProblems } from "../problems/own_problems.tsx";
import { isEquipment } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { transitionOf } from "../states/flow.ts";
import { EquipmentNodeDetails } from "./equipment_details.tsx";
import { GroupDetails } from "./group_details.tsx";
import { NodeDetails } from "./node_details.tsx";
import { NoteDetails } from "./note_details.tsx";
import { PageDetails } from "./page_details.tsx";
import { MemberDetails } from "./society_details.tsx";
import { StateDetails } from "./state_details.tsx";
import { TransitionDetails } from "./transition_details.tsx";
import { WireDetails } from "./wire_details.tsx";
import "./details.css";

export default function Details() {
  const designer = useDesigner();
  const drawing = useDrawing();
  const selection = usePart((state) => state.selection);
  if (!drawing) return <p className="empty small">Nothing is open.</p>;
  if (selection.length > 1) return <GroupDetails drawing={drawing} selection={selection} />;
  const id = selection[0] ?? "";
  const Live = designer.extensions.details;
  return (
    <>
      {id !== "" && (
        <div className="details details-problems">
          <OwnProblems node={id} />
        </div>
      )}
      {id !== "" && <DifferenceDetails name={id} />}
      <SelectedDetails drawing={drawing} id={id} />
      {Live && id !== "" && (
        <div className="details">
          <Live key={id} drawing={drawing} id={id} />
        </div>
      )}
    </>
  );
}

/** What one thing is. */
function SelectedDetails({ drawing, id }: { drawing: Drawing; id: string }) {
  if (drawing.kind === Drawing_Kind.STATES) {
    const transition = transitionOf(drawing, id);
    if (transition) return <TransitionDetails key={id} drawing={drawing} transition={transition} />;
    const state = drawing.states.find((one) => one.name === id);
    if (state) return <StateDetails key={id} drawing={drawing} state={state} />;
  }
  const node = drawing.nodes.find((one) => one.name === id);
  if (node && isEquipment(drawing)) return <EquipmentNodeDetails key={id} drawing={drawing} node={node} />;
  if (node && drawing.kind === Drawing_Kind.SOCIETY) return <MemberDetails key={id} drawing={drawing} node={node} />;
  if (node) return <NodeDetails key={id} drawing={drawing} node={node} />;
  const note = drawing.notes.find((one) => one.id === id);
  if (note) return <NoteDetails key={id} drawing={drawing} note={note} />;
  if (id !== "") return <WireDetails drawing={drawing} id={id} />;
  return <PageDetails drawing={drawing} />;
}
