// What the box for everything finds in the project: asked of the server, letter by letter.
import { useEffect, useState } from "react";
import type { Designer } from "../session/designer.ts";
import type { Component, Hit } from "../session/protocol.ts";
import { goToText } from "./go.ts";

const kMost = 40;

/** What the project has of a query. */
interface Hits {
  hits: readonly Hit[];
  /** What of the project was not looked at: a sentence. */
  leftOut: string;
}

const kNoHits: Hits = { hits: [], leftOut: "" };

/** Of the query, or of the one before while that is not answered. */
export function useHits(designer: Designer, query: string): Hits {
  const [hits, setHits] = useState(kNoHits);
  useEffect(() => {
    const wanted = query.trim();
    if (wanted === "") {
      setHits(kNoHits);
      return;
    }
    let isOld = false;
    const timer = setTimeout(async () => {
      const answer = await designer.link.ask({ case: "search", value: { query: wanted, most: kMost } });
      if (!isOld && answer.result.case === "hits") setHits(answer.result.value);
    }, 30);
    return () => {
      isOld = true;
      clearTimeout(timer);
    };
  }, [designer, query]);
  return hits;
}

/** `state of Forage` */
export function kindOfHit({ kind, within, detail }: Hit): string {
  const what = kind === "call" ? "used" : kind;
  if (within !== "") return `${what} in ${within}`;
  return detail !== "" && kind !== "file" ? `${what}, ${detail}` : what;
}

export function goToHit(designer: Designer, hit: Hit): void {
  if (!hit.canOpen) {
    designer.tell(`${hit.path}, line ${hit.line}: missions, overlays and procedures open in the console.`, "accent");
    return;
  }
  if (hit.kind === "file") void designer.navigation.open(hit.path);
  else void goToText(designer, { document: hit.path, begin: hit.begin, end: hit.end });
}

/** What of the library has the words in its name, its other names, or its help. */
export function helpOf({ title, name, aliases, help }: Component): string {
  return [title, name, ...aliases, help].join(" ");
}
