// The bar at the top: files, what is open, where in it, undo, running.
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { MenuButton, type MenuGroup } from "../../ui/controls/menus.tsx";
import { allActions } from "../actions/all_actions.ts";
import type { ActionGroup } from "../session/action.ts";
import { crumbsIn } from "../session/crumbs.ts";
import { redo, save, undo } from "../session/documents.ts";
import { isNew, nameOf } from "../session/titles.ts";
import { useDesigner, useDocument, usePart } from "../session/use.ts";

export function TopBar() {
  const designer = useDesigner();
  const document = useDocument();
  const Run = designer.extensions.run;
  return (
    <header className="topbar">
      <FileMenu />
      {document && (
        <>
          <Title />
          <span className="columns" style={{ gap: 0, flexWrap: "nowrap" }}>
            <IconButton
              icon="undo"
              label={document.undo ? `Undo ${document.undo}` : "Nothing to undo"}
              shortcut={shownShortcut("ctrl+z")}
              isDisabled={!document.undo}
              onPress={() => undo(designer)}
            />
            <IconButton
              icon="redo"
              label={document.redo ? `Redo ${document.redo}` : "Nothing to redo"}
              shortcut={shownShortcut("ctrl+shift+z")}
              isDisabled={!document.redo}
              onPress={() => redo(designer)}
            />
          </span>
          <span className="divider" />
          <Breadcrumbs />
        </>
      )}
      <span className="gap" />
      {document && Run && <Run />}
      {document && <Verdict />}
      <Hint text="Search everything" shortcut={shownShortcut("ctrl+k")}>
        <Button tone="quiet" icon="search" onPress={() => designer.store.setState({ dialog: "commands" })}>
          <span className="hidden-text">Search everything</span>
          <kbd>{shownShortcut("ctrl+k")}</kbd>
        </Button>
      </Hint>
      <IconButton
        icon="question"
        label="Keyboard shortcuts"
        shortcut="?"
        onPress={() => designer.store.setState({ dialog: "shortcuts" })}
      />
    </header>
  );
}

const kMenu: readonly ActionGroup[] = ["File", "Place", "View", "Compare", "Help"];

function FileMenu() {
  const designer = useDesigner();
  usePart((state) => state); // what is offered hangs on all of it
  const actions = allActions(designer);
  const groups: MenuGroup[] = kMenu.map((group) => ({
    title: group,
    entries: actions
      .filter((one) => one.group === group)
      .map((one) => ({
        id: one.id,
        label: one.label,
        isDisabled: one.blocked !== undefined,
        run: one.run,
        ...(one.icon ? { icon: one.icon } : {}),
        ...(one.shortcut ? { shortcut: shownShortcut(one.shortcut) } : {}),
      })),
  }));
  return (
    <MenuButton
      label="Menu"
      trigger={
        <Button tone="quiet" className="square" aria-label="Menu">
          <Icon name="menu" />
        </Button>
      }
      groups={groups}
    />
  );
}

function Title() {
  const designer = useDesigner();
  const document = useDocument()!;
  return (
    <>
      <h1 className="title ellipsis" title={isNew(document.path) ? undefined : document.path}>
        {nameOf(document)}
      </h1>
      {document.isReadOnly && <span className="pill">Read only</span>}
      {document.isDirty && !document.isReadOnly && (
        <Hint text="Save" shortcut={shownShortcut("ctrl+s")}>
          <Button tone="quiet" className="pill hold" onPress={() => void save(designer)}>
            Not saved
          </Button>
        </Hint>
      )}
    </>
  );
}

function Breadcrumbs() {
  const designer = useDesigner();
  const state = usePart((all) => all);
  const crumbs = crumbsIn(state);
  return (
    <nav className="breadcrumbs" aria-label="Where you are">
      {crumbs.map(({ document, page, title }, i) => {
        const isHere = i === crumbs.length - 1 && page === state.page;
        return (
          <span key={`${document} ${page}`} className="crumb">
            {i > 0 && <Icon name="right" />}
            <Button
              tone="quiet"
              isDisabled={isHere}
              {...(isHere ? { "aria-current": "page" as const } : {})}
              onPress={() => designer.navigation.goTo(document, page)}
            >
              {title}
            </Button>
          </span>
        );
      })}
    </nav>
  );
}

/** Whether it compiles; a click shows why not. */
function Verdict() {
  const designer = useDesigner();
  const document = useDocument()!;
  const errors = document.problems.filter((problem) => !problem.diagnostic?.isWarning).length;
  const warnings = document.problems.length - errors;
  const tone = errors > 0 ? "danger" : warnings > 0 ? "hold" : "go";
  const text =
    errors > 0
      ? `${errors} ${errors === 1 ? "error" : "errors"}`
      : warnings > 0
        ? `${warnings} ${warnings === 1 ? "warning" : "warnings"}`
        : "No problems";
  return (
    <Button
      tone="quiet"
      className={`pill ${tone}`}
      data-testid="verdict"
      onPress={() => designer.show({ problems: !designer.state.shown.problems })}
    >
      <span className="dot" />
      {text}
    </Button>
  );
}
