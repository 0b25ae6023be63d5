// A robot's binding: its class, and for each binding point the device that serves it, with the checker's verdict.

import { Choice } from "../../ui/controls/choice.tsx";
import { Button } from "../../ui/controls/controls.tsx";
import { askDevice } from "../palette/device_chooser.tsx";
import type { Robot, Robot_Binding } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly, usePart } from "../session/use.ts";
import { Section } from "./parts.tsx";
import { Verdict } from "./verdict.tsx";

const kAbstract = "(abstract)";

export function RobotDetails({ robot, name }: { robot: Robot; name: string }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const chosen = robot.classes.find((one) => one.name === robot.className);
  const openCount = robot.bindings.filter(({ verdict }) => verdict !== "").length;
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
          <p className="small muted details-about">
            Bind it to a class to see which devices serve it, or make a class of your own.
          </p>
        ) : (
          <Verdict
            text={chosen?.verdict ?? ""}
            good={
              openCount > 0
                ? "It can serve the robot, once devices are chosen below."
                : "It has all that the robot needs."
            }
          />
        )}
        <ClassButtons robot={robot} name={name} />
      </Section>
      {robot.bindings.length > 0 && (
        <Section title="Binding points">
          <ul className="inputs">
            {robot.bindings.map((binding) => (
              <Binding key={binding.name} robot={robot} name={name} binding={binding} />
            ))}
          </ul>
        </Section>
      )}
    </>
  );
}

/** To the class itself, to one of one's own. */
function ClassButtons({ robot, name }: { robot: Robot; name: string }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const isOwn = useIsOwnClass(robot);
  const page = robot.classes.find((one) => one.name === robot.className)?.page;
  const copy = async () => {
    const { className } = robot;
    const answer = await designer.edit(`own copy of ${className}`, {
      case: "copyComponent",
      value: { component: className, name: "" },
    });
    if (answer.ok) designer.navigation.goTo(designer.state.document, className);
  };
  return (
    <div className="columns class-buttons">
      {page && (
        <Button icon="right" onPress={() => designer.navigation.goTo(page.document, page.path)}>
          Body and devices
        </Button>
      )}
      {!isReadOnly && robot.className !== "" && page && !isOwn && (
        <Button icon="file" onPress={() => void copy()}>
          Make my own copy
        </Button>
      )}
      {!isReadOnly && (
        <Button
          icon="plus"
          onPress={() => designer.store.setState({ dialog: "declaration", subject: `class ${name}` })}
        >
          New class…
        </Button>
      )}
    </div>
  );
}

/** Whether the robot's class stands in this file, so that it can be changed from here. */
function useIsOwnClass(robot: Robot): boolean {
  const document = usePart((state) => state.document);
  return robot.classes.find((one) => one.name === robot.className)?.page?.document === document;
}

function Binding({ robot, name, binding }: { robot: Robot; name: string; binding: Robot_Binding }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const isOwnClass = useIsOwnClass(robot);
  const fitting = binding.devices.filter((device) => device.verdict === "");
  const only = fitting.length === 1 ? fitting[0] : undefined;
  const isOpen = binding.verdict !== "";
  return (
    <li className={`binding card ${isOpen ? "open" : ""}`} title={binding.help || undefined}>
      <span className="small">
        <b>{binding.name}</b> <span className="muted">{binding.type || "actuator"}</span>
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
              value: { robot: name, binding: binding.name, device },
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
      {isOpen && isOwnClass && !isReadOnly && fitting.length === 0 && (
        <Button
          icon="plus"
          onPress={() => askDevice(designer, { owner: robot.className, device: "", binds: binding.name })}
        >
          Add a device to {robot.className}
        </Button>
      )}
    </li>
  );
}
