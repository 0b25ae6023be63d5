// What a renaming would change, file by file and line by line.
import type { File, Plan, Use } from "../../core/names.ts";
import { Icon } from "../controls/icons.tsx";
import { count } from "../words/format.ts";
import { sentence, withoutBackticks } from "../words/sentence.ts";
import { summary } from "./renaming.ts";
import "./names.css";

const kMostLines = 200;

export function PlanView({ plan }: { plan: Plan }) {
  return (
    <div className="name-plan">
      <p className="small" role="status">
        {summary(plan)}
      </p>
      {plan.notes.map((note) => (
        <p key={note} className="notice hold small">
          {sentence(note, withoutBackticks)}
        </p>
      ))}
      {plan.files.map((file) => (
        <FileLines key={file.path} file={file} />
      ))}
    </div>
  );
}

function FileLines({ file }: { file: File }) {
  return (
    <section aria-label={file.path}>
      <h3 className="name-file">
        <Icon name="file" />
        <span className="ellipsis">{file.path}</span>
        <span className="small muted">{file.kept !== "" ? `stays as it is: ${file.kept}` : whatBecomes(file)}</span>
      </h3>
      <ul className="name-lines">
        {file.uses.slice(0, kMostLines).map((use) => (
          <li key={use.begin}>
            <NameLine use={use} />
          </li>
        ))}
        {file.uses.length > kMostLines && (
          <li className="small muted">and {count(file.uses.length - kMostLines, "more place")}</li>
        )}
      </ul>
    </section>
  );
}

function whatBecomes(file: File): string {
  return file.isUnsaved ? `${count(file.uses.length, "place")}, stays unsaved` : count(file.uses.length, "place");
}

/** A line with the name in it, and with what comes in its place. */
export function NameLine({ use }: { use: Use }) {
  return (
    <span className="name-line">
      <span className="name-number muted">{use.line}</span>
      <code>
        {use.before}
        {use.becomes === "" ? (
          <mark>{use.name}</mark>
        ) : (
          <>
            {use.name !== "" && <del>{use.name}</del>}
            <ins>{use.becomes}</ins>
          </>
        )}
        {use.after}
      </code>
    </span>
  );
}
