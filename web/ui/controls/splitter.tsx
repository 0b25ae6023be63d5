// A border that can be dragged, or moved with arrow keys while it has the focus.
import { type PointerEvent, useRef, useState } from "react";

interface SplitterProps {
  side: "left" | "right" | "bottom";
  label: string;
  /** [px] */
  size: number;
  least: number;
  most: number;
  onSize: (size: number) => void;
}

export function Splitter({ side, label, size, least, most, onSize }: SplitterProps) {
  const drag = useRef<{ at: number; size: number } | null>(null);
  const [dragged, setDragged] = useState(false);
  const set = (next: number) => onSize(Math.round(Math.min(most, Math.max(least, next))));
  const along = (event: PointerEvent) => (side === "bottom" ? event.clientY : event.clientX);
  const larger = { left: "ArrowRight", right: "ArrowLeft", bottom: "ArrowUp" }[side];
  const smaller = { left: "ArrowLeft", right: "ArrowRight", bottom: "ArrowDown" }[side];
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that can be moved is no <hr>
    <div
      className={`splitter ${side} ${dragged ? "dragged" : ""}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={side === "bottom" ? "horizontal" : "vertical"}
      aria-valuenow={size}
      aria-valuemin={least}
      aria-valuemax={most}
      onKeyDown={(event) => {
        if (event.key !== larger && event.key !== smaller) return;
        event.preventDefault();
        set(size + (event.key === larger ? 16 : -16));
      }}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { at: along(event), size };
        setDragged(true);
      }}
      onPointerMove={(event) => {
        if (!drag.current) return;
        const moved = along(event) - drag.current.at;
        set(drag.current.size + (side === "left" ? moved : -moved));
      }}
      onLostPointerCapture={() => {
        drag.current = null;
        setDragged(false);
      }}
    />
  );
}
