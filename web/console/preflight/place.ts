import type { PanelPlace } from "../session/layout.ts";

/** Where the panel stands until somebody moves it. */
export const kPreflightPlace: PanelPlace = { id: "preflight", title: "Pre-flight", dock: "left" };
