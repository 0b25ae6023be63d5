import { CommandLine } from "../command/command_line.tsx";
import { panels } from "../extensions/extensions.ts";
import { panelsIn } from "../session/layout.ts";
import { useLayout } from "../session/session.ts";
import { PanelButton } from "./dock.tsx";

/** The lower edge: buttons of the drawer, and the command line. */
export function Strip() {
  const layout = useLayout();
  return (
    <footer className="strip">
      <nav className="tabs" aria-label="Panels of the drawer">
        {panelsIn(layout, panels, "bottom").map((panel) => (
          <PanelButton key={panel.id} panel={panel} className="button quiet" />
        ))}
      </nav>
      <CommandLine />
    </footer>
  );
}
