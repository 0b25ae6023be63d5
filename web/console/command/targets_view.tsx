import type { Diagnostic, Targets } from "../../core/protocol.ts";
import { unitsOf } from "../../ui/text/bytes.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { standingLines, type TargetLine, targetLines } from "./targets.ts";

/** Who is meant, who is skipped and why, and what becomes of every other unit. */
export function TargetsView({ targets }: { targets: Targets }) {
  const lines = targetLines(targets);
  if (lines.length === 0) return <p className="small muted">Concerns no unit.</p>;
  const standing = standingLines(targets);
  return (
    <>
      <TargetList lines={lines} />
      {standing.length > 0 && (
        <ul className="targets targets-standing" aria-label="The others">
          {standing.map((line) => (
            <li key={`${line.unit} ${line.fate}`} className={`small ${line.isTouched ? "target-replaces" : "muted"}`}>
              <strong>{line.unit}</strong> {line.fate}
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

function TargetList({ lines }: { lines: TargetLine[] }) {
  return (
    <ul className="targets">
      {lines.map((line) => (
        <li key={`${line.unit} ${line.does}`}>
          <p>
            <strong>{line.unit}</strong> {line.does && <span className="mono">{line.does}</span>} → {line.meant}
          </p>
          {line.skipped.map((text) => (
            <p key={text} className="small target-skipped">
              Skipped: {text}
            </p>
          ))}
        </li>
      ))}
    </ul>
  );
}

/** What is wrong with a line, with the place marked. */
export function DiagnosticsView({ line, diagnostics }: { line: string; diagnostics: readonly Diagnostic[] }) {
  return (
    <ul className="targets">
      {diagnostics.map((diagnostic) => {
        const begin = unitsOf(line, diagnostic.begin);
        const end = Math.max(begin, unitsOf(line, diagnostic.end));
        return (
          <li key={`${diagnostic.kind} ${diagnostic.begin} ${diagnostic.message}`}>
            <p className={diagnostic.isWarning ? "target-replaces" : "problem"}>{sentence(diagnostic.message)}</p>
            {end > begin && (
              <p className="mono marked-line">
                {line.slice(0, begin)}
                <mark>{line.slice(begin, end)}</mark>
                {line.slice(end)}
              </p>
            )}
            {diagnostic.hints.map((hint) => (
              <p key={hint} className="small muted">
                {sentence(hint)}
              </p>
            ))}
          </li>
        );
      })}
    </ul>
  );
}
