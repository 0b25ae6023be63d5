// Where something is named in the project, below the text.
import { Uses } from "../../ui/names/use_list.tsx";
import { useSession, useUi } from "../session/session.ts";
import { goTo } from "./names.ts";

export function UsesBelow() {
  const session = useSession();
  const uses = useUi("uses");
  if (!uses) return null;
  if (uses.is === "asking") {
    return (
      <p className="uses-asking small muted" role="status">
        Looking for {uses.word} in all files of the project…
      </p>
    );
  }
  return (
    <>
      <span className="hidden-text" role="status">
        {uses.list.name}: {uses.places} places
      </span>
      <Uses
        uses={uses.list}
        className="below"
        goTo={(place) => void goTo(session, place)}
        onClose={() => session.ui.set("uses", null)}
      />
    </>
  );
}
