// A robot's state in a word; grey, with its age, where nothing is heard of the robot's machine.
import { isAlike, usePart, useReading, useSession } from "../session/session.ts";
import { shownState, silenceOf } from "./robot_state.ts";

/** Redrawn by itself, some times a second. */
export function StatePill({ robot }: { robot: number }) {
  const { model } = useSession();
  usePart("time");
  useSilence(robot); // while the run waits for it no time passes
  const { word, tone, title } = shownState(model, robot);
  return (
    <span className={`pill ${tone}${title ? " silent" : ""}`} title={title ?? word}>
      {word}
    </span>
  );
}

/** How old what is shown of a robot is; null: it is of now. */
export function useSilence(robot: number) {
  return useReading(["status"], (model) => silenceOf(model.get("status"), robot), isAlike);
}
