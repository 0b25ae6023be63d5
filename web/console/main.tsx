import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Connection, tabKey } from "../core/connection.ts";
import { Model } from "../core/model.ts";
import { App } from "./app.tsx";

const model = new Model();
const connection = new Connection(model, {
  page: new URL(window.location.href),
  clientKey: tabKey(window.sessionStorage),
});
connection.connect();

createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <App session={{ model, connection }} />
  </StrictMode>,
);
