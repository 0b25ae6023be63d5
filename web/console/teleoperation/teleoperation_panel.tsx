// A card with a stick for each unit that is steered by hand, and the way to begin with another one.
import { useEffect, useMemo, useState } from "react";
import { idRanges } from "../../core/format.ts";
import type { RobotDetail, Status_Teleoperation } from "../../core/protocol.ts";
import { count } from "../../ui/words/format.ts";
import { usePart, useSession, useWhyNoOrder } from "../session/session.ts";
import { bearingText, distanceText, meanPose, objectiveFrom } from "./objective.ts";
import { StickPad } from "./stick_pad.tsx";
import "./teleoperation.css";
import { useStickSources, useSticks } from "./use_sticks.ts";

const kNoTeleoperations: readonly Status_Teleoperation[] = [];
const kMostDetails = 8; // robots of a unit that are looked at for where it is

export function TeleoperationPanel() {
  const { connection } = useSession();
  const steered = usePart("status")?.teleoperations ?? kNoTeleoperations;
  usePart("clients");
  const why = useWhyNoOrder("steer");
  const isOperator = why === undefined;
  useStickSources(isOperator ? steered.map((each) => each.unit) : []);
  const watched = useMemo(() => steered.flatMap((each) => each.robots.slice(0, kMostDetails)), [steered]);
  const key = watched.join(" ");
  useEffect(() => {
    const details = key === "" ? [] : key.split(" ").map(Number);
    connection.watching.wish("teleoperation", details.length > 0 ? { details } : null);
    return () => connection.watching.wish("teleoperation", null);
  }, [connection, key]);

  return (
    <div className="teleoperation">
      {!isOperator && steered.length > 0 && <p className="teleoperation-note">{why}</p>}
      {steered.map((each) => (
        <StickCard key={each.unit} teleoperation={each} isOperator={isOperator} />
      ))}
      <Begin isOperator={isOperator} steered={steered} />
    </div>
  );
}

function StickCard({ teleoperation, isOperator }: { teleoperation: Status_Teleoperation; isOperator: boolean }) {
  const { model, connection } = useSession();
  const sticks = useSticks();
  const details = usePart("details");
  usePart("time");
  const { unit, robots } = teleoperation;
  const { stick, heldBy, robotFrame } = sticks.state(unit);
  const known = robots.map((id) => details.get(id)).filter((d): d is RobotDetail => d !== undefined);
  const here = meanPose(robots.map((id) => model.placeOf(id)).filter((p) => p !== undefined));
  const goal = known.find((d) => d.goal)?.goal;
  const objective = here && goal ? objectiveFrom(here, goal, here.heading, robotFrame) : null;
  const speed = known.length > 0 ? known.reduce((sum, d) => sum + d.speed, 0) / known.length : null;
  const isActive = sticks.active === unit;
  const strength = Math.round(Math.hypot(stick.x, stick.y) * 100);

  return (
    <section className="teleoperation-card" aria-label={`Teleoperation of ${unit}`} data-active={isActive || undefined}>
      <header>
        <h3>{unit}</h3>
        <span className="teleoperation-who">
          {count(robots.length, "robot")}
          {robots.length > 0 && `: ${idRanges(robots)}`}
        </span>
      </header>
      <div className="teleoperation-body">
        <StickPad
          unit={unit}
          stick={stick}
          isHeld={heldBy !== null}
          robotFrame={robotFrame}
          needle={objective?.needle ?? null}
          isDisabled={!isOperator}
          onMove={(to) => sticks.point(unit, to)}
          onRelease={() => sticks.releasePointer(unit)}
          onFocus={() => sticks.activate(unit)}
          onBlur={() => sticks.releaseKeys()}
        />
        <dl className="teleoperation-facts">
          <dt>Objective</dt>
          <dd>
            {objective
              ? `${distanceText(objective.distance)}, ${bearingText(objective.bearing)} ${objective.wind}`
              : "none"}
          </dd>
          <dt>Speed</dt>
          <dd>{speed === null ? "–" : `${speed.toFixed(1)} m/s`}</dd>
          <dt>State</dt>
          <dd>{stateText(known)}</dd>
          <dt>Stick</dt>
          <dd aria-live="off">{heldBy === null ? "let go: stands" : `${strength} %, ${kSourceText[heldBy]}`}</dd>
        </dl>
      </div>
      <fieldset className="teleoperation-frame" disabled={!isOperator}>
        <legend>Directions</legend>
        {kFrames.map(([isRobots, label]) => (
          <label key={label}>
            <input
              type="radio"
              name={`frame of ${unit}`}
              checked={robotFrame === isRobots}
              onChange={() => sticks.setRobotFrame(unit, isRobots)}
            />
            {label}
          </label>
        ))}
      </fieldset>
      <p className="teleoperation-keys">
        {isActive ? "Keys and gamepad steer this unit." : "Click the stick to give it the keys and the gamepad."}
      </p>
      <button
        type="button"
        className="button"
        disabled={!isOperator}
        onClick={() => connection.tell({ case: "endTeleoperation", value: { unit } })}
      >
        End teleoperation
      </button>
    </section>
  );
}

