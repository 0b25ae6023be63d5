// What has to be known before anything else.
import { useEffect } from "react";
import { Control_Action, type Status_SilentMachine } from "../../core/protocol.ts";
import { Banner } from "../../ui/controls/banner.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { useSecondsUntil } from "../../ui/controls/use_seconds.ts";
import { count, readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { showErrors } from "../mission/press.ts";
import { control, passOperator, save, takeOperator } from "../session/orders.ts";
import {
  isAlike,
  useIsElsewhen,
  useIsOperator,
  useIsRecording,
  useMayOrder,
  usePart,
  useReading,
  useSession,
  useUi,
} from "../session/session.ts";
import { ElsewhenBanner, OnlyRecordedBanner } from "../time/elsewhen_banner.tsx";
import { ChangedFiles } from "./changed_files.tsx";
import type { StopState } from "./stop_state.ts";
import { useStopState } from "./use_stop.ts";

/** Over the page, not in it: what comes and goes moves nothing that somebody is about to press. */
export function Banners() {
  return (
    <div className="banners">
      <StopBanner />
      <ElsewhenBanner />
      <OnlyRecordedBanner />
      <LinkBanner />
      <MachinesBanner />
      <RequestBanner />
      <WatchingBanner />
      <OlderTextBanner />
      <NotKeptBanner />
      <NotSavedBanner />
      <ChangedFiles />
      <Notice />
    </div>
  );
}

function StopBanner() {
  const session = useSession();
  const isOperator = useMayOrder();
  const isElsewhen = useIsElsewhen();
  const isConnected = usePart("link").state === "open";
  const stop = useStopState();
  if (stop.kind === "none") return null;
  return (
    <Banner tone="danger" role="alert">
      <Icon name="stop" />
      <span className="grow">{stopSentence(stop, isConnected)}</span>
      {stop.kind === "sent" ? null : isOperator ? (
        <Button onPress={() => control(session, Control_Action.RELEASE_STOP)}>Release the stop</Button>
      ) : (
        <span>
          {isElsewhen
            ? "So it was at this moment."
            : isConnected
              ? "Only the operator can release it."
              : "Not connected: it cannot be released from here."}
        </span>
      )}
    </Banner>
  );
}

function stopSentence({ kind, standing, robots, unreached }: StopState, isConnected: boolean): string {
  if (kind === "sent")
    return "EMERGENCY STOP sent, not confirmed. Until it is, take it that robots move, and stop them by other means.";
  if (!isConnected)
    return "EMERGENCY STOP when the connection was lost: all robots stood. It may have been released since.";
  if (kind === "stopping" && unreached.length > 0)
    return `EMERGENCY STOP: not confirmed by ${unreached.join(", ")}. Until it is, take it that robots there move, and stop them by other means.`;
  if (kind === "stopping")
    return `EMERGENCY STOP: ${standing} of ${count(robots, "robot")} stand, the rest is being stopped.`;
  return "EMERGENCY STOP: all robots stand and take no orders.";
}

function LinkBanner() {
  const { connection } = useSession();
  const link = usePart("link");
  const welcome = usePart("welcome");
  const seconds = useSecondsUntil(link.retryAt);
  if (link.state === "open" || (link.state === "connecting" && !welcome)) return null;
  const isRefused = link.state === "refused";
  return (
    <Banner tone={isRefused ? "danger" : "hold"} role="alert">
      <Icon name="warning" />
      <span className="grow">
        {isRefused
          ? `The server refuses this page: ${link.reason}. Open the address that mlab printed.`
          : `Connection lost: ${link.reason}. What you see is the last that came. If mlab still runs there, the run goes on without this page.`}
      </span>
      {!isRefused && (
        <>
          <span className="number">{seconds > 0 ? `again in ${seconds} s` : "connecting…"}</span>
          <Button onPress={() => connection.connect()}>Try now</Button>
        </>
      )}
    </Banner>
  );
}

const kNoMachines: readonly Status_SilentMachine[] = [];

/** Machines that carry robots and can't be heard. */
function MachinesBanner() {
  const machines = useReading(["status"], (model) => model.get("status")?.silentMachines ?? kNoMachines, isAlike);
  if (machines.length === 0) return null;
  return (
    <Banner tone="hold" role="status">
      <Icon name="warning" />
      <span className="grow">{machines.map(silenceSentence).join(" ")}</span>
    </Banner>
  );
}

function silenceSentence({ name, silent, patience, isWaitedFor }: Status_SilentMachine): string {
  const since = `Nothing has been heard of machine ${name} for ${Math.floor(silent)} s`;
  const until = `after ${Math.round(patience)} s it is given up.`;
  return isWaitedFor
    ? `${since}: the run waits, ${until}`
    : `${since}: its robots stand, or do what FAILSAFE LINK-LOST says; the run goes on, ${until}`;
}

function RequestBanner() {
  const session = useSession();
  const clients = usePart("clients");
  const isOperator = useIsOperator();
  const asks = clients?.clients.find((client) => client.id === clients.asks);
  if (!isOperator || !asks) return null;
  return (
    <Banner tone="accent" role="alert">
      <Icon name="hand" />
      <span className="grow">{asks.name || `Browser ${asks.id}`} asks to become the operator.</span>
      <Button tone="primary" onPress={() => passOperator(session, asks.id)}>
        Hand over
      </Button>
      <Button onPress={() => passOperator(session, 0)}>Decline</Button>
    </Banner>
  );
}

function WatchingBanner() {
  const session = useSession();
  const clients = usePart("clients");
  const welcome = usePart("welcome");
  const isOperator = useIsOperator();
  const link = usePart("link");
  const isRecording = useIsRecording();
  if (!clients || !welcome || isOperator || isRecording || link.state !== "open") return null;
  const holder = clients.clients.find((client) => client.id === clients.operator);
  const hasAsked = clients.asks === welcome.client;
  return (
    <Banner tone="accent" isYielding>
      <Icon name="lock" />
      <span className="grow">
        You are watching.{" "}
        {holder ? `${holder.name || `Browser ${holder.id}`} is the operator` : "Nobody is the operator"}
        {hasAsked ? " and has been asked for control." : "."} The emergency stop works for everybody.
      </span>
      {!hasAsked && (
        <Button onPress={() => takeOperator(session)}>{holder ? "Ask for control" : "Take control"}</Button>
      )}
    </Banner>
  );
}

function OlderTextBanner() {
  const session = useSession();
  const documents = usePart("documents");
  if (!documents?.runsOlderText) return null;
  return (
    <Banner tone="hold">
      <Icon name="warning" />
      <span className="grow">The mission text has errors. What runs is the last version without.</span>
      <Button onPress={() => showErrors(session)}>Show the errors</Button>
    </Banner>
  );
}

function NotKeptBanner() {
  const session = useSession();
  const edits = usePart("edits");
  const isOperator = useMayOrder();
  if (!edits?.notKept) return null;
  return (
    <Banner tone={edits.isDirty ? "danger" : "hold"} role="alert">
      <Icon name="warning" />
      <span className="grow">
        What is not saved is not kept, and is lost when mlab ends: {readableMessage(edits.notKept)}.
        {edits.isDirty ? " There is something that is not saved." : ""}
      </span>
      {edits.isDirty && isOperator && <Button onPress={() => save(session)}>Save</Button>}
    </Banner>
  );
}

function NotSavedBanner() {
  const journal = usePart("journal");
  if (!journal?.notSaved) return null;
  return (
    <Banner tone="hold" role="alert">
      <Icon name="warning" />
      <span className="grow">
        What is done in this run is not saved. It goes on, but could not be continued after mlab ends:{" "}
        {readableMessage(journal.notSaved)}.
      </span>
    </Banner>
  );
}

function Notice() {
  const { ui } = useSession();
  const notice = useUi("notice");
  useEffect(() => {
    if (notice?.tone !== "accent") return;
    const timer = setTimeout(() => ui.set("notice", null), 20000);
    return () => clearTimeout(timer);
  }, [notice, ui]);
  if (!notice) return null;
  return (
    <Banner tone={notice.tone} role="alert">
      <Icon name={notice.tone === "accent" ? "check" : "warning"} />
      <span className="grow">{sentence(notice.text)}</span>
      {notice.action && <Button onPress={notice.action.run}>{notice.action.label}</Button>}
      <IconButton icon="close" label="Dismiss" onPress={() => ui.set("notice", null)} />
    </Banner>
  );
}
