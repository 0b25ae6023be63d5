// The measuring tool, and what it has measured in words, over the map.
import { useStore } from "zustand";
import { createStore } from "zustand/vanilla";
import { formatBearing, formatDistance } from "../../core/format.ts";
import { distance, lengthOf, type Point } from "../../core/geometry.ts";
import { MeasureTool } from "../../core/map/tools/measure.ts";

const measured = createStore<{ points: readonly Point[] }>(() => ({ points: [] }));

export const makeMeasureTool = () => new MeasureTool((points) => measured.setState({ points }));

export function MeasureOptions() {
  const { points } = useStore(measured);
  const text = measuredText(points);
  return (
    <span className="small" role="status">
      {text === "" ? (
        <>
          Click, or <kbd>Enter</kbd> for the middle of the map, sets a point; a double click ends.
        </>
      ) : (
        <span className="number">{text}</span>
      )}
    </span>
  );
}

/** `Last 141 m, bearing 045° · whole 341 m`; empty with fewer than two points. */
export function measuredText(points: readonly Point[]): string {
  const [a, b] = points.slice(-2);
  if (!a || !b) return "";
  const leg = `${formatDistance(distance(a, b))}, bearing ${formatBearing(Math.atan2(b.y - a.y, b.x - a.x))}`;
  return points.length === 2 ? leg : `Last ${leg} · whole ${formatDistance(lengthOf(points))}`;
}
