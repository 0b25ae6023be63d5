// What an input is called in lists: as it is written on the canvas.
import { lastPart } from "../session/pages.ts";
import type { Drawing } from "../session/protocol.ts";
import { wiredInputsOf } from "./flow.ts";
import { formOf, portOf } from "./form.ts";

/** `cooperate · member 2`, `cooperate · weight of member 2`; with its whole path where several are called the same. */
export function inputName(drawing: Drawing | undefined, node: string, row: string): string {
  const found = drawing?.nodes.find((one) => one.name === node);
  if (!drawing || !found) return `${lastPart(node)} · ${row}`;
  const { title, rows } = formOf(found, wiredInputsOf(drawing));
  const isAlone = drawing.nodes.filter((one) => lastPart(one.name) === lastPart(node)).length === 1;
  const name = isAlone ? title : node;
  const shown = rows.find((one) => one.id === row);
  if (shown?.kind === "more") return `${name} · ${row === "members" ? "a new member" : `${row}, one more`}`;
  if (shown) return `${name} · ${shown.label}`;
  const { port, index } = portOf(row);
  if (index === undefined) return `${name} · ${port.replaceAll("_", " ")}`;
  const member = rows.find((one) => one.port.isMember && one.port.index === index);
  return `${name} · ${port.replaceAll("_", " ")} of ${member?.label ?? `member ${index + 1}`}`;
}
