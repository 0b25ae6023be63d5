// Buttons on the canvas: place, layout, camera.
import { shownShortcut } from "../../ui/commands/keys.ts";
import { IconButton } from "../../ui/controls/controls.tsx";
import { action } from "../actions/all_actions.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";

const kTools = ["place", "comment", "layout", "fit", "zoom-in", "zoom-out"] as const;

export function CanvasTools() {
  const designer = useDesigner();
  useDrawing();
  usePart((state) => state.selection);
  return (
    <div className="canvas-tools" role="toolbar" aria-label="Canvas" aria-orientation="vertical">
      {kTools.map((id) => {
        const one = action(designer, id);
        if (!one?.icon) return null;
        return (
          <IconButton
            key={id}
            icon={one.icon}
            label={one.label}
            isDisabled={one.blocked !== undefined}
            onPress={one.run}
            {...(one.shortcut ? { shortcut: shownShortcut(one.shortcut) } : {})}
          />
        );
      })}
    </div>
  );
}
