// A parameter of the page that is shown, added or changed.
import { useRef, useState } from "react";
import { kParameterTypeNames } from "../../core/value_types.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { drawnAt } from "../names/at.ts";
import { renameNow } from "../names/rename.ts";
import { useClosedWithout, useFollowing } from "../session/follow.ts";
import type { Parameter } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { editOf } from "./dialogs.tsx";
import { cdlName } from "./names.ts";

/** What stands in the fields; it follows the drawing until somebody types. */
function useFields(before: Parameter | undefined) {
  const [name, setName] = useFollowing(before?.name ?? "");
  const [type, setType] = useFollowing(before?.type ?? "gain");
  const [initial, setInitial] = useFollowing(before?.initial ?? "");
  const [low, setLow] = useFollowing(before?.min === undefined ? "" : String(before.min));
  const [high, setHigh] = useFollowing(before?.max === undefined ? "" : String(before.max));
  const [help, setHelp] = useFollowing(before?.help ?? "");
  return {
    typed: { name, type, initial, low, high, help },
    setters: { setName, setType, setInitial, setLow, setHigh, setHelp },
  };
}

export function ParameterDialog() {
  const designer = useDesigner();
  const drawing = useDrawing();
  const subject = usePart((state) => state.subject);
  const before = drawing?.parameters.find((one) => one.name === subject);
  const { typed, setters } = useFields(before);
  const { name } = typed;
  const isOurs = useRef(false); // what is renamed here is not lost
  useClosedWithout(subject === "" || before !== undefined || isOurs.current, subject);
  const [problem, setProblem] = useState("");
  const close = () => designer.store.setState({ dialog: "" });
  const save = async () => {
    if (cdlName(name) !== undefined) return;
    isOurs.current = true;
    const owner = drawing?.page?.path ?? "";
    const now = before?.name ?? name;
    const answer = await designer.link.ask(
      editOf(designer, before ? `change parameter ${now}` : `add parameter ${name}`, {
        case: "setParameter" as const,
        value: { owner, ...typed, name: now },
      }),
    );
    isOurs.current = answer.ok;
    if (!answer.ok) return setProblem(answer.error);
    close();
    // Its name may stand in other files as well.
    if (now !== name) await renameNow(designer, { ...drawnAt(designer, now), page: owner }, name, () => {});
  };
  return (
    <DialogBox
      title={before ? `Parameter ${before.name}` : "Add a parameter"}
      onClose={close}
      width={460}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone="primary" isDisabled={cdlName(name) !== undefined} onPress={() => void save()}>
            {before ? "Change" : "Add"}
          </Button>
        </>
      }
    >
      {/* Enter in a field is the button's. */}
      <form
        className="rows"
        onSubmit={(event) => {
          event.preventDefault();
          void save();
        }}
      >
        {problem && <p className="notice danger">{problem}</p>}
        <Fields typed={typed} setters={setters} />
        <input type="submit" hidden />
      </form>
    </DialogBox>
  );
}

function Fields({ typed, setters }: ReturnType<typeof useFields>) {
  const { name, type, initial, low, high, help } = typed;
  const types = kParameterTypeNames.includes(type) ? kParameterTypeNames : [type, ...kParameterTypeNames];
  return (
    <>
      <Field
        label="Name"
        value={name}
        onChange={setters.setName}
        problem={name === "" ? undefined : cdlName(name)}
        autoFocus
      />
      <Choice label="Type" value={type} choices={types.map((one) => [one, one])} onChange={setters.setType} />
      <Field
        label="Default"
        value={initial}
        onChange={setters.setInitial}
        help="Without one it has to be given wherever the assemblage is used."
      />
      <div className="columns even">
        <Field label="Least" value={low} onChange={setters.setLow} />
        <Field label="Most" value={high} onChange={setters.setHigh} />
      </div>
      <Field label="What it is for" value={help} onChange={setters.setHelp} />
    </>
  );
}
