// What each control measure looks like on the map, small.
import { kindInfo, type MeasureKind } from "../../core/measure_kinds.ts";

export function KindIcon({ kind }: { kind: MeasureKind }) {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={kindInfo(kind).icon} />
    </svg>
  );
}
