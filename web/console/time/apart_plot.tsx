// How far the same robot is from itself in the other future, over time.
import { type MouseEvent, useMemo } from "react";
import { paletteOf } from "../../core/map/palette.ts";
import { sampleBefore } from "../../core/other_future.ts";
import type { OtherFuture, OtherFuture_Robot } from "../../core/protocol.ts";
import { momentText } from "../../core/run_time.ts";
import { distance } from "../../ui/words/format.ts";
import { usePart } from "../session/session.ts";

const kWidth = 520;
const kHeight = 130;
const kLeft = 44;
const kBottom = 18;
const kTop = 6;

interface Props {
  future: OtherFuture;
  /** At most as many as there are colours. */
  robots: readonly OtherFuture_Robot[];
  /** That is shown [s]. */
  time: number;
  onGo: (time: number) => void;
}

/** Its numbers are in the table beside it. */
export function ApartPlot({ future, robots, time, onGo }: Props) {
  const colors = paletteOf(usePart("map").theme).contributions;
  const roster = usePart("roster");
  const from = future.times[0] ?? 0;
  const to = future.times.at(-1) ?? 1;
  const most = Math.max(0.1, ...robots.map(({ mostApart }) => mostApart));
  const x = (t: number) => kLeft + ((t - from) / Math.max(1e-6, to - from)) * (kWidth - kLeft - 4);
  const y = (apart: number) => kTop + (1 - apart / most) * (kHeight - kTop - kBottom);
  const paths = useMemo(() => robots.map((robot) => pathOf(future.times, robot.apart, x, y)), [future, robots]);
  const at = sampleBefore(future.times, time);
  const isInside = time >= from - 1e-6 && time <= to + 1e-6;
  const go = (event: MouseEvent<SVGSVGElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const share = (((event.clientX - box.left) / box.width) * kWidth - kLeft) / (kWidth - kLeft - 4);
    onGo(from + Math.min(1, Math.max(0, share)) * (to - from));
  };
  return (
    <figure className="future-plot">
      <figcaption className="small">Distance between the same robot in both [m]</figcaption>
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the time line below goes to every moment by keys */}
      <svg
        viewBox={`0 0 ${kWidth} ${kHeight}`}
        role="img"
        aria-label={`Distance between the same robot in both, up to ${distance(most)}`}
        onClick={go}
      >
        <path className="axis" d={`M${kLeft} ${kTop}V${y(0)}H${kWidth - 4}`} />
        <text x={kLeft - 5} y={kTop + 8} textAnchor="end">
          {distance(most)}
        </text>
        <text x={kLeft - 5} y={y(0)} textAnchor="end">
          0
        </text>
        <text x={kLeft} y={kHeight - 3}>
          {momentText(from)}
        </text>
        <text x={kWidth - 4} y={kHeight - 3} textAnchor="end">
          {momentText(to)}
        </text>
        {paths.map((path, i) => (
          <path key={robots[i]!.robot} d={path} className="line" stroke={colors[i % colors.length]} />
        ))}
        {isInside && <path className="moment" d={`M${x(time)} ${kTop}V${y(0)}`} />}
      </svg>
      <div className="future-lines small">
        {robots.map((robot, i) => (
          <span key={robot.robot}>
            <i style={{ background: colors[i % colors.length] }} /> {roster.nameOf(robot.robot)}
            {isInside && Number.isFinite(robot.apart[at]) ? ` ${distance(robot.apart[at]!)}` : ""}
          </span>
        ))}
      </div>
    </figure>
  );
}

function pathOf(
  times: readonly number[],
  values: readonly number[],
  x: (time: number) => number,
  y: (value: number) => number,
): string {
  let path = "";
  let isDown = false;
  values.forEach((value, i) => {
    if (!Number.isFinite(value)) {
      isDown = false;
      return;
    }
    path += `${isDown ? "L" : "M"}${x(times[i]!).toFixed(1)} ${y(value).toFixed(1)}`;
    isDown = true;
  });
  return path;
}
