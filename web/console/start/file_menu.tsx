import { Button } from "../../ui/controls/controls.tsx";
import { MenuButton } from "../../ui/controls/menus.tsx";
import { shownPath, shownTitle } from "../../ui/files/paths.ts";
import { openMission, save } from "../session/orders.ts";
import { useMayOrder, usePart, useSession } from "../session/session.ts";

export function FileMenu() {
  const session = useSession();
  const project = usePart("project");
  const edits = usePart("edits");
  const mayOrder = useMayOrder();
  const set = (dialog: "open" | "new" | "save-as" | "shortcuts") => () => session.ui.set("dialog", dialog);
  const hasMission = (project?.mission ?? "") !== "";
  const files = (entries: readonly { path: string; title: string }[], prefix: string) =>
    entries.map((entry) => ({
      id: `${prefix}${entry.path}`,
      label: shownTitle(entry),
      detail: shownPath(entry.path),
      isDisabled: !mayOrder,
      run: () => void openMission(session, entry.path),
    }));
  return (
    <MenuButton
      label="File"
      trigger={<Button tone="quiet" icon="menu" className="square" aria-label="File menu" />}
      groups={[
        {
          entries: [
            { id: "new", label: "New mission…", icon: "file", isDisabled: !mayOrder, run: set("new") },
            {
              id: "open",
              label: "Open…",
              icon: "folder",
              shortcut: "Ctrl O",
              isDisabled: !mayOrder,
              run: set("open"),
            },
            {
              id: "save",
              label: "Save",
              icon: "save",
              shortcut: "Ctrl S",
              isDisabled: !mayOrder || !hasMission || !edits?.isDirty,
              run: () => save(session),
            },
            {
              id: "save-as",
              label: "Save as…",
              icon: "save",
              shortcut: "Ctrl Shift S",
              isDisabled: !mayOrder || !hasMission,
              run: set("save-as"),
            },
          ],
        },
        ...(project && project.recent.length > 0
          ? [{ title: "Recent", entries: files(project.recent.slice(0, 5), "r:") }]
          : []),
        ...(project && project.examples.length > 0
          ? [{ title: "Examples", entries: files(project.examples, "e:") }]
          : []),
        {
          entries: [
            {
              id: "report",
              label: "Report of the run",
              icon: "log",
              isDisabled: !hasMission,
              run: () => window.open(session.connection.url("/report"), "_blank", "noopener"),
            },
            { id: "shortcuts", label: "Keyboard shortcuts", shortcut: "?", run: set("shortcuts") },
          ],
        },
      ]}
    />
  );
}
