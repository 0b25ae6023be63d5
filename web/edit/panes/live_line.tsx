// The time line of the run, below the drawing, which shows states and values of the moment that is looked at.
import { TimeLine } from "../../console/time/time_line.tsx";
import { InSession } from "./in_session.tsx";

export function LiveLine() {
  return (
    <InSession>
      <TimeLine />
    </InSession>
  );
}
