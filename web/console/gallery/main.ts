// A page for tests: draws made-up sessions as its address says, without a server.
//   ?scene=demo-c|everything|lab|crowd  &theme=dark  &military=1  &watched=1  &count=10000  &renderer=webgl|canvas
import { create } from "@bufbuild/protobuf";
import { MapView } from "../../core/map/map_view.ts";
import { type MapSettings, withLayer } from "../../core/map_settings.ts";
import { Model } from "../../core/model.ts";
import { ToBrowserSchema } from "../../core/protocol.ts";
import { selectRobots } from "../../core/selection.ts";
import { measure } from "./feed.ts";
import { crowd, demoC, everything, frameOf, robotLab, type Session } from "./scenes.ts";
import { watchedFrame } from "./watched_frame.ts";

const query = new URLSearchParams(window.location.search);
const model = new Model();

function sessionOf(name: string | null): Session {
  switch (name) {
    case "everything":
      return everything();
    case "lab":
      return robotLab();
    case "crowd":
      return crowd(Number(query.get("count") ?? 1000));
    default:
      return demoC();
  }
}

const session = sessionOf(query.get("scene"));
model.accept(create(ToBrowserSchema, { body: { case: "roster", value: session.roster } }));
model.accept(create(ToBrowserSchema, { body: { case: "scene", value: session.scene } }));
model.updateMap({
  theme: query.get("theme") === "dark" ? "dark" : "light",
  military: query.has("military"),
  robotLabels: query.has("labels") ? "all" : "selected",
  circleRobots: query.has("circles"),
  trails: query.get("trails") === "stay" ? "stay" : "fade",
  renderer: (query.get("renderer") ?? "auto") as MapSettings["renderer"],
});
const map = new MapView(document.getElementById("map")!, model);

if (query.has("watched")) {
  model.set("map", withLayer(withLayer(model.get("map"), "stations", true), "vectors", true));
  for (let i = 60; i >= 0; --i) {
    const back = session.robots.map((robot) => ({
      ...robot,
      x: robot.x - i * 2.2 * (session.scene.width! / 1100),
      y: robot.y + 10 * (session.scene.width! / 1100) * Math.sin(i / 9 + robot.id) * Math.min(1, i / 20),
    }));
    model.takeFrame(frameOf(back, 60 - i, (60 - i) * 2));
  }
  model.select(selectRobots(query.get("watched") === "all" ? session.robots.map(({ id }) => id) : [1]));
  model.takeFrame(watchedFrame(session, 61, 124));
} else {
  model.takeFrame(frameOf(session.robots, 1, 0));
}
Object.assign(window, {
  map,
  model,
  measure: (seconds: number) => measure(map, model, session.robots.length, seconds),
});
requestAnimationFrame(() => requestAnimationFrame(() => document.body.setAttribute("data-drawn", "yes")));
