// What is seen, and how.
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { camera, fit } from "../sight/view.ts";

export function viewActions(designer: Designer): Action[] {
  const { store, state } = designer;
  const { shown } = state;
  const toggle = (
    name: "palette" | "details" | "text" | "problems" | "minimap" | "grid" | "live" | "tests",
    label: string,
    shortcut: string,
  ): Action => ({
    id: `show-${name}`,
    label: `${shown[name] ? "Hide" : "Show"} ${label}`,
    group: "View",
    shortcut,
    run: () => designer.show({ [name]: !shown[name] }),
  });
  return [
    ...cameraActions(state.selection),
    toggle("palette", "the components", "b"),
    toggle("details", "the details", "d"),
    toggle("text", "the text", "t"),
    toggle("problems", "the problems", "p"),
    toggle("minimap", "the overview", "m"),
    toggle("grid", "the grid", "g"),
    ...(designer.extensions.tests ? [toggle("tests", "the tests", "shift+t")] : []),
    ...(designer.extensions.live ? [toggle("live", "the map", "r")] : []),
    {
      id: "theme",
      label: `Colours: ${{ auto: "as the system", light: "light", dark: "dark" }[state.theme]}`,
      group: "View",
      icon: "sun",
      run: () => store.setState({ theme: ({ auto: "light", light: "dark", dark: "auto" } as const)[state.theme] }),
    },
  ];
}

function cameraActions(selection: readonly string[]): Action[] {
  return [
    { id: "fit", label: "Fit everything", group: "View", icon: "fit", shortcut: "f", run: () => fit() },
    {
      id: "fit-selection",
      label: "Fit the selection",
      group: "View",
      shortcut: "shift+1",
      also: ["!"],
      run: () => fit(selection),
    },
    {
      id: "zoom-in",
      label: "Zoom in",
      group: "View",
      icon: "plus",
      shortcut: "+",
      also: ["="],
      run: () => void camera()?.zoomIn({ duration: 120 }),
    },
    {
      id: "zoom-out",
      label: "Zoom out",
      group: "View",
      icon: "minus",
      shortcut: "-",
      run: () => void camera()?.zoomOut({ duration: 120 }),
    },
    {
      id: "zoom-one",
      label: "Actual size",
      group: "View",
      shortcut: "1",
      run: () => void camera()?.zoomTo(1, { duration: 120 }),
    },
  ];
}
