import { ReactFlowProvider } from "@xyflow/react";
import { lazy, type ReactNode, Suspense, useEffect } from "react";
import { IconButton } from "../ui/controls/controls.tsx";
import { ErrorFence } from "../ui/controls/error_fence.tsx";
import { isStale, Silence } from "../ui/controls/silence.tsx";
import { Splitter } from "../ui/controls/splitter.tsx";
import { useTheme } from "../ui/controls/theme.ts";
import { count } from "../ui/words/format.ts";
import { Commands, ShortcutSheet } from "./actions/dialogs.tsx";
import { useShortcuts } from "./actions/use_shortcuts.ts";
import { Canvas } from "./canvas/canvas.tsx";
import { CanvasTools } from "./canvas/canvas_tools.tsx";
import { EmptyHint } from "./canvas/empty_hint.tsx";
import { FindBar } from "./canvas/find_bar.tsx";
import { comparedWith } from "./compare/compared.ts";
import Details from "./details/details.tsx";
import { DeclarationDialog, RenameDialog } from "./dialogs/dialogs.tsx";
import { GroupDialog } from "./dialogs/group_dialog.tsx";
import { cdlName } from "./dialogs/names.ts";
import { ParameterDialog } from "./dialogs/parameter_dialog.tsx";
import { CompareDialog } from "./differences/dialog.tsx";
import { DifferencesHeader, DifferencesPanel } from "./differences/panel.tsx";
import { Banners, FloatingBanners } from "./files/banners.tsx";
import { LibraryDialog, OpenDialog, SaveAsDialog } from "./files/dialogs.tsx";
import { StartPage } from "./files/start_page.tsx";
import { TopBar } from "./files/top_bar.tsx";
import { RenameNameDialog } from "./names/name_dialog.tsx";
import { UsesPanel } from "./names/uses_panel.tsx";
import { ConnectChooser } from "./palette/connect_chooser.tsx";
import { DeviceChooser } from "./palette/device_chooser.tsx";
import { PalettePanel } from "./palette/palette_panel.tsx";
import { SearchPalette } from "./palette/search_palette.tsx";
import { TriggerChooser } from "./palette/trigger_chooser.tsx";
import { ProblemsPanel } from "./problems/problems_panel.tsx";
import type { Designer } from "./session/designer.ts";
import { lastPart, pageKey } from "./session/pages.ts";
import { watchPanes } from "./session/panes.ts";
import { type Drawing, Drawing_Kind } from "./session/protocol.ts";
import { failedTests, type ShownPanes } from "./session/state.ts";
import { nameOf } from "./session/titles.ts";
import { DesignerContext, useDesigner, useDocument, useDrawing, usePart } from "./session/use.ts";
import { transitionOf } from "./states/flow.ts";
import { Tour } from "./tour/tour.tsx";
import "@xyflow/react/dist/base.css";
import "../ui/styles/tokens.css";
import "../ui/styles/base.css";
import "../ui/styles/controls.css";
import "../ui/styles/shell.css";
import "../ui/styles/over.css";
import "./styles/tokens.css";
import "./styles/designer.css";
import "./styles/canvas.css";
import "./styles/states.css";
import "./styles/compare.css";
import "./styles/narrow.css";

const TextPane = lazy(() => import("./text/text_pane.tsx"));

export function App({ designer }: { designer: Designer }) {
  return (
    <DesignerContext value={designer}>
      <Page />
    </DesignerContext>
  );
}

function Page() {
  const designer = useDesigner();
  const document = usePart((state) => state.document);
  useTheme(usePart((state) => state.theme));
  useShortcuts(designer);
  useEffect(watchPanes, []);
  useTitle();
  usePrinting(designer);
  const link = usePart((state) => state.link);
  const isKnown = usePart((state) => state.hello) !== null;
  return (
    <div className={`app designer ${isKnown && isStale(link) ? "stale" : ""}`}>
      <TopBar />
      <Banners />
      {document === "" ? (
        <>
          <FloatingBanners />
          <StartPage />
        </>
      ) : (
        <Work />
      )}
      <Silence link={link} />
      <Dialogs />
      <SpokenStatus />
    </div>
  );
}

