// Before the looks of the designer, which win.
import "./panes/live.css";
import "./tests/tests.css";

import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "../designer/app.tsx";
import { prepareLayout } from "../designer/arrange/layout.ts";
import { Designer } from "../designer/session/designer.ts";
import { createState } from "../designer/session/state.ts";
import { extensions } from "./extensions.ts";

const state = createState(window.localStorage, window.innerWidth);
const designer = new Designer(state, new URL(window.location.href), extensions);
designer.link.connect();
prepareLayout();
window.addEventListener("popstate", () => designer.navigation.followAddress());
window.addEventListener("hashchange", () => designer.navigation.followAddress());

createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <App designer={designer} />
  </StrictMode>,
);
