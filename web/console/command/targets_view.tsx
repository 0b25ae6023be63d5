import type { Diagnostic, Targets } from "../../core/protocol.ts";
import { unitsOf } from "../editor/bytes.ts";
import { sentence } from "../orders.ts";
import { targetLines } from "./targets.ts";

/** Who is meant, who is skipped and why, what is replaced. */
export function TargetsView({ targets }: { targets: Targets }) {
  const lines = targetLines(targets);
  if (lines.length === 0) return <p className="small muted">Concerns no unit.</p>;
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
          {line.replaces && <p className="small target-replaces">Ends what it does now: {line.replaces}</p>}
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
