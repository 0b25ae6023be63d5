// Who is the operator.
import { passOperator, takeOperator } from "../session/orders.ts";
import type { ActionTable } from "../session/registry.ts";
import type { Session } from "../session/session.ts";

export const kPeopleTable: ActionTable = {
  group: "People",
  rows: [
    {
      id: "take-control",
      label: "Take control",
      icon: "hand",
      unless: [({ model }) => (model.isOperator() ? "You are the operator." : undefined)],
      run: (session) => takeOperator(session),
    },
    {
      id: "hand-over",
      label: "Hand over control…",
      icon: "person",
      unless: [({ model }) => (model.isOperator() ? undefined : "You are not the operator.")],
      run: ({ ui }) => ui.set("dialog", "hand-over"),
    },
  ],
};

/** What is answered to who asks for the operator's place: to him whose name is shown, and to nobody who came later. */
export function requestTable({ model }: Session): ActionTable {
  const clients = model.get("clients");
  const asks = clients?.clients.find((client) => client.id === clients.asks);
  if (!asks || !model.isOperator()) return { group: "People", rows: [] };
  const name = asks.name || `browser ${asks.id}`;
  return {
    group: "People",
    rows: [
      {
        id: "give-control",
        label: `Give control to ${name}`,
        icon: "check",
        run: (session) => passOperator(session, asks.id),
      },
      {
        id: "decline-control",
        label: `Decline the request of ${name}`,
        icon: "close",
        run: (session) => passOperator(session, 0),
      },
    ],
  };
}
