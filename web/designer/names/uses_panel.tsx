// Where something is named in the project, by file; a click goes there.
import { IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { count } from "../../ui/words/format.ts";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import type { File, Use } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";
import { goToText } from "./go.ts";
import { NameLine } from "./plan_view.tsx";
import { placesIn } from "./rename.ts";
import "./names.css";

export function UsesPanel() {
  const designer = useDesigner();
  const uses = usePart((state) => state.uses);
  if (!uses) return null;
  const title = `Uses of ${uses.name}`;
  return (
    <section className="dock bottom uses" aria-label={title}>
      <header>
        <h2>{title}</h2>
        <span className="small muted">
          {uses.isLibrary ? `${uses.kind} of the library, ` : `${uses.kind}, `}
          {uses.files.length === 0
            ? "not used in this project"
            : `${count(placesIn(uses), "place")} in ${count(uses.files.length, "file")}`}
        </span>
        <span className="gap" />
        <IconButton icon="close" label="Hide the uses" onPress={() => designer.store.setState({ uses: null })} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard */}
      <section className="panel" tabIndex={0} aria-label="Uses content">
        {uses.leftOut !== "" && <p className="notice hold small">{sentence(uses.leftOut, withoutBackticks)}</p>}
        {uses.files.map((file) => (
          <FileUses key={file.path} file={file} />
        ))}
      </section>
    </section>
  );
}

function FileUses({ file }: { file: File }) {
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
            <Row file={file} use={use} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Row({ file, use }: { file: File; use: Use }) {
  const designer = useDesigner();
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
      onClick={() => void goToText(designer, { document: file.path, begin: use.begin, end: use.end })}
    >
      {line}
    </button>
  );
}
