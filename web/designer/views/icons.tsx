// Small drawings of what a node does, on a grid of 24. Decoration only: the words beside them say it.
import type { ReactElement } from "react";
import { symbolOf } from "../drawing/form.ts";
import { Node_Shape } from "../session/protocol.ts";

const kPaths: Record<string, string> = {
  motor: "M4 12h13M12 6l6 6-6 6",
  avoid: "M3 20c5-1 6-8 12-12M11 7l4.500.8-.5 4.500M19 19a3 3 0 1 1-6 0 3 3 0 0 1 6 0z",
  noise: "M3 12l3-6 3 11 3-9 3 8 3-6 3 2",
  goal: "M6 21V4l11 4-11 5",
  follow: "M4 18c6 0 4-12 10-12M14 3l4 3-4 3",
  sense: "M3 12s3.500-6 9-6 9 6 9 6-3.500 6-9 6-9-6-9-6zM12 14.500a2.500 2.500 0 1 0 0-5 2.500 2.500 0 0 0 0 5z",
  skill: "M4 7h16v12H4zM8 7V4h8v3M4 12h16",
  trigger: "M13 3L5 14h6l-1 7 8-11h-6z",
  operator: "M5 6l7 6-7 6M12 12h8",
  sequence:
    "M7 7a2.500 2.500 0 1 1-5 0 2.500 2.500 0 0 1 5 0zM22 7a2.500 2.500 0 1 1-5 0 2.500 2.500 0 0 1 5 0zM14.500 18a2.500 2.500 0 1 1-5 0 2.500 2.500 0 0 1 5 0zM7 7h10M5.500 9.500l4.500 6.500M18.500 9.500L14 16",
  value: "M5 8h14M5 16h14M10 5v6M15 13v6",
  body: "M6 9h12v9H6zM12 9V5M9.500 13.500v.1M14.500 13.500v.1M3 12v3M21 12v3",
  society:
    "M8 11a3 3 0 1 0 0-6 3 3 0 0 0 0 6zM17 12a2.500 2.500 0 1 0 0-5 2.500 2.500 0 0 0 0 5zM3 20c.5-4 2.500-6 5-6s4.500 2 5 6M15 15c3-.8 5 1 6 4.500",
  logic: "M5 6h6a6 6 0 0 1 0 12H5z",
  formula: "M4 8h7M7.500 4.500v7M14 8h6M5 14.500l5 5M10 14.500l-5 5M14 15.500h6M14 18.500h6",
  delay: "M12 7v5l3 2M20 12a8 8 0 1 1-16 0 8 8 0 0 1 16 0z",
  unknown: "M9 9a3 3 0 1 1 4.200 2.800c-.8.4-1.200 1-1.200 1.900v.5M12 17.600v.1",
  note: "M5 4h14v11l-5 5H5zM14 20v-5h5",
  class: "M4 17h16M6 17V9h9l3 4v4M8.500 19.500a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM16 19.500a2 2 0 1 0 0-4 2 2 0 0 0 0 4z",
};

const kAlso: Record<string, string> = {
  cooperate: "operator",
  compete: "operator",
  select: "operator",
  parameter: "value",
  assemblage: "skill",
  class: "class",
  actuator: "motor",
  robot: "body",
  team: "society",
  caste: "society",
  binding: "body",
};

const kByShape: Partial<Record<Node_Shape, string>> = {
  [Node_Shape.BEHAVIOR]: "motor",
  [Node_Shape.PERCEPTION]: "sense",
  [Node_Shape.ASSEMBLAGE]: "skill",
  [Node_Shape.BINDING]: "body",
  [Node_Shape.SEQUENCE]: "sequence",
  [Node_Shape.LOGIC]: "logic",
  [Node_Shape.DELAY]: "delay",
  [Node_Shape.PARAMETER]: "value",
  [Node_Shape.UNKNOWN]: "unknown",
  [Node_Shape.ACTUATOR]: "motor",
  [Node_Shape.DECLARATION]: "skill",
  [Node_Shape.ROBOT]: "body",
  [Node_Shape.TEAM]: "society",
  [Node_Shape.CASTE]: "society",
  [Node_Shape.SOCIETY]: "society",
  [Node_Shape.FORMULA]: "formula",
  [Node_Shape.BODY]: "body",
  [Node_Shape.SENSOR]: "sense",
};

/** The path of an icon: by what the palette calls it, by what the component's name says, by its shape. */
export function iconPath(icon: string, component: string, shape: Node_Shape): string {
  const byName = icon !== "" ? kPaths[kAlso[icon] ?? icon] : undefined;
  if (byName) return byName;
  if (shape === Node_Shape.BEHAVIOR) {
    if (/avoid|swirl|escape/i.test(component)) return kPaths.avoid!;
    if (/noise|wander|random/i.test(component)) return kPaths.noise!;
    if (/goal|move ?to|goto|dock|place/i.test(component)) return kPaths.goal!;
    if (/follow|intercept|lead|path|road/i.test(component)) return kPaths.follow!;
  }
  return kPaths[kByShape[shape] ?? "operator"] ?? kPaths.operator!;
}

export function NodeIcon({
  icon,
  component,
  shape,
}: {
  icon: string;
  component: string;
  shape: Node_Shape;
}): ReactElement {
  const symbol = symbolOf(shape);
  if (symbol !== "" && symbol.length < 3 && shape !== Node_Shape.SEQUENCE) {
    return (
      <span className="node-glyph" aria-hidden="true">
        {symbol}
      </span>
    );
  }
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={iconPath(icon, component, shape)} />
    </svg>
  );
}