function Work() {
  const shown = usePart((state) => state.shown);
  const isCompared = usePart((state) => comparedWith(state) !== undefined);
  const { live: Live, tests: Tests, bottom: Bottom } = useDesigner().extensions;
  return (
    <>
      <div className="work">
        {shown.palette && (
          <SidePane name="palette" title="Components" width="paletteWidth" side="left">
            <PalettePanel />
          </SidePane>
        )}
        <main className="centre">
          <ErrorFence name="The drawing">
            <Centre />
          </ErrorFence>
          <FloatingBanners />
        </main>
        {shown.text && (
          <SidePane name="text" title="Text" width="textWidth" side="right">
            <Suspense fallback={<p className="empty small">Loading…</p>}>
              <TextPane />
            </Suspense>
          </SidePane>
        )}
        {shown.live && Live && (
          <SidePane name="live" title="Simulator" width="liveWidth" side="right">
            <Live />
          </SidePane>
        )}
        {shown.details && (
          <SidePane name="details" title="Details" width="detailsWidth" side="right">
            <Details />
          </SidePane>
        )}
      </div>
      <UsesPanel />
      {isCompared && <BottomPane name="Differences" header={<DifferencesHeader />} panel={<DifferencesPanel />} />}
      {shown.tests && Tests && <BottomPane name="Tests" header={<Tests.header />} panel={<Tests.panel />} />}
      {shown.problems && <Problems />}
      {Bottom && <Bottom />}
      <Strip />
    </>
  );
}

function Centre() {
  const drawing = useDrawing();
  const key = usePart((state) => pageKey(state.document, state.page));
  if (!drawing) return <p className="empty">Reading…</p>;
  return (
    <ReactFlowProvider key={key}>
      <Canvas drawing={drawing} />
      <CanvasTools />
      <FindBar drawing={drawing} />
      <EmptyHint drawing={drawing} />
      <Tour />
    </ReactFlowProvider>
  );
}

interface SideProps {
  name: "palette" | "text" | "live" | "details";
  title: string;
  width: "paletteWidth" | "textWidth" | "liveWidth" | "detailsWidth";
  side: "left" | "right";
  children: ReactNode;
}

function SidePane({ name, title, width, side, children }: SideProps) {
  const designer = useDesigner();
  const size = usePart((state) => state.shown[width]);
  return (
    <section className={`dock ${side}`} style={{ width: size }} aria-label={title}>
      <Splitter
        side={side}
        label={`Width of ${title}`}
        size={size}
        least={160}
        most={Math.max(320, window.innerWidth - 700)}
        onSize={(next) => designer.show({ [width]: next } as Partial<ShownPanes>)}
      />
      <header>
        <h2>{title}</h2>
        <IconButton icon="close" label={`Hide ${title}`} onPress={() => designer.show({ [name]: false })} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard */}
      <section className="panel" tabIndex={0} aria-label={`${title} content`}>
        <ErrorFence name={title}>{children}</ErrorFence>
      </section>
    </section>
  );
}

function Problems() {
  const designer = useDesigner();
  const header = (
    <>
      <h2>Problems</h2>
      <IconButton icon="close" label="Hide Problems" onPress={() => designer.show({ problems: false })} />
    </>
  );
  return <BottomPane name="Problems" header={header} panel={<ProblemsPanel />} />;
}

/** Below the drawing; all are of the same height. */
function BottomPane({ name, header, panel }: { name: string; header: ReactNode; panel: ReactNode }) {
  const designer = useDesigner();
  const height = usePart((state) => state.shown.problemsHeight);
  return (
    <section className="dock bottom" style={{ height }} aria-label={name}>
      <Splitter
        side="bottom"
        label={`Height of ${name}`}
        size={height}
        least={100}
        most={window.innerHeight - 240}
        onSize={(next) => designer.show({ problemsHeight: next })}
      />
      <header>{header}</header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard */}
      <section className="panel" tabIndex={0} aria-label={`${name} content`}>
        {panel}
      </section>
    </section>
  );
}

