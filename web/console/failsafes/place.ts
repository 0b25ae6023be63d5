import type { PanelPlace } from "../session/layout.ts";

/** Where the panel stands until somebody moves it. */
export const kFailsafesPlace: PanelPlace = { id: "failsafes", title: "Failsafes", dock: "right" };
