import { FailsafeStandings_State, type Failsafes_Row } from "../../core/protocol.ts";
import { Bar, Button } from "../../ui/controls/controls.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart, useSession } from "../session/session.ts";
import { doesText, operandOf, standingText, stateWord, thresholdText, type Worst, worstOf } from "./standings.ts";

const kBars: Record<string, string> = { hold: "var(--hold)", danger: "var(--danger)", go: "var(--go)" };

/** The table, with how each row stands for these robots; without any, as the mission has it. */
export function FailsafeTable({ robots }: { robots: readonly number[] }) {
  const rows = usePart("failsafes");
  const standings = usePart("standings");
  return (
    <ol className="failsafe-rows" aria-label="Failsafes, the highest rank first">
      {rows.map((row, i) => (
        <Row
          key={`${i} ${row.statement}`}
          row={row}
          rank={i + 1}
          worst={worstOf(i, robots, standings)}
          robots={robots}
        />
      ))}
    </ol>
  );
}

interface RowProps {
  row: Failsafes_Row;
  rank: number;
  worst: Worst | undefined;
  robots: readonly number[];
}

function Row({ row, rank, worst, robots }: RowProps) {
  const isOthers = robots.length > 0 && worst === undefined;
  return (
    <li className={`failsafe-row ${isOthers ? "others" : ""}`} data-testid={`failsafe-${rank}`}>
      <span className="failsafe-rank number" title={`Rank ${rank}`}>
        {rank}
      </span>
      <div className="failsafe-body">
        <div className="failsafe-head">
          <p className="failsafe-says">
            <code>
              {row.condition} {operandOf(row)}
            </code>{" "}
            <span className="unbroken">{thresholdText(row)}</span>{" "}
            <span className="unbroken">
              <span aria-hidden="true">→</span> <code>{row.action}</code>
            </span>
          </p>
          {worst && <StatePill worst={worst} />}
        </div>
        {worst && <StandingLine row={row} worst={worst} isOne={robots.length === 1} />}
        {row.robots !== "" && <p className="small muted">of {row.robots} only</p>}
        <Meaning row={row} />
      </div>
    </li>
  );
}

function StatePill({ worst }: { worst: Worst }) {
  const { word, tone } = stateWord(worst.standing.state);
  const isSome = worst.of > 1 && worst.alike < worst.of;
  return (
    <span className={`pill ${tone}`}>
      {word}
      {isSome && ` ${worst.alike} of ${worst.of}`}
    </span>
  );
}

function StandingLine({ row, worst, isOne }: { row: Failsafes_Row; worst: Worst; isOne: boolean }) {
  const roster = usePart("roster");
  const isRealTime = usePart("status")?.realTime !== undefined;
  const { standing, robot } = worst;
  const { tone } = stateWord(standing.state);
  const text = standingText(row, standing, isRealTime);
  return (
    <>
      {text !== "" && (
        <p className="small muted number">
          {isOne || standing.state === FailsafeStandings_State.OFF ? "" : `${roster.nameOf(robot)}: `}
          {text}
        </p>
      )}
      {standing.used > 0 && <Bar share={standing.used / 100} tone={kBars[tone] ?? "var(--line-strong)"} />}
    </>
  );
}

/** What condition and action mean, and where the row stands. */
function Meaning({ row }: { row: Failsafes_Row }) {
  const { ui } = useSession();
  return (
    <details className="failsafe-meaning small">
      <summary>What it means</summary>
      <dl>
        <dt>{row.condition}</dt>
        <dd>{sentence(row.means)}</dd>
        <dt>{row.action}</dt>
        <dd>{sentence(doesText(row))}</dd>
      </dl>
      {row.document !== "" && (
        <Button tone="link" icon="text" onPress={() => ui.set("reveal", { document: row.document, line: row.line })}>
          {row.document}, line {row.line}
        </Button>
      )}
    </details>
  );
}
