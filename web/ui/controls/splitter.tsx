// A border that can be dragged, or moved with arrow keys while it has the focus.
import { type PointerEvent, useRef } from "react";

interface SplitterProps {
  side: "left" | "right" | "bottom";
  label: string;
  size: number;
  onSize: (size: number) => void;
}

const kLeast = 160;

export function Splitter({ side, label, size, onSize }: SplitterProps) {
  const drag = useRef<{ at: number; size: number } | null>(null);
  const most = side === "bottom" ? window.innerHeight - 240 : Math.max(320, window.innerWidth - 700);
  const set = (next: number) => onSize(Math.round(Math.min(most, Math.max(side === "bottom" ? 100 : kLeast, next))));
  const along = (event: PointerEvent) => (side === "bottom" ? event.clientY : event.clientX);
  const larger = { left: "ArrowRight", right: "ArrowLeft", bottom: "ArrowUp" }[side];
  const smaller = { left: "ArrowLeft", right: "ArrowRight", bottom: "ArrowDown" }[side];
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that can be moved is no <hr>
    <div
      className={`splitter ${side}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={side === "bottom" ? "horizontal" : "vertical"}
      aria-valuenow={size}
      aria-valuemin={kLeast}
      aria-valuemax={most}
      onKeyDown={(event) => {
        if (event.key !== larger && event.key !== smaller) return;
        event.preventDefault();
        set(size + (event.key === larger ? 16 : -16));
      }}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { at: along(event), size };
      }}
      onPointerMove={(event) => {
        if (!drag.current) return;
        const moved = along(event) - drag.current.at;
        set(drag.current.size + (side === "left" ? moved : -moved));
      }}
      onLostPointerCapture={() => {
        drag.current = null;
      }}
    />
  );
}
