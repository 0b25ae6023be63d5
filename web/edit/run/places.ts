// A page is drawn once and may run in several places of a program: which of them the drawing shows.

import { Port_Role } from "../../core/protocol.ts";

/** What gives the page's own value has the path of the page. */
const kItself = ".";

/** Path of a port, or of a state; `live` as in a Drawing. */
export function joined(path: string, live: string): string {
  if (live === kItself) return path;
  return path === "" ? live : `${path}.${live}`;
}

/**
 * The one whose values are shown. The one that was chosen, while it is there; else one inside of what was shown before
 * (who goes from a state into what it calls stays with that state); else one that is active; else the first.
 */
export function choosePlace(
  places: readonly string[],
  { chosen, before, isActive }: { chosen: string; before: string; isActive: (place: string) => boolean },
): string | undefined {
  if (places.includes(chosen)) return chosen;
  const inside = before === "" ? [] : places.filter((place) => isWithin(place, before));
  const among = inside.length > 0 ? inside : places;
  return among.find(isActive) ?? among[0];
}

/** Whether a port stands in a place, or is its value. */
export function isWithin(port: string, place: string): boolean {
  return place === "" || port === place || port.startsWith(`${place}.`);
}

const kWitnesses = 8; // of each place

/**
 * Of each place, ports that tell whether it runs: its own value, or the first values inside. Where there is only one
 * place, nobody asks.
 */
export function witnessesOf(
  places: readonly string[],
  ports: readonly { readonly path: string; readonly role: Port_Role }[],
): Map<string, string[]> {
  const witnesses = new Map<string, string[]>();
  if (places.length < 2) return witnesses;
  const outputs = ports.filter(({ role }) => role === Port_Role.OUTPUT).map(({ path }) => path);
  for (const place of places) {
    const inside = outputs.filter((path) => isWithin(path, place));
    witnesses.set(place, inside.includes(place) ? [place] : inside.slice(0, kWitnesses));
  }
  return witnesses;
}

/** Where programs are not known by name: the paths below which most of what is drawn is found among the ports. */
export function guessPlaces(lives: readonly string[], ports: readonly string[]): string[] {
  const found = new Map<string, number>();
  const wanted = new Set(lives.filter((live) => live !== kItself));
  for (const port of ports) {
    for (const live of wanted) {
      if (port === live) found.set("", (found.get("") ?? 0) + 1);
      else if (port.endsWith(`.${live}`)) {
        const place = port.slice(0, -live.length - 1);
        found.set(place, (found.get(place) ?? 0) + 1);
      }
    }
  }
  const most = Math.max(0, ...found.values());
  return [...found].filter(([, count]) => count === most).map(([place]) => place);
}
