// Edits of the map go to the server, which changes the text of the overlay.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { MapChangeSchema, Order } from "../../core/protocol.ts";
import type { MapItem } from "../../core/selection.ts";
import type { Session } from "../session/session.ts";

export type MapChangeInit = MessageInitShape<typeof MapChangeSchema>;

/** Carries out one undoable edit. False, and told to the person, where it did not work. */
export async function editMap(
  session: Session,
  name: string,
  changes: readonly MapChangeInit[],
  document = "",
): Promise<boolean> {
  if (changes.length === 0) return true;
  return order(session, { case: "editMap", value: { name, changes: [...changes], document } }, name);
}

/** Sends what changes the map; tells the person where it is refused. */
export async function order(session: Session, what: Order, name: string): Promise<boolean> {
  const reply = await session.connection.ask(what);
  if (!reply.ok) {
    const why = reply.error || reply.diagnostics[0]?.message || "the server refused it";
    session.ui.tell(`Could not ${name}: ${why}`);
  }
  return reply.ok;
}

/** Takes things of the map away, whatever they are, as one edit. Those that can't be edited stay. */
export async function removeItems(session: Session, items: readonly MapItem[]): Promise<boolean> {
  const scene = session.model.get("scene");
  if (!scene) return false;
  const kept: MapItem[] = [];
  const changes: MapChangeInit[] = [];
  const names: string[] = [];
  for (const item of items) {
    const { index } = item;
    const thing = { measure: scene.measures, obstacle: scene.obstacles, object: scene.objects }[item.kind][index];
    if (!thing || thing.document === "") {
      kept.push(item);
      continue;
    }
    names.push(item.kind === "measure" ? scene.measures[index]?.name || "measure" : `${item.kind} ${index + 1}`);
    changes.push({ change: removal(item) });
  }
  if (changes.length === 0) {
    if (kept.length > 0) session.ui.tell("This is no part of an overlay, so it can’t be removed here.", "hold");
    return false;
  }
  return editMap(session, `remove ${names.length === 1 ? names[0] : `${names.length} things`}`, changes);
}

function removal({ kind, index }: MapItem): NonNullable<MapChangeInit["change"]> {
  if (kind === "measure") return { case: "removeMeasure", value: index };
  return kind === "obstacle" ? { case: "removeObstacle", value: index } : { case: "removeObject", value: index };
}
