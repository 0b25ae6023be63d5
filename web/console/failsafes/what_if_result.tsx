import type { Failsafes_Row, FailsafeTrial } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { useSession } from "../session/session.ts";
import { doing, ending, moments, notMet, verdict } from "./what_if.ts";

export function WhatIfResult({ trial, rows }: { trial: FailsafeTrial; rows: readonly Failsafes_Row[] }) {
  const { ui } = useSession();
  const happens = moments(trial, rows);
  const does = doing(trial, rows);
  const missed = notMet(trial, rows);
  return (
    <div className="what-if-result" role="status">
      <div>
        <p className="what-if-verdict">{verdict(trial, rows)}</p>
        {does !== "" && <p className="small muted">{sentence(does)}</p>}
      </div>
      {happens.length > 0 && (
        <ol className="what-if-moments" aria-label="What happens">
          {happens.map((moment, i) => (
            <li key={`${i} ${moment.time}`}>
              <span className="number muted">{moment.time.toFixed(1)} s</span>
              <span className={moment.acts ? "acts" : ""}>{moment.text}</span>
            </li>
          ))}
        </ol>
      )}
      <p>{ending(trial)}</p>
      {missed.length > 0 && (
        <div className="small muted">
          Not met, and how much of what it takes there was:
          <ul>
            {missed.map((line) => (
              <li key={line}>{line}</li>
            ))}
          </ul>
        </div>
      )}
      <Button tone="link" icon="centre" onPress={() => ui.get("map")?.framing.centreOn({ x: trial.x, y: trial.y })}>
        Show where that is
      </Button>
    </div>
  );
}
