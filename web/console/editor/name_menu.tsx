// What can be asked about the name at the cursor, without a keyboard.
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { MenuButton } from "../../ui/controls/menus.tsx";
import { useMayOrder, useSession } from "../session/session.ts";
import { nameActions } from "./names.ts";

export function NameMenu() {
  const session = useSession();
  const mayOrder = useMayOrder();
  return (
    <MenuButton
      label="The name at the cursor"
      trigger={
        <Button tone="quiet" className="square" aria-label="The name at the cursor">
          <Icon name="more" />
        </Button>
      }
      groups={[
        {
          entries: nameActions(session).map(({ id, label, icon, shortcut, run }) => ({
            id,
            label,
            ...(icon ? { icon } : {}),
            shortcut: shownShortcut(shortcut ?? ""),
            isDisabled: id === "rename" && !mayOrder,
            run,
          })),
        },
      ]}
    />
  );
}
