// Where something is named.
import { placesIn } from "../../ui/names/renaming.ts";
import type { Designer } from "../session/designer.ts";
import type { NameAt } from "./at.ts";

/** Lists the places below the drawing. */
export async function showUses(designer: Designer, at: NameAt): Promise<void> {
  const answer = await designer.ask({ case: "findUses", value: { at } });
  if (!answer.ok || answer.result.case !== "uses") return;
  const uses = answer.result.value;
  designer.store.setState({ uses });
  designer.say(`${uses.name}: ${placesIn(uses)} places`);
}
