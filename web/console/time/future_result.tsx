// What became of both: where they part, how far apart the same robot is in them, how they end.
import { aloneIn, byDistance, isAlone } from "../../core/other_future.ts";
import type { OtherFuture, OtherFuture_End, OtherFuture_Robot, OtherFuture_Robot_Fate } from "../../core/protocol.ts";
import { momentText } from "../../core/run_time.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { distance, list } from "../../ui/words/format.ts";
import { usePart, useSession } from "../session/session.ts";
import { ApartPlot } from "./apart_plot.tsx";
import { ToldApart, WarnedThere } from "./told_apart.tsx";
import { useTravel, useWhereabouts } from "./use_travel.ts";

const kMostRows = 12;

export function FutureResult({ future }: { future: OtherFuture }) {
  const { model } = useSession();
  const travel = useTravel();
  const at = useWhereabouts();
  const roster = usePart("roster");
  const robots = byDistance(future);
  const { parting } = future;
  const name = future.isRecording ? future.name : "What if";
  const own = model.isRecording() ? "The recording" : "The run";
  return (
    <div className="future-halves">
      <div>
        <p role="status">
          {parting ? (
            <>
              They part at{" "}
              <Button tone="link" onPress={() => travel.does.go(parting.time)}>
                {momentText(parting.time)}
              </Button>
              , cycle {String(parting.cycle)}.
            </>
          ) : (
            "They are the same, wherever both are known."
          )}
        </p>
        {aloneWords(future, own, name, (robot) => roster.nameOf(robot)).map((one) => (
          <p key={one}>{one}</p>
        ))}
        <WarnedThere future={future} />
        <div className="future-legend small" aria-hidden="true">
          <Sign /> {own}
          <Sign isGhost /> {name}
        </div>
        {parting && <ApartPlot future={future} robots={robots.slice(0, 8)} time={at.time} onGo={travel.does.go} />}
      </div>
      <div className="future-tables">
        <table className="state-table">
          <caption>How they end</caption>
          <thead>
            <tr>
              <th scope="col" />
              <th scope="col">Outcome</th>
              <th scope="col">Known to</th>
            </tr>
          </thead>
          <tbody>
            <EndRow name={own} end={future.own} />
            <EndRow name={name} end={future.other} />
          </tbody>
        </table>
        <table className="state-table">
          <caption>
            Each robot: {own.toLowerCase()} → {name}
          </caption>
          <thead>
            <tr>
              <th scope="col">Robot</th>
              <th scope="col">Driven</th>
              <th scope="col">Contacts</th>
              <th scope="col">Most apart</th>
            </tr>
          </thead>
          <tbody>
            {robots.slice(0, kMostRows).map((robot) => (
              <tr key={robot.robot}>
                <th scope="row">
                  {roster.nameOf(robot.robot)}
                  {onlyIn(robot, own, name) !== "" && <span className="small muted"> {onlyIn(robot, own, name)}</span>}
                </th>
                <td className="number">{both(robot, ({ driven }) => distance(driven))}</td>
                <td className="number">{both(robot, contacts)}</td>
                <td className="number">
                  {robot.mostApart > 0 ? (
                    <>
                      {distance(robot.mostApart)} at{" "}
                      <Button tone="link" onPress={() => travel.does.go(robot.mostApartAt)}>
                        {momentText(robot.mostApartAt)}
                      </Button>
                    </>
                  ) : (
                    "–"
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
        {robots.length > kMostRows && <p className="small muted">and {robots.length - kMostRows} robots more</p>}
        <ToldApart future={future} />
      </div>
    </div>
  );
}

/** Of a robot that only one of both has. */
function onlyIn(robot: OtherFuture_Robot, own: string, other: string): string {
  const side = isAlone(robot);
  return side === undefined ? "" : `only in ${quoted(side === "own" ? own : other)}`;
}

/** A run or the recording is meant by its kind, another one by its name. */
function quoted(name: string): string {
  return name.startsWith("The ") ? name.toLowerCase() : `‘${name}’`;
}

const kMostNamed = 8;

function aloneWords(future: OtherFuture, own: string, other: string, nameOf: (robot: number) => string): string[] {
  return (["own", "other"] as const).flatMap((side) => {
    const alone = aloneIn(future, side);
    if (alone.length === 0) return [];
    const names = alone.slice(0, kMostNamed).map(nameOf);
    if (alone.length > kMostNamed) names.push(`${alone.length - kMostNamed} more`);
    return [`${list(names)} ${alone.length === 1 ? "is" : "are"} in ${quoted(side === "own" ? own : other)} alone.`];
  });
}

function EndRow({ name, end }: { name: string; end: OtherFuture_End | undefined }) {
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>{end?.outcome ?? "–"}</td>
      <td className="number">{end ? momentText(end.time) : "–"}</td>
    </tr>
  );
}

function both({ own, other }: OtherFuture_Robot, text: (fate: OtherFuture_Robot_Fate) => string): string {
  const of = (fate: OtherFuture_Robot_Fate | undefined) => (fate?.isThere ? text(fate) : "–");
  return `${of(own)} → ${of(other)}`;
}

function contacts({ contacts, firstContact }: OtherFuture_Robot_Fate): string {
  return firstContact === undefined ? String(contacts) : `${contacts} (${momentText(firstContact)})`;
}

function Sign({ isGhost = false }: { isGhost?: boolean }) {
  return (
    <svg className="future-sign" viewBox="0 0 34 14" aria-hidden="true">
      <path
        d="M1 7h16"
        stroke="currentColor"
        strokeWidth="2"
        strokeDasharray={isGhost ? "5 4" : undefined}
        fill="none"
      />
      <path d="M32 7L20 12l3-5-3-5z" stroke="currentColor" strokeWidth="1.5" fill={isGhost ? "none" : "currentColor"} />
    </svg>
  );
}
