// Where something is named in the project, by file; a click goes there.
import type { File, Use, UseList } from "../../core/names.ts";
import { IconButton } from "../controls/controls.tsx";
import { Icon } from "../controls/icons.tsx";
import { count } from "../words/format.ts";
import { sentence, withoutBackticks } from "../words/sentence.ts";
import { NameLine } from "./plan_view.tsx";
import { placesIn, type TextPlace } from "./renaming.ts";
import "./names.css";

interface UsesProps {
  uses: UseList;
  /** Of the section: where it stands. */
  className: string;
  goTo: (place: TextPlace) => void;
  onClose: () => void;
}

export function Uses({ uses, className, goTo, onClose }: UsesProps) {
  const title = `Uses of ${uses.name}`;
  return (
    <section className={`uses ${className}`} aria-label={title}>
      <header>
        <h2>{title}</h2>
        <span className="small muted">
          {uses.isLibrary ? `${uses.kind} of the library, ` : `${uses.kind}, `}
          {uses.files.length === 0
            ? "not used in this project"
            : `${count(placesIn(uses), "place")} in ${count(uses.files.length, "file")}`}
        </span>
        <span className="gap" />
        <IconButton icon="close" label="Hide the uses" onPress={onClose} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard */}
      <section className="panel" tabIndex={0} aria-label="Uses content">
        {uses.leftOut !== "" && <p className="notice hold small">{sentence(uses.leftOut, withoutBackticks)}</p>}
        {uses.files.map((file) => (
          <FileUses key={file.path} file={file} goTo={goTo} />
        ))}
      </section>
    </section>
  );
}

function FileUses({ file, goTo }: { file: File; goTo: UsesProps["goTo"] }) {
  return (
    <section aria-label={file.path}>
      <h3 className="name-file">
        <Icon name="file" />
        <span className="ellipsis">{file.path}</span>
        <span className="small muted">{count(file.uses.length, "place")}</span>
      </h3>
      <ul className="name-lines">
        {file.uses.map((use) => (
          <li key={use.begin}>
            <Row file={file} use={use} goTo={goTo} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Row({ file, use, goTo }: { file: File; use: Use; goTo: UsesProps["goTo"] }) {
  const facts = [
    use.isDeclaration ? "declared here" : "",
    use.within && !use.isDeclaration ? `in ${use.within}` : "",
  ].filter(Boolean);
  const line = (
    <>
      <NameLine use={use} />
      <span className="small muted name-facts">{facts.join(", ")}</span>
    </>
  );
  if (!file.canOpen) return <span className="name-row">{line}</span>;
  return (
    <button
      type="button"
      className="name-row"
      onClick={() => goTo({ document: file.path, begin: use.begin, end: use.end })}
    >
      {line}
    </button>
  );
}
