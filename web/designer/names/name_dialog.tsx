// Another name: as it is typed, what it would change is shown.
import { useEffect, useState } from "react";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { useDesigner, usePart } from "../session/use.ts";
import type { NameAt } from "./at.ts";
import { goToText } from "./go.ts";
import { PlanView } from "./plan_view.tsx";
import { carryOut, planRenaming, type RenamingPlan } from "./rename.ts";

interface NameDialogProps {
  at: NameAt;
  /** As it is called now. */
  first: string;
  /** What stands in the field at first. */
  name?: string;
  /** Why it is no name at all; nothing: it may be one. */
  wrong: (name: string) => string | undefined;
  /** For what has no name of its own yet. Gives what is wrong; empty: done. */
  local?: (name: string) => Promise<string>;
  /** It is about to be done. */
  began?: () => void;
  /** It is done. */
  done?: (name: string) => void;
}

const kPause = 120; // behind a letter [ms]

/** The name as it is typed, what it would change, and how it is done. */
function useNewName({ at, first, name = first, wrong, local, began, done }: NameDialogProps) {
  const designer = useDesigner();
  const [value, setValue] = useState(name);
  const [problem, setProblem] = useState("");
  const found = usePlanned(at, value !== first && wrong(value) === undefined ? value : "");
  const close = () => designer.store.setState({ dialog: "", renaming: null });
  const finish = (error: string) => {
    setProblem(error);
    if (error !== "") return;
    close();
    done?.(value);
  };
  return {
    value,
    problem,
    found,
    close,
    type: (next: string) => {
      setValue(next);
      setProblem("");
    },
    go: async () => {
      if (value === first) return close();
      if (wrong(value) !== undefined) return;
      const now = found ?? (await planRenaming(designer, at, value));
      began?.();
      if (now.is === "local" && local) finish(await local(value));
      else if (now.is === "plan") finish(await carryOut(designer, at, now.plan));
    },
  };
}

export function NameDialog(props: NameDialogProps) {
  const designer = useDesigner();
  const { first, wrong } = props;
  const { value, problem, found, close, type, go } = useNewName(props);
  const refused = found?.is === "refused" ? found : undefined;
  return (
    <DialogBox
      title={`Rename ${first}`}
      onClose={close}
      width={560}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
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
          onChange={type}
          problem={told(problem || refused?.why) ?? (value === "" ? undefined : wrong(value))}
          autoFocus
        />
      </form>
      {refused?.place && (
        <Button
          tone="link"
          onPress={() => {
            close();
            void goToText(designer, refused.place!);
          }}
        >
          Show what is in the way
        </Button>
      )}
      {found?.is === "plan" && <PlanView plan={found.plan} />}
      {found?.is === "local" && (
        <p className="small muted">
          It gets a name of its own. Where it draws random numbers it draws others then: runs with the same seed come
          out differently.
        </p>
      )}
    </DialogBox>
  );
}

function told(why: string | undefined): string | undefined {
  return why ? sentence(why, withoutBackticks) : undefined;
}

/** Of the name as it stands; nothing while that is not known yet. */
function usePlanned(at: NameAt, name: string): RenamingPlan | undefined {
  const designer = useDesigner();
  const [known, setKnown] = useState<{ name: string; found: RenamingPlan } | undefined>();
  const key = JSON.stringify(at);
  useEffect(() => {
    if (name === "") return;
    let isOld = false;
    const timer = setTimeout(async () => {
      const found = await planRenaming(designer, JSON.parse(key) as NameAt, name);
      if (!isOld) setKnown({ name, found });
    }, kPause);
    return () => {
      isOld = true;
      clearTimeout(timer);
    };
  }, [designer, key, name]);
  return known?.name === name ? known.found : undefined;
}

/** Of what the text names, or of a name that was given in a field. */
export function RenameNameDialog({ wrong }: Pick<NameDialogProps, "wrong">) {
  const renaming = usePart((state) => state.renaming);
  if (!renaming) return null;
  return (
    <NameDialog
      at={renaming.at}
      first={renaming.first}
      wrong={wrong}
      {...(renaming.name ? { name: renaming.name } : {})}
    />
  );
}
