// Drawing wires and transitions: which inputs fit, asked of the server while the wire is drawn; what the end of it means.

import { portOf, rowId } from "../drawing/form.ts";
import type { Designer } from "../session/designer.ts";
import { type ChangeInit, type FitList, kResult } from "../session/protocol.ts";
import { canvasStore } from "./canvas_store.ts";

/** Asks which inputs a wire from this output may lead to. */
export async function askFits(
  designer: Designer,
  from: { node?: string; to?: { node: string; row: string } },
): Promise<void> {
  const { document, page } = designer.state;
  const to = from.to ? { toNode: from.to.node, toPort: portOf(from.to.row).port } : {};
  canvasStore.setState({ fits: new Map() });
  const answer = await designer.link.ask({
    case: "fits",
    value: { document, page, ...(from.node ? { fromNode: from.node } : {}), ...to },
  });
  if (canvasStore.getState().fits === null) return; // let go meanwhile
  if (answer.result.case === "fits") canvasStore.setState({ fits: fitKeys(answer.result.value) });
}

/** By `node/port[index]`, or by node where the wire is drawn backwards. */
export function fitKeys(list: FitList): Map<string, string> {
  return new Map(
    list.fits.map((fit) => [fit.port === "" ? fit.node : `${fit.node}/${rowId(fit.port, fit.index)}`, fit.reason]),
  );
}

export function stopFits(): void {
  if (canvasStore.getState().fits !== null) canvasStore.setState({ fits: null });
}

/** Why a wire from here can't lead there; empty: it can, as far as is known. */
export function reasonAgainst(source: string, target: string, row: string): string {
  const { fits } = canvasStore.getState();
  const onResult = target === kResult ? fits?.get(kResult) : undefined;
  return fits?.get(`${target}/${row}`) ?? onResult ?? fits?.get(source) ?? "";
}

export function connectChange(page: string, from: string, to: string, row: string): ChangeInit {
  const { port, index } = portOf(row);
  const toPort = to.startsWith("$") ? "" : port;
  return {
    case: "connect",
    value: { page, fromNode: from, toNode: to, toPort, ...(index === undefined ? {} : { index }) },
  };
}

export function disconnectChange(page: string, to: string, row: string): ChangeInit {
  const { port, index } = portOf(row);
  const toPort = to.startsWith("$") ? "" : port;
  return { case: "disconnect", value: { page, toNode: to, toPort, ...(index === undefined ? {} : { index }) } };
}

/** The node and row of a wire's id. */
export function endOf(wire: string): { node: string; row: string } {
  if (wire === kResult) return { node: wire, row: "value" };
  const at = wire.indexOf("/");
  return { node: wire.slice(0, at), row: wire.slice(at + 1) };
}
