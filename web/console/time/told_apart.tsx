// What was told in one of two futures alone: refused orders, failures, lost robots, and all else that people are told.
import { toldApart } from "../../core/other_future.ts";
import type { Log_Entry, OtherFuture } from "../../core/protocol.ts";
import { momentText } from "../../core/run_time.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { useSession } from "../session/session.ts";
import { useTravel } from "./use_travel.ts";

const kMostWarned = 6;
const kMostRows = 200;

/** What went wrong in the other future and not in the run: in sight at once. */
export function WarnedThere({ future }: { future: OtherFuture }) {
  const warned = future.toldOther.filter(({ isAlert }) => isAlert);
  if (warned.length === 0) return null;
  return (
    <ul className="future-warned" aria-label={future.isRecording ? `Went wrong in ${future.name}` : "Went wrong there"}>
      {warned.slice(0, kMostWarned).map((entry) => (
        <li key={String(entry.number)}>
          <Icon name="warning" /> <Moment entry={entry} /> {sentence(entry.text)}
        </li>
      ))}
      {warned.length > kMostWarned && <li className="small muted">and {warned.length - kMostWarned} more, below</li>}
    </ul>
  );
}

export function ToldApart({ future }: { future: OtherFuture }) {
  const { model } = useSession();
  const all = toldApart(future);
  if (all.length === 0) return null;
  const names = { own: model.isRecording() ? "The recording" : "The run", other: future.name };
  const [known, beyond] = [future.own?.time ?? Number.POSITIVE_INFINITY, future.other?.time ?? 0];
  const leftOut = Math.max(0, all.length - kMostRows) + Number(future.toldLeftOut);
  return (
    <>
      <table className="state-table future-told">
        <caption>What was told in one of them alone</caption>
        <thead>
          <tr>
            <th scope="col">At</th>
            <th scope="col">In</th>
            <th scope="col">What</th>
          </tr>
        </thead>
        <tbody>
          {all.slice(0, kMostRows).map(({ side, entry }) => (
            <tr key={`${side} ${entry.number}`} className={entry.isAlert ? "alert" : ""}>
              <td className="number">
                <Moment entry={entry} />
              </td>
              <td>{names[side]}</td>
              <td>{sentence(entry.text)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {all.some(({ side, entry }) => side === "other" && entry.time > known) && beyond > known && (
        <p className="small muted">
          {names.own} is known to {momentText(known)} only: what was told there later has nothing beside it.
        </p>
      )}
      {leftOut > 0 && <p className="small muted">and {leftOut} more</p>}
    </>
  );
}

function Moment({ entry }: { entry: Log_Entry }) {
  const travel = useTravel();
  return (
    <Button tone="link" onPress={() => travel.does.go(entry.time)}>
      {momentText(entry.time)}
    </Button>
  );
}
