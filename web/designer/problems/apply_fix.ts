// Mends the text as a problem offers it: one step of undo for each splice, the last one first so that places hold.
import type { Designer } from "../session/designer.ts";
import type { Fix } from "../session/protocol.ts";

/** What its button says: what the server calls it, as a person would write it. */
export function fixTitle(fix: Fix): string {
  const plain = fix.title.replaceAll(/`([^`]*)`/g, "“$1”").trim();
  return plain === "" ? "Mend it" : plain[0]!.toUpperCase() + plain.slice(1);
}

export async function applyFix(designer: Designer, fix: Fix): Promise<void> {
  const document = designer.document;
  if (!document || fix.splices.length === 0) return;
  const merged = mergeSplices(document.text, fix.splices);
  const answer = await designer.ask({
    case: "editText",
    value: { document: document.path, revision: document.revision, name: fix.title, ...merged },
  });
  if (answer.ok) designer.say(fixTitle(fix));
}

interface Splice {
  begin: number;
  end: number;
  text: string;
}

/** Several splices as one, what stands between them with it. Places are bytes of UTF-8. */
export function mergeSplices(text: string, splices: readonly Splice[]): Splice {
  const bytes = new TextEncoder().encode(text);
  const sorted = [...splices].sort((a, b) => a.begin - b.begin);
  const decoder = new TextDecoder();
  let merged = "";
  let at = sorted[0]!.begin;
  for (const { begin, end, text: added } of sorted) {
    merged += decoder.decode(bytes.subarray(at, begin)) + added;
    at = Math.max(at, end);
  }
  return { begin: sorted[0]!.begin, end: at, text: merged };
}
