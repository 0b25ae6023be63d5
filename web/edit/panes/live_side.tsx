// The pane of the simulator comes when it is opened: with it comes the map.
import { lazy, Suspense } from "react";

const LivePane = lazy(() => import("./pane.tsx"));

export function LiveSide() {
  return (
    <Suspense fallback={<p className="empty small">Loading…</p>}>
      <LivePane />
    </Suspense>
  );
}
