// Beside the goal on the map: what to do there, the MDL that it means, and who is meant, before it is sent.
import {
  type CSSProperties,
  type KeyboardEvent,
  type RefObject,
  useEffect,
  useLayoutEffect,
  useMemo,
  useRef,
  useState,
} from "react";
import { createPortal } from "react-dom";
import { useStore } from "zustand";
import { idRanges } from "../../core/format.ts";
import type { MapView } from "../../core/map/map_view.ts";
import {
  decimalsFor,
  type FormationName,
  kFormations,
  kTasks,
  kTechniques,
  type MdlPlace,
  mdlText,
  type TaskName,
  type TechniqueName,
  taskInfo,
} from "../../core/mdl_text.ts";
import type { Reply } from "../../core/protocol.ts";
import { Button, Segments } from "../../ui/controls/controls.tsx";
import { NumberEntry } from "../../ui/controls/number_entry.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { useMayOrder, usePart, useSession, useUi } from "../session/session.ts";
import { addressedUnits } from "./addressed.ts";
import { placeMeasures } from "./command_tool.ts";
import "./order_window.css";
import { dropGoal, type Goal, orderStore, takesMorePlaces } from "./order_store.ts";
import { placeFor, referenceTo } from "./places.ts";
import { DiagnosticsView, TargetsView } from "./targets_view.tsx";

/** Over the map while the command tool is held. */
export function CommandOptions() {
  const map = useUi("map");
  const order = useStore(orderStore);
  const { goal, isDragging } = order;
  const { units, robots, note } = useAddressed();
  const whom = robots.length > 0 ? `${robots.length === 1 ? "robot" : "robots"} ${idRanges(robots)}` : units.join(", ");
  return (
    <>
      <span className="small">
        {whom !== "" ? (
          <>
            For <b>{whom}</b>:{" "}
            {takesMorePlaces(order)
              ? "click the places, one after the other; Backspace takes the last one back."
              : "click the goal, drag for the formation’s heading."}
          </>
        ) : (
          note
        )}
      </span>
      {map && goal && !isDragging && map.host.parentElement
        ? createPortal(<OrderWindow map={map} goal={goal} />, map.host.parentElement)
        : null}
    </>
  );
}

function useAddressed() {
  const selection = usePart("selection");
  const roster = usePart("roster");
  return useMemo(() => {
    const units = roster.units.map((u) => ({ name: u.name, robots: roster.robotsOf(u.name) }));
    return addressedUnits(selection, units);
  }, [selection, roster]);
}

function OrderWindow({ map, goal }: { map: MapView; goal: Goal }) {
  const session = useSession();
  const mayOrder = useMayOrder();
  const scene = usePart("scene");
  const order = useStore(orderStore);
  const addressed = useAddressed();
  const window = useRef<HTMLDivElement>(null);
  const style = usePlace(window, map, goal, order.heading);
  const [place, setPlace] = useState<MdlPlace>(() => placeOf(session, goal, scene?.origin));
  useEffect(() => setPlace(placeOf(session, goal, scene?.origin)), [goal]);
  useEffect(() => window.current?.querySelector<HTMLElement>("[aria-checked=true], button, input")?.focus(), []);

  const line = goal.line === null ? null : referenceTo(placeMeasures(session), goal.line);
  const built = mdlText({
    units: addressed.units,
    robots: addressed.robots,
    task: order.task,
    place: order.task === "FOLLOW" && line !== null ? { reference: line } : place,
    formation: order.formation,
    technique: order.technique,
    speed: order.speed,
    heading: order.heading,
    more: order.more.map((one) => placeOf(session, one, scene?.origin)),
    swath: order.swath,
  });
  const text = "text" in built ? built.text : "";
  const preview = usePreview(text);
  const [refusal, setRefusal] = useState("");
  const isWrong = preview !== null && !preview.ok;

  const send = async () => {
    if (text === "" || !mayOrder) return;
    const reply = await session.connection.ask({ case: "typed", value: { line: text, preview: false } });
    if (reply.ok) dropGoal();
    else setRefusal(reply.error || reply.diagnostics[0]?.message || "the server refused it");
  };
  const keys = (event: KeyboardEvent) => {
    if (event.key === "Escape") dropGoal();
    else if (event.key === "Enter" && !(event.target instanceof HTMLButtonElement)) void send();
    else return;
    event.preventDefault();
    event.stopPropagation();
    map.host.focus({ preventScroll: true });
  };

  return (
    <div ref={window} className="order-window" style={style} role="dialog" aria-label="Command" onKeyDown={keys}>
      <div className="order-fields">
        <OrderFields line={line} place={place} onPlace={setPlace} />
        <code className="order-text">{text || ("error" in built ? built.error : "")}</code>
        <OrderVerdict text={text} note={addressed.note} preview={preview} refusal={refusal} />
      </div>
      <footer>
        <Button tone="quiet" isDisabled={text === ""} onPress={() => edit(session, text)}>
          Edit as text
        </Button>
        <Button onPress={dropGoal}>Cancel</Button>
        <Button tone="primary" isDisabled={text === "" || isWrong || !mayOrder} onPress={send}>
          Send
        </Button>
      </footer>
    </div>
  );
}

