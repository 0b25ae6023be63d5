// What each control measure looks like on the map, small.
import type { MeasureKind } from "../../core/measure_kinds.ts";

const kPaths: Record<MeasureKind, string> = {
  assembly_area: "M4 8.5L12 4l8 3.5-1.5 10L8 20z",
  passage_point: "M12 18a6 6 0 1 0 0-12 6 6 0 0 0 0 12zM12 12v.1",
  attack_position: "M5 5h14v14H5zM9 12h6M12 9v6",
  battle_position: "M4 12c0-5 3.5-7 8-7s8 2 8 7-3.5 7-8 7-8-2-8-7zM12 5V2.5M12 21.5V19",
  objective: "M12 20a8 8 0 1 0 0-16 8 8 0 0 0 0 16zM12 15a3 3 0 1 0 0-6 3 3 0 0 0 0 6z",
  start_point: "M7 21V4h11l-3 4 3 4H7",
  axis: "M3 10h10V6l8 6-8 6v-4H3z",
  gap: "M4 5l4 4h8l4-4M4 19l4-4h8l4 4",
  boundary: "M3 17l6-9 6 5 6-8M12 8.5l-2-2M18 10.5l-2-2",
  phase_line: "M3 12c4-6 7 6 11 0 2-3 4-3 7-1M3 8v8M21 7v8",
  line_of_departure: "M2 15a3.3 3.3 0 0 1 6.6 0 3.3 3.3 0 0 1 6.6 0 3.3 3.3 0 0 1 6.6 0",
  road: "M8 21L10 3M16 21L14 3M12 5v3M12 11v3M12 17v3",
  wall: "M3 7h18v10H3zM3 12h18M9 7v5M15 7v5M6 12v5M12 12v5M18 12v5",
  room: "M4 5h16v14H4zM14 19v-5h6",
  door: "M6 20V4M6 20h12M6 6c8 0 12 6 12 14",
  hallway: "M3 8h18M3 16h18M6 12h12M15 9.5l3 2.5-3 2.5",
};

export function KindIcon({ kind }: { kind: MeasureKind }) {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={kPaths[kind]} />
    </svg>
  );
}
