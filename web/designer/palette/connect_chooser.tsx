// Connecting by keyboard: the inputs of the page that the selected node's output fits.
import { useEffect, useState } from "react";
import { type Choice, Chooser } from "../../ui/commands/chooser.tsx";
import { ranked } from "../../ui/commands/search.ts";
import { rowId } from "../drawing/form.ts";
import { inputName } from "../drawing/input_name.ts";
import { lastPart } from "../session/pages.ts";
import { Drawing_Kind, type FitList_Fit } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { connectChange } from "../sight/wiring.ts";
import { addTransition } from "../states/trigger.ts";

export function ConnectChooser() {
  const designer = useDesigner();
  const drawing = useDrawing();
  const node = usePart((state) => state.subject);
  const [fits, setFits] = useState<readonly FitList_Fit[] | null>(null);
  const isStates = drawing?.kind === Drawing_Kind.STATES;
  useEffect(() => {
    if (isStates) return;
    let isCurrent = true;
    const { document, page } = designer.state;
    void designer.link.ask({ case: "fits", value: { document, page, fromNode: node } }).then((answer) => {
      if (isCurrent) setFits(answer.result.case === "fits" ? answer.result.value.fits : []);
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, node, isStates]);
  const choices: Choice[] = isStates
    ? (drawing?.states ?? []).map((state) => ({
        id: state.name,
        label: state.name,
        detail: state.title || state.member,
      }))
    : (fits ?? []).map((fit) => {
        const row = rowId(fit.port, fit.index);
        const isResult = fit.node.startsWith("$");
        return {
          id: isResult ? fit.node : `${fit.node}/${row}`,
          label: isResult ? "Result of the page" : inputName(drawing, fit.node, row),
          ...(fit.reason ? { blocked: fit.reason } : {}),
        };
      });
  const sorted = [...choices].sort((a, b) => Number(a.blocked !== undefined) - Number(b.blocked !== undefined));
  const connect = (id: string) => {
    const { page } = designer.state;
    if (isStates) {
      void addTransition(designer, node, id);
      return;
    }
    const at = id.indexOf("/");
    const [to, row] = at < 0 ? [id, ""] : [id.slice(0, at), id.slice(at + 1)];
    void designer.edit("", connectChange(page, node, to, row));
  };
  return (
    <Chooser
      title={isStates ? `Transition from ${node} to` : `Connect ${lastPart(node)} to`}
      placeholder={isStates ? "To which state?" : "Which input?"}
      find={(query) => ranked(query, sorted, (choice) => choice.label)}
      onChoose={connect}
      onClose={() => designer.store.setState({ dialog: "" })}
      empty={fits === null && !isStates ? "Asking…" : "There is no input that it could lead to."}
    />
  );
}
