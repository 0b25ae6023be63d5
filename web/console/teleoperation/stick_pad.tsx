// The stick on the screen: a round pad with a knob, a needle to the objective, and the directions of its frame.
import { type PointerEvent, useId, useRef } from "react";
import { kCentre, type StickVector, stickOfPointer } from "./stick.ts";
import { kHoldKey } from "./use_sticks.ts";

interface Props {
  unit: string;
  stick: StickVector;
  isHeld: boolean;
  robotFrame: boolean;
  /** Radians clockwise from up; null: no objective is known. */
  needle: number | null;
  isDisabled: boolean;
  onMove: (stick: StickVector) => void;
  onRelease: () => void;
  onFocus: () => void;
  onBlur: () => void;
}

const kRadius = 78; // of the pad, in units of the drawing
const kReach = 56; // of the knob

export function StickPad(props: Props) {
  const { stick, robotFrame, needle, isDisabled } = props;
  const pad = useRef<HTMLDivElement>(null);
  const pointer = useRef<number | null>(null);
  const help = useId();

  const at = (event: PointerEvent): StickVector => {
    const box = pad.current?.getBoundingClientRect();
    if (!box) return kCentre;
    const radius = (box.width / 2) * (kReach / 90);
    return stickOfPointer(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2, radius);
  };
  const letGo = (event: PointerEvent) => {
    if (pointer.current !== event.pointerId) return;
    pointer.current = null;
    props.onRelease();
  };

  return (
    <div
      ref={pad}
      className="stick-pad"
      data-stick={props.unit}
      data-held={props.isHeld || undefined}
      role="application"
      aria-roledescription="stick"
      aria-label={`Stick of ${props.unit}`}
      aria-describedby={help}
      aria-disabled={isDisabled || undefined}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: keys steer while it has the focus
      tabIndex={0}
      onFocus={props.onFocus}
      onBlur={props.onBlur}
      onContextMenu={(event) => event.preventDefault()}
      onPointerDown={(event) => {
        if (isDisabled || pointer.current !== null || event.button !== 0) return;
        pointer.current = event.pointerId;
        event.currentTarget.setPointerCapture(event.pointerId);
        props.onMove(at(event));
      }}
      onPointerMove={(event) => {
        if (pointer.current === event.pointerId) props.onMove(at(event));
      }}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
    >
      <svg viewBox="-90 -90 180 180" aria-hidden="true">
        <circle className="stick-plate" r={kRadius} />
        <circle className="stick-ring" r={kReach} />
        <path className="stick-cross" d={`M-${kReach} 0H${kReach}M0 -${kReach}V${kReach}`} />
        {marks(robotFrame).map(([text, x, y]) => (
          <text key={text} className="stick-mark" x={x} y={y}>
            {text}
          </text>
        ))}
        {needle !== null && (
          <path
            className="stick-needle"
            d={`M0 -${kRadius + 10}l6 12h-12z`}
            transform={`rotate(${(needle * 180) / Math.PI})`}
          />
        )}
        <line className="stick-arm" x1="0" y1="0" x2={stick.x * kReach} y2={-stick.y * kReach} />
        <circle className="stick-knob" cx={stick.x * kReach} cy={-stick.y * kReach} r="20" />
      </svg>
      <span id={help} className="hidden-text">
        Press and drag, or hold the arrow keys or W, A, S, D while this has the focus; Shift slows down. Anywhere on the
        page, hold {kHoldKey.slice(3)} together with them. Letting go stops.
      </span>
    </div>
  );
}

function marks(robotFrame: boolean): [string, number, number][] {
  return robotFrame
    ? [
        ["ahead", 0, -64],
        ["back", 0, 70],
      ]
    : [
        ["N", 0, -64],
        ["E", 67, 4],
        ["S", 0, 72],
        ["W", -67, 4],
      ];
}
