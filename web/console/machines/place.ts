import type { PanelPlace } from "../session/layout.ts";

/** Where the panel stands until somebody moves it. */
export const kMachinesPlace: PanelPlace = { id: "machines", title: "Machines", dock: "right" };
