// All that is wrong, errors first; a click leads there, offered mends apply.
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { lastPart } from "../session/pages.ts";
import type { Problem } from "../session/protocol.ts";
import { useDesigner, useDocument } from "../session/use.ts";
import { Fixes } from "./fixes.tsx";

const kMostShown = 300;

export function ProblemsPanel() {
  const document = useDocument();
  const problems = document?.problems ?? [];
  const sorted = [...problems].sort((a, b) => Number(a.diagnostic?.isWarning) - Number(b.diagnostic?.isWarning));
  if (sorted.length === 0) {
    return (
      <p className="empty small">
        Nothing is wrong
        {document && document.compileMs > 0 ? `: it compiles in ${Math.round(document.compileMs)} ms` : ""}.
      </p>
    );
  }
  return (
    <ul className="problem-list">
      {sorted.slice(0, kMostShown).map((problem) => (
        <Entry key={keyOf(problem)} problem={problem} />
      ))}
      {sorted.length > kMostShown && <li className="small muted">and {sorted.length - kMostShown} more</li>}
    </ul>
  );
}

function keyOf({ diagnostic, page, node }: Problem): string {
  return `${diagnostic?.begin} ${diagnostic?.message} ${page} ${node}`;
}

/** `Searching/0`: the first transition of the state. */
function spokenPart(node: string): string {
  const [from = "", index] = node.split("/");
  return index === undefined ? lastPart(node) : `transition ${Number(index) + 1} of ${from}`;
}

function Entry({ problem }: { problem: Problem }) {
  const designer = useDesigner();
  const document = useDocument()!;
  const { diagnostic, page, node } = problem;
  if (!diagnostic) return null;
  const go = () => {
    const path = diagnostic.document || document.path;
    if (path !== document.path) designer.navigation.goTo(path, page, node);
    else if (page !== "" || node !== "") designer.navigation.goTo(path, page, node);
    designer.store.setState({ reveal: { begin: diagnostic.begin, end: diagnostic.end, focus: false } });
    if (page === "" && node === "") designer.show({ text: true });
  };
  const where = node ? `${lastPart(page)} · ${spokenPart(node)}` : page;
  return (
    <li className={diagnostic.isWarning ? "warning" : "error"}>
      <Icon name="warning" />
      <span className="hidden-text">{diagnostic.isWarning ? "Warning" : "Error"}: </span>
      <Button tone="link" onPress={go}>
        {sentence(diagnostic.message, withoutBackticks)}
      </Button>
      <span className="muted small">
        {diagnostic.hints.map((hint) => sentence(hint, withoutBackticks)).join(" ")} {where}
        {diagnostic.line > 0 && `${where ? ", " : ""}line ${diagnostic.line}`}
      </span>
      <Fixes problem={problem} />
    </li>
  );
}
