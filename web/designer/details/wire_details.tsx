import { Button } from "../../ui/controls/controls.tsx";
import { wireId } from "../drawing/flow.ts";
import { typeWords } from "../drawing/value_words.ts";
import { type Drawing, kResult } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { disconnectChange, endOf } from "../sight/wiring.ts";
import { Heading } from "./parts.tsx";

export function WireDetails({ drawing, id }: { drawing: Drawing; id: string }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const wire = drawing.wires.find((one) => (one.to === kResult ? kResult : wireId(one)) === id);
  const from = wire?.from ?? (id === kResult ? drawing.resultNode : "");
  if (from === "") return <p className="empty small">It is not there any more.</p>;
  const { node, row } = endOf(id);
  const to = node === kResult ? "the result of the page" : `${row} of ${node}`;
  return (
    <div className="details">
      <Heading name="Wire" kind={wire ? typeWords(wire.type, wire.unit) : drawing.resultType} />
      <p className="small">
        From <b>{from}</b> to <b>{to}</b>.
      </p>
      {wire?.isActive && <p className="small muted">It leads to the part that moves a sensor.</p>}
      {!isReadOnly && (
        <Button
          icon="close"
          onPress={() => void designer.edit("", disconnectChange(drawing.page?.path ?? "", node, row))}
        >
          Disconnect
        </Button>
      )}
    </div>
  );
}
