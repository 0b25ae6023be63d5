import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "./app.tsx";
import { prepareLayout } from "./arrange/layout.ts";
import { Designer } from "./designer.ts";
import { createState } from "./state.ts";

const designer = new Designer(createState(window.localStorage, window.innerWidth), new URL(window.location.href));
designer.link.connect();
prepareLayout();
window.addEventListener("popstate", () => designer.followAddress());
window.addEventListener("hashchange", () => designer.followAddress());

createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <App designer={designer} />
  </StrictMode>,
);
