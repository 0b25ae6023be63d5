import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { PopoverButton } from "../../ui/controls/menus.tsx";
import { usePart, useSession, useUi } from "../session/session.ts";
import { nameOfClient } from "./names.ts";
import { PeopleList } from "./people_list.tsx";

/** Who looks, and who is the operator. */
export function People() {
  const clients = usePart("clients");
  const welcome = usePart("welcome");
  const { model } = useSession();
  useUi("name");
  if (!clients || !welcome) return null;
  const isOperator = model.isOperator();
  const others = clients.clients.filter((client) => client.isConnected).length - 1;
  const holder = clients.clients.find((client) => client.id === clients.operator);
  const role = isOperator ? "Operator: you" : holder ? `Operator: ${nameOfClient(holder)}` : "No operator";
  return (
    <PopoverButton
      label="People"
      trigger={
        <Button tone="quiet" className={`people pill ${isOperator ? "go" : "accent"}`}>
          <Icon name={isOperator ? "person" : "lock"} />
          <span className="ellipsis" style={{ maxWidth: 140 }}>
            {role}
          </span>
          {others > 0 && <span className="number">+{others}</span>}
        </Button>
      }
    >
      <PeopleList />
    </PopoverButton>
  );
}
