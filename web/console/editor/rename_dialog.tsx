// Another name for what stands at the cursor of the text.
import { NameBox } from "../../ui/names/name_box.tsx";
import { useSession, useUi } from "../session/session.ts";
import { carryOut, goTo, planRenaming } from "./names.ts";

export function RenameDialog() {
  const session = useSession();
  const renaming = useUi("renaming");
  if (!renaming) return null;
  const { at, first } = renaming;
  return (
    <NameBox
      first={first}
      wrong={(name) => (name.trim() === "" ? "A name has at least one letter." : undefined)}
      plan={(name) => planRenaming(session, at, name)}
      carryOut={(plan) => carryOut(session, at, plan)}
      show={(place) => void goTo(session, place)}
      onClose={() => {
        session.ui.set("dialog", "");
        session.ui.set("renaming", null);
      }}
    />
  );
}