const kFrames: readonly [boolean, string][] = [
  [true, "as the robot sees it"],
  [false, "as on the map"],
];

const kSourceText = { pointer: "by pointer", keys: "by keys", gamepad: "by gamepad" } as const;

/** What the robots do, in a word; all of them where they differ. */
function stateText(robots: readonly RobotDetail[]): string {
  const states = [...new Set(robots.map((d) => d.task || d.life).filter((s) => s !== ""))];
  return states.length > 0 ? states.join(", ").toLowerCase() : "–";
}

function Begin({ isOperator, steered }: { isOperator: boolean; steered: readonly Status_Teleoperation[] }) {
  const { model, connection } = useSession();
  const selection = usePart("selection");
  const roster = usePart("roster");
  const [error, setError] = useState("");
  const robot = selection.robots[0];
  const choices: { label: string; unit: string; robot: number }[] = [];
  const add = (unit: string) => {
    if (unit === "" || steered.some((each) => each.unit === unit) || choices.some((c) => c.unit === unit)) return;
    choices.push({ label: unit, unit, robot: 0 });
  };
  if (selection.unit !== "") add(selection.unit);
  else if (robot !== undefined) {
    if (!steered.some((each) => each.robots.includes(robot)))
      choices.push({ label: roster.nameOf(robot), unit: "", robot });
    add(roster.robot(robot)?.unit ?? "");
  } else if (steered.length === 0) for (const unit of roster.units.slice(0, 6)) add(unit.name);

  const begin = async (choice: { unit: string; robot: number }) => {
    const value = { unit: choice.unit, robot: choice.robot };
    const reply = await connection.ask({ case: "startTeleoperation", value });
    setError(reply.ok ? "" : reply.error || "That did not work.");
  };

  if (choices.length === 0 && error === "") return steered.length === 0 ? <Explanation /> : null;
  return (
    <section className="teleoperation-begin" aria-label="Begin teleoperation">
      {steered.length === 0 && <Explanation />}
      <div className="teleoperation-choices">
        {choices.map((choice) => (
          <button
            key={`${choice.unit}/${choice.robot}`}
            type="button"
            className="button"
            disabled={!isOperator || model.get("link").state !== "open"}
            onClick={() => begin(choice)}
          >
            Steer {choice.label}
          </button>
        ))}
      </div>
      {error !== "" && (
        <p role="alert" className="teleoperation-error">
          {error}
        </p>
      )}
    </section>
  );
}

function Explanation() {
  return (
    <p className="teleoperation-note">
      Steer a robot, or a whole unit in its formation, by hand. Select it on the map and press “Steer”; a mission does
      it with TELEOPERATE.
    </p>
  );
}