interface OrderFieldsProps {
  /** What the goal's line is called; null: the goal is on none that has a name. */
  line: string | null;
  place: MdlPlace;
  onPlace: (place: MdlPlace) => void;
}

function OrderFields({ line, place, onPlace }: OrderFieldsProps) {
  const order = useStore(orderStore);
  const info = taskInfo(order.task);
  const isOnPlace = order.goal !== null && order.goal.measure !== null;
  const tasks = kTasks.filter((t) => (t.place !== "line" || line !== null) && (t.place !== "area" || isOnPlace));
  return (
    <>
      <Segments<TaskName>
        label="Task"
        value={order.task}
        choices={tasks.map((t) => [t.task, t.label] as const)}
        onChange={(task) => orderStore.setState({ task })}
      />
      <p className="help">{info.help}.</p>
      <div className="world-fields">
        {order.task === "FOLLOW" ? (
          <div className="field wide">
            <span className="label">Line</span>
            <b>{line}</b>
          </div>
        ) : (
          <PlaceEntry place={place} onPlace={onPlace} />
        )}
        {info.place === "places" && (
          <div className="field wide">
            <span className="label">{order.more.length === 0 ? "1 place" : `${order.more.length + 1} places`}</span>
            <span className="small">
              Click the map for another one.
              {order.more.length > 0 && (
                <Button tone="quiet" onPress={() => orderStore.setState({ more: order.more.slice(0, -1) })}>
                  Take the last one back
                </Button>
              )}
            </span>
          </div>
        )}
        {info.takesSwath && (
          <NumberEntry
            label="Swath [m]"
            value={order.swath}
            min={0}
            whenZero="10"
            onCommit={(swath) => orderStore.setState({ swath })}
          />
        )}
        {info.takesFormation && (
          <SelectEntry<FormationName | "">
            label="Formation"
            value={order.formation}
            choices={[["", "as it is"], ...kFormations.map((f) => [f, f] as const)]}
            onChange={(formation) => orderStore.setState({ formation })}
          />
        )}
        {info.takesTechnique && (
          <SelectEntry<TechniqueName | "">
            label="Technique"
            value={order.technique}
            choices={[["", "Traveling (usual)"], ...kTechniques.slice(1).map((t) => [t, t] as const)]}
            onChange={(technique) => orderStore.setState({ technique })}
          />
        )}
        {info.takesSpeed && (
          <NumberEntry
            label="Speed [m/s]"
            value={order.speed}
            min={0}
            whenZero="the robots’ own"
            onCommit={(speed) => orderStore.setState({ speed })}
          />
        )}
        {info.takesHeading && (
          <HeadingEntry heading={order.heading} onHeading={(heading) => orderStore.setState({ heading })} />
        )}
      </div>
    </>
  );
}

interface OrderVerdictProps {
  /** In MDL; empty: nothing can be sent. */
  text: string;
  note: string;
  preview: Reply | null;
  /** Why it was not taken when it was sent; empty: it was not sent. */
  refusal: string;
}

/** Whom it would be sent to, or what is wrong with it. */
function OrderVerdict({ text, note, preview, refusal }: OrderVerdictProps) {
  return (
    <div className="order-targets" role="status">
      {note !== "" && <p className="small target-replaces">{note}</p>}
      {preview && preview.diagnostics.length > 0 && <DiagnosticsView line={text} diagnostics={preview.diagnostics} />}
      {preview?.result.case === "targets" && <TargetsView targets={preview.result.value} />}
      {preview && !preview.ok && preview.diagnostics.length === 0 && <p className="problem">{preview.error}</p>}
      {refusal !== "" && <p className="problem">{refusal}</p>}
    </div>
  );
}

