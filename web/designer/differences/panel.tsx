// All that differs from the version that the configuration is compared with, page by page; a click leads there.

import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { action } from "../actions/all_actions.ts";
import { goToDifference } from "../actions/compare_actions.ts";
import { comparedWith, entriesOf, kindSign, kindWord } from "../compare/compared.ts";
import { stopComparing } from "../session/documents.ts";
import type { Differences_Entry } from "../session/protocol.ts";
import { useDesigner, usePart } from "../session/use.ts";

const kMostShown = 500;

export function DifferencesHeader() {
  const designer = useDesigner();
  const compared = usePart(comparedWith);
  const at = usePart((state) => state.difference);
  const showsMoved = usePart((state) => state.showsMoved);
  usePart((state) => state.differences);
  const count = entriesOf(designer.state).length;
  const run = (id: string) => () => action(designer, id)?.run();
  return (
    <>
      <h2 className="ellipsis">Compared with {compared?.title}</h2>
      <span className="muted small number">
        {at >= 0 && count > 0 ? `${Math.min(at + 1, count)} of ${count}` : count}
      </span>
      <IconButton
        icon="up"
        label="Previous difference"
        shortcut={shownShortcut("shift+f7")}
        isDisabled={count === 0}
        onPress={run("previous-difference")}
      />
      <IconButton
        icon="down"
        label="Next difference"
        shortcut={shownShortcut("f7")}
        isDisabled={count === 0}
        onPress={run("next-difference")}
      />
      <Button tone="quiet" onPress={() => designer.store.setState({ showsMoved: !showsMoved, difference: -1 })}>
        {showsMoved ? "Hide moves" : "Show moves"}
      </Button>
      <Button tone="quiet" onPress={run("compare")}>
        Compare with…
      </Button>
      <IconButton icon="close" label="Stop comparing" onPress={() => stopComparing(designer)} />
    </>
  );
}

export function DifferencesPanel() {
  const compared = usePart(comparedWith);
  const designer = useDesigner();
  usePart((state) => state.showsMoved);
  if (!compared) return null;
  const entries = entriesOf(designer.state);
  return (
    <>
      {compared.trouble && <p className="notice hold">{compared.trouble}</p>}
      {entries.length === 0 && (
        <p className="empty small">
          {compared.remarks.length > 0 ? compared.remarks.join(". ") : "Nothing differs: both texts are the same"}.
        </p>
      )}
      {pagesOf(entries.slice(0, kMostShown)).map(({ page, all }) => (
        <section key={page} className="difference-page" aria-label={page || "The file"}>
          <h3 className="small muted">
            {page || "The file"} <span className="number">{all.length}</span>
          </h3>
          <ul>
            {all.map(({ entry, at }) => (
              <Entry key={at} entry={entry} at={at} />
            ))}
          </ul>
        </section>
      ))}
      {entries.length > kMostShown && <p className="empty small">and {entries.length - kMostShown} more</p>}
      {entries.length > 0 && compared.remarks.length > 0 && (
        <p className="difference-remark small muted">{compared.remarks.join(". ")}.</p>
      )}
    </>
  );
}

interface PageOfEntries {
  page: string;
  all: { entry: Differences_Entry; at: number }[];
}

/** Those behind each other of one page. */
function pagesOf(entries: readonly Differences_Entry[]): PageOfEntries[] {
  const pages = new Map<string, PageOfEntries>();
  entries.forEach((entry, at) => {
    const known = pages.get(entry.page) ?? { page: entry.page, all: [] };
    known.all.push({ entry, at });
    pages.set(entry.page, known);
  });
  return [...pages.values()];
}

function Entry({ entry, at }: { entry: Differences_Entry; at: number }) {
  const designer = useDesigner();
  const isHere = usePart((state) => state.difference === at);
  return (
    <li className={isHere ? "here" : ""}>
      <span className={`difference-sign ${kindWord(entry.kind)}`} aria-hidden="true">
        {kindSign(entry.kind)}
      </span>
      <span className="hidden-text">{kindWord(entry.kind)}: </span>
      <Button
        tone="link"
        {...(isHere ? { "aria-current": "true" as const } : {})}
        onPress={() => goToDifference(designer, entry, at)}
      >
        {entry.text.replaceAll(" -> ", " → ")}
      </Button>
    </li>
  );
}
