// Line icons on a grid of 24. Decoration only: what a control does is said by its label.
import type { ReactElement } from "react";

const kPaths = {
  copy: "M9 9h11v11H9zM5 15H4V4h11v1",
  menu: "M4 7h16M4 12h16M4 17h16",
  play: "M8 5.5v13l11-6.5z",
  play_back: "M16 5.5v13L5 12z",
  cycle_back: "M18 5.5v13L9 12zM5.5 9v6",
  cycle_on: "M6 5.5v13l9-6.5zM18.5 9v6",
  event_back: "M12 6l-6 6 6 6M19 12l-3.5-3.5L12 12l3.5 3.5z",
  event_on: "M12 6l6 6-6 6M5 12l3.5-3.5L12 12l-3.5 3.5z",
  breakpoint: "M12 20.5a8.5 8.5 0 1 0 0-17 8.5 8.5 0 0 0 0 17zM10 9v6M14 9v6",
  pause: "M8 5v14M16 5v14",
  stop: "M8.2 3h7.6L21 8.2v7.6L15.8 21H8.2L3 15.8V8.2zM8.5 12h7",
  step: "M6 5.5v13l9-6.5zM18.5 5.5v13",
  skip: "M5 6l6 6-6 6M13 6l6 6-6 6",
  cycle: "M12 6v6l4 2M21 12a9 9 0 1 1-3-6.7M21 4v4h-4",
  rewind: "M19 18.5v-13L9 12zM5.5 5.5v13",
  restart: "M4 12a8 8 0 1 0 2.6-5.9M4 4v4.5h4.5",
  abort: "M6 6l12 12M18 6L6 18",
  question: "M9 9a3 3 0 1 1 4.2 2.8c-.8.4-1.2 1-1.2 1.9v.5M12 17.6v.1M21 12a9 9 0 1 1-18 0 9 9 0 0 1 18 0z",
  hand: "M8 13V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2.5 6.5-5.5 6.5-3.5 0-4.7-2-7.5-6.5-.7-1.2 1-2.5 2-1.5z",
  warning: "M12 4l9 16H3zM12 10v4.5M12 17.3v.1",
  release: "M7 11V8a5 5 0 0 1 9.6-2M5 11h14v9H5z",
  steps: "M4 6h2M4 12h2M4 18h2M10 6h10M10 12h10M10 18h10",
  robots: "M5 9h14v9H5zM12 9V5M12 4.5v.1M9 13.5v.1M15 13.5v.1M2.5 12v3M21.5 12v3",
  selection: "M4 8V4h4M16 4h4v4M20 16v4h-4M8 20H4v-4M12 9.5v5M9.5 12h5",
  why: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM9.5 9.5a2.5 2.5 0 1 1 3.5 2.3c-.7.3-1 .8-1 1.5v.4M12 16.8v.1",
  command: "M5 6l6 6-6 6M13 18h6",
  text: "M6 3h8l4 4v14H6zM14 3v4h4M9 12h6M9 16h6",
  log: "M5 5h14v14H5zM8 9h8M8 12h8M8 15h5",
  plot: "M4 4v16h16M7 15l4-5 3 3 5-7",
  gear: "M12 15a3 3 0 1 0 0-6 3 3 0 0 0 0 6zM12 2.8v3M12 18.2v3M5.5 5.5l2.1 2.1M16.4 16.4l2.1 2.1M2.8 12h3M18.2 12h3M5.5 18.5l2.1-2.1M16.4 7.6l2.1-2.1",
  layers: "M12 3l9 5-9 5-9-5zM3.5 12.5L12 17l8.5-4.5M3.5 16.5L12 21l8.5-4.5",
  close: "M6 6l12 12M18 6L6 18",
  bookmark: "M7 4h10v16l-5-4.5L7 20z",
  bookmarks: "M4 4h8v13l-4-3.5L4 17zM15 6h6M15 11h6M15 16h6",
  bin: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13",
  search: "M10.5 17a6.5 6.5 0 1 0 0-13 6.5 6.5 0 0 0 0 13zM15.5 15.5L20 20",
  undo: "M8 5L4 9l4 4M4 9h10a5.5 5.5 0 0 1 0 11h-3",
  redo: "M16 5l4 4-4 4M20 9H10a5.5 5.5 0 0 0 0 11h3",
  fit: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  plus: "M12 5v14M5 12h14",
  minus: "M5 12h14",
  centre: "M12 3v4M12 17v4M3 12h4M17 12h4M16 12a4 4 0 1 1-8 0 4 4 0 0 1 8 0z",
  follow: "M12 21s7-6 7-11a7 7 0 1 0-14 0c0 5 7 11 7 11zM12 12.5a2.5 2.5 0 1 0 0-5 2.5 2.5 0 0 0 0 5z",
  pointer: "M6 3l13 8-6 1.5L10 19z",
  ruler: "M3 16L16 3l5 5L8 21zM7 12l2 2M10 9l2 2M13 6l2 2",
  more: "M6 12v.1M12 12v.1M18 12v.1",
  down: "M7 10l5 5 5-5",
  up: "M7 14l5-5 5 5",
  right: "M10 7l5 5-5 5",
  file: "M6 3h8l4 4v14H6zM14 3v4h4",
  folder: "M3 7h6l2 2h10v10H3z",
  map: "M9 4L3 6.5v13.5l6-2.5 6 2.5 6-2.5V4l-6 2.5zM9 4v13.5M15 6.5V20",
  save: "M5 4h11l3 3v13H5zM8 4v5h7V4M8 20v-6h8v6",
  person: "M12 12a4 4 0 1 0 0-8 4 4 0 0 0 0 8zM4.5 20.5c1-4 4-5.5 7.5-5.5s6.5 1.5 7.5 5.5",
  sun: "M12 16a4 4 0 1 0 0-8 4 4 0 0 0 0 8zM12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M5.3 18.7l1.4-1.4M17.3 6.7l1.4-1.4",
  check: "M5 12.5l4.5 4.5L19 7.5",
  drive: "M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM12 5v2M12 17v2M5 12h2M17 12h2",
  world: "M12 3l8 4.5v9L12 21l-8-4.5v-9zM12 12l8-4.5M12 12v9M12 12L4 7.5",
  draw: "M4 20l1-4L16 5l3 3L8 19zM14 7l3 3",
  lock: "M7 11V8a5 5 0 0 1 10 0v3M5 11h14v9H5z",
  shield: "M12 3l7.5 3v5.5c0 4.5-3 7.7-7.5 9.5-4.5-1.8-7.5-5-7.5-9.5V6zM8.8 12l2.3 2.3 4.2-4.6",
  checklist: "M4 6l1.5 1.5L8 5M4 12l1.5 1.5L8 11M4 18l1.5 1.5L8 17M11 6.5h9M11 12.5h9M11 18.5h9",
  vehicle:
    "M4 14V9h9l4 3h3v4h-2M4 14v2h1M9 16h5M7 18a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM16 18a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM8 9V6M8 5.9v.1",
  machine: "M4 5h16v6H4zM4 13h16v6H4zM7.5 8v.1M7.5 16v.1M11 8h6M11 16h6",
  gauge: "M4 18a9 9 0 1 1 16 0M12 14l4-5",
} as const;

export type IconName = keyof typeof kPaths;

export function Icon({ name }: { name: IconName }): ReactElement {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={kPaths[name]} />
    </svg>
  );
}
