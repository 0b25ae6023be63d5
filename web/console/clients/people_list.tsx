import { useState } from "react";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { passOperator, takeOperator } from "../session/orders.ts";
import { usePart, useSession, useUi } from "../session/session.ts";
import { nameOfClient } from "./names.ts";

export function PeopleList() {
  const session = useSession();
  const { model } = session;
  const clients = usePart("clients");
  const own = usePart("welcome")?.client;
  const isOperator = model.isOperator();
  if (!clients) return null;
  const operator = clients.clients.find((client) => client.id === clients.operator);
  const hasAsked = clients.asks === own;
  return (
    <div className="rows" style={{ width: 300 }}>
      <ul className="rows" style={{ gap: 4 }}>
        {clients.clients.map((client) => (
          <li key={client.id} className="columns spread" style={{ minHeight: 28 }}>
            <span className={client.isConnected ? "" : "muted"}>
              {nameOfClient(client)}
              {client.id === own && <span className="muted"> (you)</span>}
              {!client.isConnected && <span className="small"> away</span>}
              {client.id === clients.asks && <span className="small"> asks for control</span>}
            </span>
            {client.id === clients.operator ? (
              <span className="pill go">Operator</span>
            ) : (
              isOperator &&
              client.isConnected && <Button onPress={() => passOperator(session, client.id)}>Hand over</Button>
            )}
          </li>
        ))}
      </ul>
      {!isOperator && (
        <Button tone="primary" isDisabled={hasAsked} onPress={() => takeOperator(session)}>
          {hasAsked ? "Asked; waits for an answer" : operator ? "Ask for control" : "Take control"}
        </Button>
      )}
      {isOperator && clients.asks !== 0 && (
        <Button onPress={() => passOperator(session, 0)}>Decline the request</Button>
      )}
      <OwnName />
    </div>
  );
}

function OwnName() {
  const { ui } = useSession();
  const stored = useUi("name");
  const [name, setName] = useState(stored);
  return (
    <Field
      label="Your name, for the others"
      value={name}
      onChange={setName}
      help={name !== stored ? "Press Enter to use it" : "Shown from the next connection on: reload the page"}
      onCommit={(value) => ui.set("name", value.trim().slice(0, 60))}
    />
  );
}
