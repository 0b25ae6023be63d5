import { Button } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { passOperator } from "../session/orders.ts";
import { usePart, useSession } from "../session/session.ts";
import { nameOfClient } from "./names.ts";

export function HandOverDialog() {
  const session = useSession();
  const clients = usePart("clients");
  const own = usePart("welcome")?.client;
  const others = clients?.clients.filter((client) => client.isConnected && client.id !== own) ?? [];
  const close = () => session.ui.set("dialog", "");
  return (
    <DialogBox title="Hand over control" onClose={close} width={420}>
      {others.length === 0 && <p>Nobody else looks at this session. Whoever opens its address can take part.</p>}
      {others.map((client) => (
        <Button
          key={client.id}
          onPress={() => {
            passOperator(session, client.id);
            close();
          }}
        >
          {nameOfClient(client)} becomes the operator
        </Button>
      ))}
    </DialogBox>
  );
}
