// Finding an action by a few letters of it.

const kDirect = 500; // what a text has at least that contains the query as it is

/** Larger is better; 0: no match. Letters in order; beginnings of words and runs count more. */
export function score(query: string, text: string): number {
  const wanted = query.toLowerCase().replaceAll(/\s+/g, "");
  if (wanted === "") return 1;
  const lower = text.toLowerCase();
  const direct = lower.indexOf(query.toLowerCase().trim());
  if (direct >= 0) return 1000 - direct - lower.length / 100 + (isWordStart(lower, direct) ? 500 : 0);
  let points = 0;
  let at = -1;
  let run = 0;
  for (const letter of wanted) {
    const next = bestPlace(lower, letter, at + 1);
    if (next < 0) return 0;
    run = next === at + 1 ? run + 1 : 0;
    points += 1 + run * 2 + (isWordStart(lower, next) ? 6 : 0);
    at = next;
  }
  return points - lower.length / 100;
}

/** The best first; equal ones in the order they came. */
export function ranked<T>(query: string, items: readonly T[], textOf: (item: T) => string): T[] {
  const scored = items
    .map((item, place) => ({ item, place, points: score(query, textOf(item)) }))
    .filter(({ points }) => points > 0)
    .sort((a, b) => b.points - a.points || a.place - b.place);
  // Scattered letters only count where nothing has them in a row.
  const direct = scored.filter(({ points }) => points >= kDirect);
  return (direct.length > 0 ? direct : scored).map(({ item }) => item);
}

/** The next beginning of a word with this letter, where the rest would still be found; else the next place of it. */
function bestPlace(text: string, letter: string, from: number): number {
  const next = text.indexOf(letter, from);
  if (next < 0 || isWordStart(text, next) || next === from) return next;
  for (let at = next; at >= 0; at = text.indexOf(letter, at + 1)) {
    if (isWordStart(text, at)) return at;
  }
  return next;
}

function isWordStart(text: string, at: number): boolean {
  return at === 0 || /[^a-z0-9]/.test(text[at - 1] as string);
}
