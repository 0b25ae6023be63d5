import { useCallback, useEffect } from "react";
import { ErrorFence } from "../ui/controls/error_fence.tsx";
import { isStale, Silence } from "../ui/controls/silence.tsx";
import { useTheme } from "../ui/controls/theme.ts";
import { Palette, ShortcutSheet } from "./actions/palette.tsx";
import { useShortcuts } from "./actions/use_shortcuts.ts";
import { useCalls } from "./calls/use_calls.ts";
import { HandOverDialog } from "./clients/hand_over.tsx";
import { RenameDialog } from "./editor/rename_dialog.tsx";
import { panels } from "./extensions/extensions.ts";
import { ConfirmDialog } from "./mission/confirm.tsx";
import { Questions } from "./questions/questions.tsx";
import { useWatching } from "./selection/use_watched.ts";
import { kNarrow } from "./session/layout.ts";
import {
  type Session,
  SessionContext,
  useIsElsewhen,
  useIsRecording,
  useLayout,
  usePart,
  useReading,
  useSession,
  useUi,
} from "./session/session.ts";
import { Banners } from "./shell/banners.tsx";
import { Dock, Rail } from "./shell/dock.tsx";
import { MapPane, ToolOptions } from "./shell/map_pane.tsx";
import { useRevealing } from "./shell/revealing.ts";
import { Strip } from "./shell/strip.tsx";
import { Toasts } from "./shell/toasts.tsx";
import { TopBar } from "./shell/top_bar.tsx";
import { useFollowStop } from "./shell/use_stop.ts";
import { NewMissionDialog, OpenDialog, SaveAsDialog } from "./start/file_dialogs.tsx";
import { StartPage } from "./start/start_page.tsx";
import { Waiting } from "./start/waiting.tsx";
import { useRevealTeleoperation } from "./teleoperation/use_reveal.ts";
import { TimeLine } from "./time/time_line.tsx";
import "../ui/styles/tokens.css";
import "../ui/styles/base.css";
import "../ui/styles/controls.css";
import "../ui/styles/shell.css";
import "../ui/styles/over.css";
import "./styles/narrow.css";

export function App({ session }: { session: Session }) {
  return (
    <SessionContext value={session}>
      <Page />
    </SessionContext>
  );
}

function Page() {
  const link = usePart("link");
  const isKnown = usePart("welcome") !== null;
  const isRecording = useIsRecording();
  const isElsewhen = useIsElsewhen() && !isRecording;
  const moment = isElsewhen ? "elsewhen" : isRecording ? "" : "at-now";
  return (
    <div className={`app ${isKnown && isStale(link) ? "stale" : ""} ${moment}`}>
      <Attendance />
      <TopBar />
      <Work />
      <Silence link={link} />
      <Dialogs />
    </div>
  );
}

/** What goes on beside all that is shown. Apart, so that what it hears draws nothing else anew. */
function Attendance() {
  usePageTheme();
  useShortcuts(useSession());
  useRevealing();
  useRevealTeleoperation(panels);
  useTitle();
  useWatching();
  useFollowStop();
  useCalls();
  return null;
}

function Work() {
  const project = usePart("project");
  const welcome = usePart("welcome");
  const isNarrow = useUi("room").width < kNarrow;
  const { docks } = useLayout();
  // There a panel lies over the map, and its head is to be read and pressed: what comes lies over its foot.
  const isOverPanel = isNarrow && (docks.left.open || docks.right.open);
  // What a recording was made from is in it, and no file of the project.
  const isRecording = useIsRecording();
  const hasMap = welcome !== null && project !== null && (project.mission !== "" || isRecording);
  if (!hasMap) {
    return (
      <>
        {welcome && project ? <StartPage /> : <Waiting />}
        <div className="over-page">
          <Banners />
        </div>
      </>
    );
  }
  return (
    <>
      <div className="work">
        <Rail side="left" />
        <Dock side="left" />
        <main className="centre">
          <ErrorFence name="The map">
            <MapPane />
          </ErrorFence>
          <div className="over-map">
            <div className="over-map-left">
              <ToolOptions />
              {!isNarrow && <Banners />}
            </div>
            {!isNarrow && <Questions />}
          </div>
          <Toasts />
        </main>
        <Dock side="right" />
        <Rail side="right" />
        {isOverPanel && (
          <div className="over-panel">
            <Banners />
          </div>
        )}
      </div>
      <Dock side="bottom" />
      <TimeLine />
      <Strip />
      {isNarrow && (
        <div className="over-page">
          <Questions />
          {!isOverPanel && <Banners />}
        </div>
      )}
    </>
  );
}

function Dialogs() {
  switch (useUi("dialog")) {
    case "palette":
      return <Palette />;
    case "shortcuts":
      return <ShortcutSheet />;
    case "open":
      return <OpenDialog />;
    case "new":
      return <NewMissionDialog />;
    case "save-as":
      return <SaveAsDialog />;
    case "hand-over":
      return <HandOverDialog />;
    case "rename":
      return <RenameDialog />;
    case "abort":
    case "restart":
      return <ConfirmDialog />;
    default:
      return null;
  }
}

/** On the map, too. */
function usePageTheme(): void {
  const { model } = useSession();
  const told = useCallback(
    (theme: "light" | "dark") => {
      if (model.get("map").theme !== theme) model.updateMap({ theme });
    },
    [model],
  );
  useTheme(useUi("theme"), told);
}

function useTitle(): void {
  const plan = usePart("plan")?.name;
  const recording = useReading(["timeLine"], (model) => model.get("timeLine")?.recording);
  const name = recording ? `Recording ‘${recording}’` : plan;
  const isDirty = usePart("edits")?.isDirty ?? false;
  useEffect(() => {
    document.title = `${isDirty ? "• " : ""}${name ? `${name} – ` : ""}missionlab`;
  }, [name, isDirty]);
}
