// Another name for what is drawn, or for what the text names.
import { NameBox } from "../../ui/names/name_box.tsx";
import { useDesigner, usePart } from "../session/use.ts";
import type { NameAt } from "./at.ts";
import { goToText } from "./go.ts";
import { carryOut, planRenaming } from "./rename.ts";

interface NameDialogProps {
  at: NameAt;
  first: string;
  name?: string;
  wrong: (name: string) => string | undefined;
  local?: (name: string) => Promise<string>;
  began?: () => void;
  done?: (name: string) => void;
}

/** As NameBox. */
export function NameDialog({ at, ...rest }: NameDialogProps) {
  const designer = useDesigner();
  return (
    <NameBox
      {...rest}
      plan={(name) => planRenaming(designer, at, name)}
      carryOut={(plan) => carryOut(designer, at, plan)}
      show={(place) => void goToText(designer, place)}
      onClose={() => designer.store.setState({ dialog: "", renaming: null })}
      aboutLocal={
        <p className="small muted">
          It gets a name of its own. Where it draws random numbers it draws others then: runs with the same seed come
          out differently.
        </p>
      }
    />
  );
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
