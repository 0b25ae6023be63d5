// A robot's binding: its class, and for each binding point the device that serves it, with the checker's verdict.

import { Choice } from "../../ui/controls/choice.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import type { Robot, Robot_Binding } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { Section } from "./parts.tsx";

const kAbstract = "(abstract)";

export function RobotDetails({ robot, name }: { robot: Robot; name: string }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const chosen = robot.classes.find((one) => one.name === robot.className);
  return (
    <>
      <Section title="Robot class">
        <Choice
          label="Robot class"
          hiddenLabel
          value={robot.className || kAbstract}
          isDisabled={isReadOnly}
          choices={[
            [kAbstract, "Abstract", "Not bound to a body yet"],
            ...robot.classes.map((one) => [one.name, one.name, one.verdict || one.help] as const),
          ]}
          onChange={(value) => {
            const className = value === kAbstract ? "" : value;
            void designer.edit(className ? `bind ${name} to ${className}` : `unbind ${name}`, {
              case: "setClass",
              value: { robot: name, className },
            });
          }}
        />
        {robot.className === "" ? (
          <p className="small muted">Bind it to a class to see which devices serve it.</p>
        ) : (
          <Verdict
            text={chosen?.verdict ?? ""}
            good={
              robot.bindings.some(({ verdict }) => verdict !== "")
                ? "It can serve the robot, once devices are chosen below."
                : "It has all that the robot needs."
            }
          />
        )}
      </Section>
      {robot.bindings.length > 0 && (
        <Section title="Binding points">
          <ul className="inputs">
            {robot.bindings.map((binding) => (
              <Binding key={binding.name} robot={name} binding={binding} isReadOnly={isReadOnly} />
            ))}
          </ul>
        </Section>
      )}
    </>
  );
}

function Binding({ robot, binding, isReadOnly }: { robot: string; binding: Robot_Binding; isReadOnly: boolean }) {
  const designer = useDesigner();
  const fitting = binding.devices.filter((device) => device.verdict === "");
  const only = fitting.length === 1 ? fitting[0] : undefined;
  return (
    <li className="binding" title={binding.help || undefined}>
      <span className="small">
        <b>{binding.name}</b> <span className="muted">{binding.type}</span>
      </span>
      {binding.devices.length > 1 ? (
        <Choice
          label={`Device for ${binding.name}`}
          hiddenLabel
          value={binding.chosen || only?.name || ""}
          isDisabled={isReadOnly}
          choices={binding.devices.map((device) => [
            device.name,
            `${device.name}: ${device.component}`,
            device.verdict || "fits",
          ])}
          onChange={(device) =>
            void designer.edit(`use ${device} for ${binding.name}`, {
              case: "useDevice",
              value: { robot, binding: binding.name, device },
            })
          }
        />
      ) : (
        binding.devices.map((device) => (
          <span key={device.name} className="small">
            {device.name}: {device.component}
          </span>
        ))
      )}
      <Verdict text={binding.verdict} good="served" />
    </li>
  );
}

function Verdict({ text, good }: { text: string; good: string }) {
  return (
    <span className={`verdict ${text === "" ? "good" : "bad"}`}>
      <Icon name={text === "" ? "check" : "warning"} />
      {text || good}
    </span>
  );
}
