// What a person orders of the server; what goes wrong is shown to them.
import { Control_Action, type Order, type Reply, Status_Mode } from "../../core/protocol.ts";
import { sentence } from "../../ui/words/sentence.ts";
import type { Session } from "./session.ts";

/** Asks, and shows why not where the answer is no. */
export async function order(session: Session, body: Order): Promise<Reply> {
  const reply = await session.connection.ask(body);
  if (!reply.ok) {
    const first = reply.diagnostics.find((diagnostic) => !diagnostic.isWarning) ?? reply.diagnostics[0];
    session.ui.tell(sentence(reply.error || first?.message || "the server said no"));
  }
  return reply;
}

export function control(session: Session, action: Control_Action, step = 0): void {
  const answered = order(session, { case: "control", value: { action, step } });
  if (action === Control_Action.EXECUTE || action === Control_Action.SINGLE_STEP) void showStarting(session, answered);
}

/** When somebody begins to wonder whether anything happens [ms]. */
const kWonders = 300;

/** Vehicles are looked at once more before a mission moves them, which may take some seconds. */
async function showStarting(session: Session, answered: Promise<Reply>): Promise<void> {
  const timer = setTimeout(() => session.ui.set("isStarting", true), kWonders);
  await answered;
  clearTimeout(timer);
  session.ui.set("isStarting", false);
}

/** What can't be taken back is asked once: aborting, and beginning anew what has begun. */
export function askFirst(session: Session, action: Control_Action.ABORT | Control_Action.RESTART): void {
  const mode = session.model.get("status")?.mode ?? Status_Mode.NO_MISSION;
  const isNothing = mode === Status_Mode.READY || mode === Status_Mode.NO_MISSION;
  const hasEnded = mode === Status_Mode.ENDED;
  if (isNothing || (hasEnded && action === Control_Action.RESTART)) control(session, action);
  else session.ui.set("dialog", action === Control_Action.ABORT ? "abort" : "restart");
}

/** Others of their type take their places. What goes wrong with one is shown, and the rest is left as it is. */
export async function replaceRobots(session: Session, robots: readonly number[]): Promise<void> {
  for (const robot of robots) {
    const { ok } = await order(session, { case: "replaceRobot", value: { robot } });
    if (!ok) return;
  }
}

export function answer(session: Session, question: number, proceed: boolean): void {
  void order(session, { case: "answer", value: { question, proceed } });
}

export function setSpeed(session: Session, speed: number): void {
  void order(session, { case: "setSpeed", value: { speed } });
}

/** From another moment to the run as it goes on. */
export function backToNow(session: Session): void {
  void order(session, { case: "lookBack", value: { to: { case: "now", value: true } } });
}

/** By two ways at once; does not wait for anything else. The page says so until every robot has confirmed it. */
export async function emergencyStop(session: Session): Promise<void> {
  session.ui.set("stopSent", true);
  // How far the stop has come is to be seen there alone.
  if (session.model.isElsewhen()) backToNow(session);
  const ok = await session.connection.emergencyStop();
  if (!ok && session.ui.get("stopSent"))
    session.ui.tell("The emergency stop did not reach the server. Stop the robots by other means.");
}

export function undo(session: Session): void {
  if (session.ui.undo() === "mission") void order(session, { case: "undo", value: {} });
}

export function redo(session: Session): void {
  if (session.ui.redo() === "mission") void order(session, { case: "redo", value: {} });
}

export function save(session: Session): void {
  const documents = session.model.get("documents")?.documents ?? [];
  const first = documents.find((document) => document.isDirty && document.isReadOnly);
  if (first) {
    session.ui.set("document", first.path);
    session.ui.set("dialog", "save-as");
    return;
  }
  void order(session, { case: "saveDocuments", value: { documents: [] } });
}

export async function openMission(session: Session, path: string): Promise<boolean> {
  const reply = await order(session, { case: "openMission", value: { path } });
  return reply.ok;
}

export function takeOperator(session: Session): void {
  void order(session, { case: "takeOperator", value: {} });
}

/** 0: declines the request that is open. */
export function passOperator(session: Session, client: number): void {
  void order(session, { case: "passOperator", value: { client } });
}