function edit(session: ReturnType<typeof useSession>, line: string): void {
  session.ui.set("draft", { line });
  dropGoal();
}

/** `310 205` or a name. */
function PlaceEntry({ place, onPlace }: { place: MdlPlace; onPlace: (place: MdlPlace) => void }) {
  const shown = "reference" in place ? place.reference : `${place.x} ${place.y}`;
  const [text, setText] = useState(shown);
  useEffect(() => setText(shown), [shown]);
  const commit = () => {
    const trimmed = text.trim();
    const numbers = /^(-?\d+(?:\.\d+)?)[\s,]+(-?\d+(?:\.\d+)?)$/.exec(trimmed);
    if (numbers) onPlace({ x: Number(numbers[1]), y: Number(numbers[2]) });
    else if (trimmed !== "") onPlace({ reference: trimmed });
    else setText(shown);
  };
  return (
    <label className="field">
      <span className="label">Place</span>
      <input className="input" value={text} onChange={(event) => setText(event.target.value)} onBlur={commit} />
    </label>
  );
}

function HeadingEntry({ heading, onHeading }: { heading: number | null; onHeading: (heading: number | null) => void }) {
  const shown = heading === null ? "" : String(heading);
  const [text, setText] = useState(shown);
  useEffect(() => setText(shown), [shown]);
  const commit = () => {
    const value = Number(text.replace("°", ""));
    if (text.trim() === "") onHeading(null);
    else if (Number.isFinite(value) && Math.abs(value) <= 360) onHeading(value);
    else setText(shown);
  };
  return (
    <label className="field">
      <span className="label">Heading [°]</span>
      <input
        className="input"
        value={text}
        placeholder="where it goes"
        title="Degrees counter-clockwise from east"
        inputMode="numeric"
        onChange={(event) => setText(event.target.value)}
        onBlur={commit}
      />
    </label>
  );
}

/** Who would be meant, asked for a moment after the text has changed. */
function usePreview(text: string): Reply | null {
  const { connection } = useSession();
  const [reply, setReply] = useState<Reply | null>(null);
  useEffect(() => {
    if (text === "") {
      setReply(null);
      return;
    }
    let isOld = false;
    const timer = setTimeout(async () => {
      const answer = await connection.ask({ case: "typed", value: { line: text, preview: true } });
      if (!isOld) setReply(answer);
    }, 120);
    return () => {
      isOld = true;
      clearTimeout(timer);
    };
  }, [connection, text]);
  return reply;
}

const kWidth = 370;
const kMargin = 8;

/** Beside the goal, not where the formation looks if there is room; all of it on the map, which it follows. */
function usePlace(
  window: RefObject<HTMLElement | null>,
  map: MapView,
  goal: Goal,
  heading: number | null,
): CSSProperties {
  const [, setVersion] = useState(0);
  const [tall, setTall] = useState(0);
  useEffect(() => map.subscribe(() => setVersion((v) => v + 1)), [map]);
  useLayoutEffect(() => {
    const element = window.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setTall(element.offsetHeight));
    observer.observe(element);
    return () => observer.disconnect();
  }, [window]);
  const at = map.camera.toScreen(goal.at);
  const { width, height } = map.camera;
  const looksRight = heading !== null && Math.cos((heading * Math.PI) / 180) > 0;
  const fitsRight = at.x + 48 + kWidth < width;
  const fitsLeft = at.x - 48 - kWidth > 64;
  const isRight = fitsRight && fitsLeft ? !looksRight : fitsRight || at.x < width / 2;
  const left = isRight ? at.x + 48 : at.x - 48 - kWidth;
  return {
    left: Math.max(kMargin, Math.min(left, width - kWidth - kMargin)),
    top: Math.max(kMargin, Math.min(at.y - 120, height - tall - kMargin)),
    width: Math.min(kWidth, width - 2 * kMargin),
    maxHeight: height - 2 * kMargin,
  };
}

function placeOf(
  session: ReturnType<typeof useSession>,
  goal: Goal,
  origin: { x: number; y: number } | undefined,
): MdlPlace {
  const scale = session.ui.get("map")?.camera.scale ?? 1;
  return placeFor(placeMeasures(session), goal.measure, goal.at, origin ?? { x: 0, y: 0 }, decimalsFor(1 / scale));
}
