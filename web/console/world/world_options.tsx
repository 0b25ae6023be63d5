// What the world tool does, over the map while it is held.
import { useStore } from "zustand";
import { Segments } from "../../ui/controls/controls.tsx";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";

const kHelp = {
  change: "Drag to move, drag the square to resize, Delete removes.",
  obstacle: "Click to add an obstacle, drag to set its size. Esc ends.",
  object: "Click to add an object, drag to set its size. Esc ends.",
};

export function WorldOptions() {
  const { world } = useStore(editStore);
  return (
    <>
      <Segments
        label="World"
        value={world}
        choices={[
          ["change", "Change"],
          ["obstacle", "Add obstacle"],
          ["object", "Add object"],
        ]}
        onChange={(what) => changeEditing({ world: what })}
      />
      <span className="small muted">{kHelp[world]}</span>
    </>
  );
}
