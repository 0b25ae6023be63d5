// No overlay is open: begin one.
import { useState } from "react";
import { NewDocument_Kind } from "../../core/protocol.ts";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { order } from "../map_editing/edit_map.ts";
import { useMayOrder, usePart, useSession } from "../session/session.ts";

export function NewOverlay() {
  const session = useSession();
  const mayOrder = useMayOrder();
  const hasMission = (usePart("project")?.mission ?? "") !== "";
  const [path, setPath] = useState(hasMission ? "map.odl" : "mission.mdl");
  const create = () => {
    const kind = hasMission ? NewDocument_Kind.OVERLAY : NewDocument_Kind.MISSION;
    void order(session, { case: "newDocument", value: { kind, path: path.trim() } }, `create ${path.trim()}`);
  };
  return (
    <div className="overlay">
      <p className="help">
        {hasMission
          ? "This mission has no overlay yet. Begin an empty one and draw on it."
          : "Begin a mission with an empty overlay beside it, and draw on that."}
      </p>
      <Field
        label={hasMission ? "Overlay file" : "Mission file"}
        value={path}
        onChange={setPath}
        isDisabled={!mayOrder}
      />
      <div>
        <Button tone="primary" isDisabled={!mayOrder || path.trim() === ""} onPress={create}>
          Create
        </Button>
      </div>
    </div>
  );
}
