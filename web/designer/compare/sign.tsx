// What became of something since another version: a sign at its corner, and below it what was changed.
import { DifferenceKind, type PageDifference_Mark } from "../session/protocol.ts";
import { detailWords, isGhost, kindSign, kindWord, useCount, useMark } from "./compared.ts";

/** The class of something drawn. */
export function useDifferenceClass(name: string): string {
  const mark = useMark(name);
  if (isGhost(name)) return "differs removed";
  return mark ? `differs ${kindWord(mark.kind)}` : "";
}

/** @param inner  path of the page in it */
export function DifferenceSign({ name, inner }: { name: string; inner?: string | undefined }) {
  const mark = useMark(name);
  const inside = useCount(inner);
  const kind = isGhost(name) ? DifferenceKind.REMOVED : mark?.kind;
  if (kind === undefined && inside === 0) return null;
  return (
    <>
      {kind !== undefined && (
        <span className={`difference-sign ${kindWord(kind)}`} title={kindWord(kind)}>
          <span aria-hidden="true">{kindSign(kind)}</span>
          <span className="hidden-text">{kindWord(kind)}</span>
        </span>
      )}
      {inside > 0 && (
        <span className="difference-count" title={`${inside} inside of it`}>
          {inside}
          <span className="hidden-text"> differences inside</span>
        </span>
      )}
      {mark && !isGhost(name) && <Changes mark={mark} />}
    </>
  );
}

function Changes({ mark }: { mark: PageDifference_Mark }) {
  const details = mark.details.filter((one) => one.what !== "place");
  if (details.length === 0) return null;
  const words = details.map(detailWords);
  return (
    <span className="difference-words" title={words.join("\n")}>
      {words[0]}
      {words.length > 1 && ` (+${words.length - 1})`}
    </span>
  );
}

/** In the details of what is selected: all that became of it. */
export function DifferenceDetails({ name }: { name: string }) {
  const mark = useMark(name);
  if (!mark) return null;
  return (
    <section className="difference-details" aria-label="Difference">
      <p>
        <span className={`difference-sign ${kindWord(mark.kind)}`} aria-hidden="true">
          {kindSign(mark.kind)}
        </span>
        {kindWord(mark.kind)}
      </p>
      {mark.details.length > 0 && (
        <dl>
          {mark.details.map((one) => (
            <div key={`${one.what} ${one.before} ${one.after}`}>
              <dt>{one.what}</dt>
              <dd>
                <del>{one.before || "nothing"}</del> → <ins>{one.after || "nothing"}</ins>
              </dd>
            </div>
          ))}
        </dl>
      )}
    </section>
  );
}
