// Another name: as it is typed, what it would change is shown.
import { type ReactNode, useEffect, useRef, useState } from "react";
import type { Plan } from "../../core/names.ts";
import { Button, Field } from "../controls/controls.tsx";
import { DialogBox } from "../controls/menus.tsx";
import { sentence, withoutBackticks } from "../words/sentence.ts";
import { PlanView } from "./plan_view.tsx";
import type { RenamingPlan, TextPlace } from "./renaming.ts";

interface NameBoxProps {
  /** As it is called now. */
  first: string;
  /** What stands in the field at first. */
  name?: string;
  /** Why it is no name at all; nothing: it may be one. */
  wrong: (name: string) => string | undefined;
  /** Asks the server. */
  plan: (name: string) => Promise<RenamingPlan>;
  /** @returns what is wrong; empty: it is done */
  carryOut: (plan: Plan) => Promise<string>;
  /** For what has no name of its own yet. Gives what is wrong; empty: done. */
  local?: (name: string) => Promise<string>;
  /** What is said where it is `local`. */
  aboutLocal?: ReactNode;
  /** Goes to what is in the way. */
  show: (place: TextPlace) => void;
  /** It is about to be done. */
  began?: () => void;
  /** It is done. */
  done?: (name: string) => void;
  onClose: () => void;
}

const kPause = 120; // behind a letter [ms]

export function NameBox(props: NameBoxProps) {
  const { first, name = first, wrong, plan, carryOut, local, aboutLocal, show, began, done, onClose } = props;
  const [value, setValue] = useState(name);
  const [problem, setProblem] = useState("");
  const isOther = value !== first && wrong(value) === undefined;
  const found = usePlanned(plan, isOther ? value : "");
  const finish = (error: string) => {
    setProblem(error);
    if (error !== "") return;
    onClose();
    done?.(value);
  };
  const go = async () => {
    if (value === first) return onClose();
    if (wrong(value) !== undefined) return;
    const now = found ?? (await plan(value));
    began?.();
    if (now.is === "local" && local) finish(await local(value));
    else if (now.is === "plan") finish(await carryOut(now.plan));
  };
  const refused = found?.is === "refused" ? found : undefined;
  const place = refused?.place;
  return (
    <DialogBox
      title={`Rename ${first}`}
      onClose={onClose}
      width={560}
      footer={
        <>
          <Button onPress={onClose}>Cancel</Button>
          <Button tone="primary" isDisabled={wrong(value) !== undefined || !!refused} onPress={() => void go()}>
            Rename
          </Button>
        </>
      }
    >
      {/* Enter in the field is the button's. */}
      <form
        className="rows"
        onSubmit={(event) => {
          event.preventDefault();
          void go();
        }}
      >
        <Field
          label="Name"
          value={value}
          onChange={(next) => {
            setValue(next);
            setProblem("");
          }}
          problem={told(problem || refused?.why) ?? (value === "" ? undefined : wrong(value))}
          autoFocus
        />
      </form>
      {place && (
        <Button
          tone="link"
          onPress={() => {
            onClose();
            show(place);
          }}
        >
          Show what is in the way
        </Button>
      )}
      {isOther && !found && (
        <p className="small muted" role="status">
          Looking through the project…
        </p>
      )}
      {found?.is === "plan" && <PlanView plan={found.plan} />}
      {found?.is === "local" && aboutLocal}
    </DialogBox>
  );
}

function told(why: string | undefined): string | undefined {
  return why ? sentence(why, withoutBackticks) : undefined;
}

/** Of the name as it stands; nothing while that is not known yet. */
function usePlanned(plan: NameBoxProps["plan"], name: string): RenamingPlan | undefined {
  const [known, setKnown] = useState<{ name: string; found: RenamingPlan } | undefined>();
  const ask = useRef(plan);
  ask.current = plan;
  useEffect(() => {
    if (name === "") return;
    let isOld = false;
    const timer = setTimeout(async () => {
      const found = await ask.current(name);
      if (!isOld) setKnown({ name, found });
    }, kPause);
    return () => {
      isOld = true;
      clearTimeout(timer);
    };
  }, [name]);
  return known?.name === name ? known.found : undefined;
}