const kPanes = [
  ["palette", "Components"],
  ["text", "Text"],
  ["problems", "Problems"],
  ["tests", "Tests"],
  ["live", "Simulator"],
  ["details", "Details"],
] as const;

/** Opens and closes what stands around the canvas; says where one is. */
function Strip() {
  const designer = useDesigner();
  const shown = usePart((state) => state.shown);
  const selection = usePart((state) => state.selection);
  const drawing = useDrawing();
  return (
    <footer className="strip">
      <span className="columns" style={{ gap: 2 }}>
        {kPanes
          .filter(([name]) => (name !== "live" && name !== "tests") || designer.extensions[name])
          .map(([name, title]) => (
            <button
              key={name}
              type="button"
              className="strip-toggle"
              aria-pressed={shown[name]}
              onClick={() => designer.show({ [name]: !shown[name] })}
            >
              {title}
              {name === "tests" && <FailedTests />}
            </button>
          ))}
      </span>
      <span className="gap" />
      <span className="small muted" data-testid="selected">
        {selection.length === 0
          ? drawing && countOf(drawing)
          : selection.length === 1
            ? shownName(drawing, selection[0]!)
            : `${selection.length} selected`}
      </span>
      <span className="small muted">
        <kbd>/</kbd> place <kbd>?</kbd> all keys
      </span>
    </footer>
  );
}

function FailedTests() {
  const failed = usePart((state) => failedTests(state.tests[state.document]));
  return failed === 0 ? null : <span className="strip-count">{failed} failed</span>;
}

/** How much stands on the page. */
function countOf({ kind, nodes, states, transitions }: Drawing): string {
  if (kind !== Drawing_Kind.STATES) return count(nodes.length, "node");
  return `${count(states.length, "state")}, ${count(transitions.length, "transition")}`;
}

/** Comments and frames are not called anything, and transitions by what they join. */
function shownName(drawing: Drawing | undefined, id: string): string {
  const note = drawing?.notes.find((one) => one.id === id);
  if (note) return note.isFrame ? "Frame" : "Comment";
  const transition = drawing && transitionOf(drawing, id);
  return transition ? `${transition.from} → ${transition.to}` : lastPart(id);
}

/** What draws for the printer comes when the page has been shown. */
function usePrinting(designer: Designer): void {
  useEffect(() => {
    let stop = () => {};
    let isLeft = false;
    const timer = setTimeout(async () => {
      const { followPrinting } = await import("./exports/export.ts");
      if (!isLeft) stop = followPrinting(designer);
    }, 1000);
    return () => {
      isLeft = true;
      clearTimeout(timer);
      stop();
    };
  }, [designer]);
}

function Dialogs() {
  switch (usePart((state) => state.dialog)) {
    case "place":
      return <SearchPalette />;
    case "connect":
      return <ConnectChooser />;
    case "trigger":
      return <TriggerChooser />;
    case "device":
      return <DeviceChooser />;
    case "commands":
      return <Commands />;
    case "shortcuts":
      return <ShortcutSheet />;
    case "open":
      return <OpenDialog />;
    case "save-as":
      return <SaveAsDialog />;
    case "library":
      return <LibraryDialog />;
    case "group":
      return <GroupDialog />;
    case "rename":
      return <RenameDialog />;
    case "rename-name":
      return <RenameNameDialog wrong={cdlName} />;
    case "declaration":
      return <DeclarationDialog />;
    case "compare":
      return <CompareDialog />;
    case "parameter":
      return <ParameterDialog />;
    default:
      return null;
  }
}

function SpokenStatus() {
  const spoken = usePart((state) => state.spoken);
  return (
    <div className="hidden-text" role="status" aria-live="polite">
      {spoken}
    </div>
  );
}

function useTitle(): void {
  const document = useDocument();
  const page = usePart((state) => state.page);
  useEffect(() => {
    const name = document ? `${document.isDirty ? "• " : ""}${page || nameOf(document)} – ` : "";
    window.document.title = `${name}missionlab designer`;
  }, [document, page]);
}
