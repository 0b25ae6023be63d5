import { selectRobots } from "../../core/selection.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { distance, duration } from "../../ui/words/format.ts";
import { commandOfUnit } from "../mission/unit_command.ts";
import { faulted } from "../robots/robot_state.ts";
import { usePart, useSession } from "../session/session.ts";
import { groupNumbers } from "./group.ts";
import { ReplaceButton } from "./replace_button.tsx";

/** A unit, or several robots, in short. */
export function GroupFacts({ robots, unit }: { robots: readonly number[]; unit: string }) {
  const { model } = useSession();
  usePart("time");
  const status = usePart("status");
  const roster = usePart("roster");
  const numbers = groupNumbers(model, robots);
  const broken = faulted(model.robots, robots);
  return (
    <div className="rows tab-body">
      <div className="columns">
        {numbers.states.map((state) => (
          <Button
            key={state.word}
            className={`pill ${state.tone}`}
            onPress={() => model.select(selectRobots(state.robots))}
          >
            {state.robots.length} {state.word.toLowerCase()}
          </Button>
        ))}
      </div>
      {broken.length > 0 && <ReplaceButton robots={broken} />}
      <FactList
        rows={[
          ...(unit ? [["Command", commandOfUnit(status, unit) || "none"] as const] : []),
          ["Farthest to go", distance(numbers.farthest)],
          ["Last arrives", numbers.lastArrival >= 0 ? duration(numbers.lastArrival) : "–"],
          ["Mean speed", Number.isNaN(numbers.meanSpeed) ? "–" : `${numbers.meanSpeed.toFixed(2)} m/s`],
          ["Mean off station", distance(numbers.meanStationError)],
          ["Centre", numbers.centre ? `${numbers.centre.x.toFixed(0)}, ${numbers.centre.y.toFixed(0)} m` : "–"],
          ["Spread", numbers.centre ? distance(numbers.spread) : "–"],
        ]}
      />
      <section aria-label="Members">
        <h3>Robots</h3>
        <ul className="columns member-list">
          {robots.slice(0, 60).map((id) => (
            <li key={id}>
              <Button onPress={() => model.select(selectRobots([id]))}>
                <span className="swatch" style={{ background: roster.robot(id)?.color || "gray" }} />
                {id}
              </Button>
            </li>
          ))}
          {robots.length > 60 && <li className="muted">and {robots.length - 60} more</li>}
        </ul>
      </section>
    </div>
  );
}
