import { useEffect } from "react";
import { Palette, ShortcutSheet } from "./actions/palette.tsx";
import { useShortcuts } from "./actions/use_shortcuts.ts";
import { HandOverDialog } from "./clients/hand_over.tsx";
import { panels } from "./extensions.ts";
import { Questions } from "./questions/questions.tsx";
import { useWatching } from "./selection/use_watched.ts";
import { type Session, SessionContext, usePart, useSession, useUi } from "./session.ts";
import { Banners } from "./shell/banners.tsx";
import { Dock, Rail } from "./shell/dock.tsx";
import { ErrorFence } from "./shell/error_fence.tsx";
import { MapPane } from "./shell/map_pane.tsx";
import { useRevealing } from "./shell/revealing.ts";
import { Strip } from "./shell/strip.tsx";
import { useTheme } from "./shell/theme.ts";
import { Toasts } from "./shell/toasts.tsx";
import { TopBar } from "./shell/top_bar.tsx";
import { NewMissionDialog, OpenDialog, SaveAsDialog } from "./start/file_dialogs.tsx";
import { StartPage } from "./start/start_page.tsx";
import { Waiting } from "./start/waiting.tsx";
import { useRevealTeleoperation } from "./teleoperation/use_reveal.ts";
import "./styles/tokens.css";
import "./styles/base.css";
import "./styles/controls.css";
import "./styles/shell.css";

export function App({ session }: { session: Session }) {
  return (
    <SessionContext value={session}>
      <Page />
    </SessionContext>
  );
}

function Page() {
  const session = useSession();
  useTheme();
  useShortcuts(session);
  useRevealing();
  useRevealTeleoperation(panels);
  useTitle();
  useWatching();
  return (
    <div className="app">
      <TopBar />
      <Banners />
      <Work />
      <Dialogs />
    </div>
  );
}

function Work() {
  const project = usePart("project");
  const welcome = usePart("welcome");
  if (!welcome || !project) return <Waiting />;
  if (project.mission === "") return <StartPage />;
  return (
    <>
      <div className="work">
        <Rail side="left" />
        <Dock side="left" />
        <main className="centre">
          <ErrorFence name="The map">
            <MapPane />
          </ErrorFence>
          <Questions />
          <Toasts />
        </main>
        <Dock side="right" />
        <Rail side="right" />
      </div>
      <Dock side="bottom" />
      <Strip />
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
    default:
      return null;
  }
}

function useTitle(): void {
  const name = usePart("plan")?.name;
  const isDirty = usePart("edits")?.isDirty ?? false;
  useEffect(() => {
    document.title = `${isDirty ? "• " : ""}${name ? `${name} – ` : ""}missionlab`;
  }, [name, isDirty]);
}
