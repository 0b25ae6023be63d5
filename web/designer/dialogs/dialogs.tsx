// Small dialogs about what is on the page: names, new declarations, parameters, groups.
import { type ReactNode, useRef, useState } from "react";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { drawnAt } from "../names/at.ts";
import { NameDialog } from "../names/name_dialog.tsx";
import { useClosedWithout, useFollowing } from "../session/follow.ts";
import { lastPart } from "../session/pages.ts";
import type { Drawing } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { transitionOf } from "../states/flow.ts";
import { isNoTrigger, triggerText, triggerWords } from "../states/trigger_words.ts";
import { cdlName } from "./names.ts";

interface AskProps {
  title: string;
  label: string;
  first: string;
  button: string;
  help?: string;
  isFree?: boolean;
  /** Above the field. */
  children?: ReactNode;
  /** Gives what is wrong; nothing: done. */
  done: (value: string) => Promise<string>;
}

export function Ask({ title, label, first, button, help, isFree = false, children, done }: AskProps) {
  const designer = useDesigner();
  const [value, setValue] = useFollowing(first);
  const [problem, setProblem] = useState<string | undefined>();
  const close = () => designer.store.setState({ dialog: "" });
  const wrong = isFree ? undefined : cdlName(value);
  const go = async () => {
    if (wrong) return;
    const error = await done(value.trim());
    if (error) setProblem(error);
    else close();
  };
  return (
    <DialogBox
      title={title}
      onClose={close}
      width={420}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone="primary" isDisabled={wrong !== undefined} onPress={() => void go()}>
            {button}
          </Button>
        </>
      }
    >
      {children}
      {/* Enter in the field is the button's. */}
      <form
        onSubmit={(event) => {
          event.preventDefault();
          void go();
        }}
      >
        <Field
          label={label}
          value={value}
          onChange={(next) => {
            setValue(next);
            setProblem(undefined);
          }}
          problem={problem ?? (value === "" ? undefined : wrong)}
          autoFocus
          {...(help ? { help } : {})}
        />
      </form>
    </DialogBox>
  );
}

export function RenameDialog() {
  const designer = useDesigner();
  const drawing = useDrawing();
  const node = usePart((state) => state.subject);
  const page = usePart((state) => state.page);
  const transition = drawing && transitionOf(drawing, node);
  const isThere = !drawing || transition !== undefined || isOn(drawing, node);
  const isOurs = useRef(false); // what is renamed here is not lost
  useClosedWithout(isThere || isOurs.current, lastPart(node));
  if (transition) {
    return (
      <Ask
        title={`Transition from ${transition.from} to ${transition.to}`}
        label="When"
        first={isNoTrigger(transition.trigger) ? "" : triggerWords(transition.trigger)}
        button="Set"
        isFree
        done={async (typed) => {
          const trigger = triggerText(typed);
          const { from, index } = transition;
          isOurs.current = true;
          const answer = await designer.link.ask(
            editOf(designer, `trigger of ${from}`, { case: "setTransition", value: { page, from, index, trigger } }),
          );
          return answer.error;
        }}
      />
    );
  }
  return (
    <NameDialog
      at={drawnAt(designer, node)}
      first={lastPart(node)}
      wrong={cdlName}
      local={async (name) => {
        isOurs.current = true;
        const answer = await designer.link.ask(editOf(designer, "", { case: "rename", value: { page, node, name } }));
        isOurs.current = answer.ok;
        return answer.error;
      }}
      began={() => {
        isOurs.current = true;
      }}
      done={(name) => designer.select([name])}
    />
  );
}

function isOn({ nodes, states }: Drawing, name: string): boolean {
  return [...nodes, ...states].some((one) => one.name === name);
}

const kNaming = "Begins with a capital, as Wander or ForageTeam.";
const kKinds: Record<string, readonly [title: string, help: string]> = {
  assemblage: ["an assemblage", kNaming],
  robot: ["a robot", kNaming],
  society: ["a society", kNaming],
  class: ["a class of robots", "Begins with a capital, as Cart or Scout."],
  operator: ["an operator of societies", "Begins with a capital, as DistinctTargets."],
  binding: ["a binding point", "In small letters, as sense_water."],
};

/** The subject is the kind; for a class, perhaps with the robot that is to be of it: `class Forager`. */
export function DeclarationDialog() {
  const designer = useDesigner();
  const [kind = "", robot = ""] = usePart((state) => state.subject).split(" ");
  const [title, help] = kKinds[kind] ?? [kind, kNaming];
  return (
    <Ask
      title={robot ? `Make a class for ${robot}` : `Add ${title}`}
      label="Name"
      first={robot ? `${robot}Body` : ""}
      button="Add"
      help={robot ? `It gets a device for all that ${robot} asks for, as far as the library has one.` : help}
      done={async (name) => {
        const answer = await designer.link.ask(
          editOf(designer, `add ${kind} ${name}`, { case: "addDeclaration", value: { kind, name, robot } }),
        );
        if (answer.ok) designer.navigation.goTo(designer.state.document, name);
        return answer.error;
      }}
    />
  );
}

export function editOf(
  designer: ReturnType<typeof useDesigner>,
  name: string,
  ...changes: Parameters<typeof designer.edit>[1][]
) {
  return {
    case: "edit" as const,
    value: {
      document: designer.state.document,
      revision: designer.drawing?.revision ?? 0n,
      name,
      changes: changes.map((change) => ({ change })),
    },
  };
}
