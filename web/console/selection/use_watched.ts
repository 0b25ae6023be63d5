import { useEffect } from "react";
import { kMostWatched } from "../../core/watching.ts";
import { usePart, useSession, useUi } from "../session/session.ts";

const kManyRobots = 2000; // beyond it frames hold only what the map shows
const kFewRobots = 1500; // up to it frames come as often as displays draw, not half as often

/** The map wants details of what is selected, and what its layers show. */
export function useWatching(): void {
  const { connection } = useSession();
  const { robots } = usePart("selection");
  const { layers, contributions } = usePart("map");
  const roster = usePart("roster");
  const map = useUi("map");
  useEffect(() => {
    connection.watching.wish("selection", {
      details: robots.slice(0, kMostWatched),
      readings: layers.readings && robots.length > 0,
    });
  }, [connection, robots, layers.readings]);
  useEffect(() => {
    connection.watching.wish("layers", { stations: layers.stations, vectors: layers.vectors });
  }, [connection, layers.stations, layers.vectors, contributions]);
  const isFew = roster.robots.length <= kFewRobots;
  useEffect(() => {
    connection.watching.wish("rate", isFew ? { rate: 60 } : null);
  }, [connection, isFew]);
  const isMany = roster.robots.length > kManyRobots;
  useEffect(() => {
    if (!map || !isMany) return;
    const tell = () => {
      const { xMin, yMin, xMax, yMax } = map.camera.visible();
      const x = (xMax - xMin) / 4;
      const y = (yMax - yMin) / 4;
      connection.watching.wish("map", { view: { xMin: xMin - x, yMin: yMin - y, xMax: xMax + x, yMax: yMax + y } });
    };
    tell();
    const end = map.subscribe(tell);
    return () => {
      end();
      connection.watching.wish("map", null);
    };
  }, [connection, map, isMany]);
}

/** What a panel wishes while it is shown. */
export function usePorts(owner: string, isShown: boolean): void {
  const { connection } = useSession();
  useEffect(() => {
    if (!isShown) return;
    connection.watching.wish(owner, { ports: true });
    return () => connection.watching.wish(owner, null);
  }, [connection, owner, isShown]);
}

/** The same, of some ports. */
export function useSomePorts(owner: string, paths: readonly string[]): void {
  const { connection } = useSession();
  const key = paths.join("\n");
  useEffect(() => {
    if (key === "") return;
    connection.watching.wish(owner, { ports: key.split("\n") });
    return () => connection.watching.wish(owner, null);
  }, [connection, owner, key]);
}
