// What is told over the drawing: that the values which it shows are of another moment of the run.
import { ElsewhenBanner } from "../../console/time/elsewhen_banner.tsx";
import { usePart } from "../../designer/session/use.ts";
import { InSession } from "./in_session.tsx";

/** The page connects to the simulator when it shows a file. */
export function OverDrawing() {
  if (usePart((state) => state.document) === "") return null;
  return (
    <InSession>
      <ElsewhenBanner />
    </InSession>
  );
}
