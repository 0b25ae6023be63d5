// Where something is named in the project, below the drawing.
import { Uses } from "../../ui/names/use_list.tsx";
import { useDesigner, usePart } from "../session/use.ts";
import { goToText } from "./go.ts";

export function UsesPanel() {
  const designer = useDesigner();
  const uses = usePart((state) => state.uses);
  if (!uses) return null;
  return (
    <Uses
      uses={uses}
      className="dock bottom"
      goTo={(place) => void goToText(designer, place)}
      onClose={() => designer.store.setState({ uses: null })}
    />
  );
}
