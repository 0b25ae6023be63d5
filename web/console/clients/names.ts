import type { Clients_Client } from "../../core/protocol.ts";

export function nameOfClient(client: Pick<Clients_Client, "id" | "name">): string {
  return client.name || `Browser ${client.id}`;
}
