import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Connection, tabKey } from "../core/connection.ts";
import { Model } from "../core/model.ts";
import { pageOf } from "../core/pace.ts";
import { App } from "./app.tsx";
import { Ui } from "./session/ui.ts";

const model = new Model();
const roomNow = () => ({ width: window.innerWidth, height: window.innerHeight });
const ui = new Ui(model, window.localStorage, roomNow());
window.addEventListener("resize", () => ui.set("room", roomNow()));
const connection = new Connection(model, {
  page: new URL(window.location.href),
  name: ui.get("name"),
  clientKey: tabKey(window.sessionStorage),
});
connection.connect();
const session = { model, connection, ui, pace: pageOf(document) };

createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <App session={session} />
  </StrictMode>,
);
