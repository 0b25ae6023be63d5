// The body of a class of robots, its devices, what an operator of societies serves, and binding points, as forms.
import { useEffect, useState } from "react";
import { kSensedTypeNames } from "../../core/value_types.ts";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { drawnAt } from "../names/at.ts";
import { renameNow } from "../names/rename.ts";
import { askDevice } from "../palette/device_chooser.tsx";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import {
  type Drawing,
  Drawing_Kind,
  type Equipment,
  type Equipment_Device,
  type Equipment_Point,
  type FitList_Fit,
  type Node,
  Node_Shape,
} from "../session/protocol.ts";
import { useDesigner, useIsReadOnly, usePart } from "../session/use.ts";
import { InputList } from "./input_list.tsx";
import { Heading, Section, SentField, SentText } from "./parts.tsx";
import { Verdict } from "./verdict.tsx";

/** Of the page of a class or of an operator. */
export function EquipmentDetails({ drawing, equipment }: { drawing: Drawing; equipment: Equipment }) {
  const isClass = drawing.kind === Drawing_Kind.CLASS;
  return (
    <>
      {isClass && <Users robots={equipment.robots} />}
      {drawing.nodes
        .filter((node) => node.shape === Node_Shape.BODY)
        .map((node) => (
          <BodyPart key={node.name} drawing={drawing} node={node} />
        ))}
      <Devices owner={drawing.page?.path ?? ""} equipment={equipment} isClass={isClass} />
    </>
  );
}

function Users({ robots }: { robots: readonly string[] }) {
  const designer = useDesigner();
  if (robots.length === 0)
    return <p className="small muted">No robot of this file is of this class yet. A robot’s details choose it.</p>;
  return (
    <p className="small details-users">
      <span className="muted">Robots of this class:</span>
      {robots.slice(0, 12).map((robot) => (
        <Button key={robot} tone="link" onPress={() => designer.navigation.goTo(designer.state.document, robot)}>
          {robot}
        </Button>
      ))}
      {robots.length > 12 && <span className="muted">and {robots.length - 12} more</span>}
    </p>
  );
}

/** Some numbers of the body. */
export function BodyPart({ drawing, node }: { drawing: Drawing; node: Node }) {
  return (
    <Section title={node.title}>
      <p className="small muted details-about">{node.help}</p>
      <InputList drawing={drawing} node={node} isFlow={false} />
    </Section>
  );
}

interface DevicesProps {
  owner: string;
  equipment: Equipment;
  isClass: boolean;
}

function Devices({ owner, equipment, isClass }: DevicesProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const { devices, points } = equipment;
  const open = points.filter((point) => !point.isServed && point.askedBy.length > 0);
  const title = isClass ? "Devices" : "What it serves";
  return (
    <Section
      title={title}
      tools={
        !isReadOnly && (
          <IconButton
            icon="plus"
            label={isClass ? "Add a device" : "Serve a binding point"}
            onPress={() => askDevice(designer, { owner, device: "", binds: "" })}
          />
        )
      }
    >
      {devices.length === 0 && (
        <p className="small muted">
          {isClass
            ? "None yet. A robot needs a sensor or an actuator for each binding point that its skills ask for."
            : "Nothing yet. What it serves takes the place of its members’ own devices."}
        </p>
      )}
      <ul className="inputs">
        {open.map((point) => (
          <OpenPoint key={point.name} owner={owner} point={point} />
        ))}
        {devices.map((device) => (
          <DeviceLine key={device.name} owner={owner} device={device} isClass={isClass} />
        ))}
      </ul>
    </Section>
  );
}

/** What robots of the class need, and nothing serves. */
function OpenPoint({ owner, point }: { owner: string; point: Equipment_Point }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  return (
    <li className="binding card open">
      <span className="small">
        <b>{point.name}</b> <span className="muted">for {point.askedBy.slice(0, 3).join(", ")}</span>
      </span>
      <Verdict text="nothing serves it" good="" />
      {!isReadOnly && (
        <Button icon="plus" onPress={() => askDevice(designer, { owner, device: "", binds: point.name })}>
          Add a device for {point.name}
        </Button>
      )}
    </li>
  );
}

function DeviceLine({ owner, device, isClass }: { owner: string; device: Equipment_Device; isClass: boolean }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  return (
    <li className="binding card">
      <div className="columns spread" style={{ flexWrap: "nowrap" }}>
        <Button tone="link" className="grow" onPress={() => designer.select([device.name])}>
          <b>{device.name}</b> <span className="muted">{device.component}</span>
        </Button>
        {!isReadOnly && (
          <IconButton
            icon="close"
            label={`Remove ${device.name}`}
            onPress={() => void removeDevice(designer, owner, device.name)}
          />
        )}
      </div>
      <Verdict text={device.verdict} good={isClass ? `serves ${device.binds}` : "in the place of its members’ own"} />
    </li>
  );
}

async function removeDevice(designer: Designer, owner: string, device: string): Promise<void> {
  const answer = await designer.edit(`remove ${device}`, { case: "remove", value: { page: owner, nodes: [device] } });
  if (answer.ok) designer.select([]);
}

/** What is selected on such a page. */
export function EquipmentNodeDetails({ drawing, node }: { drawing: Drawing; node: Node }) {
  const { equipment } = drawing;
  if (node.shape === Node_Shape.BODY)
    return (
      <div className="details">
        <BodyPart drawing={drawing} node={node} />
      </div>
    );
  const device = equipment?.devices.find((one) => one.name === node.name);
  if (device) return <DeviceDetails drawing={drawing} node={node} device={device} />;
  const point = equipment?.points.find((one) => `$point.${one.name}` === node.name);
  return point ? <PointDetails drawing={drawing} point={point} /> : null;
}

function DeviceDetails({ drawing, node, device }: { drawing: Drawing; node: Node; device: Equipment_Device }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const isClass = drawing.kind === Drawing_Kind.CLASS;
  const ownHelp = useOwnHelp(node);
  return (
    <div className="details">
      <Heading
        name={device.name}
        kind={node.shape === Node_Shape.ACTUATOR ? "actuator" : isClass ? "sensor" : "served by the operator"}
        help={node.help}
      />
      <Verdict text={device.verdict} good={`serves ${device.binds}`} />
      {isClass && (
        <SentField
          label="Name"
          value={device.name}
          send={(name) => void renameDevice(designer, page, device.name, name)}
        />
      )}
      <ServedPoint drawing={drawing} device={device} />
      <div className="field">
        <span className="small muted" id="served-by">
          By
        </span>
        <Button
          icon="search"
          isDisabled={isReadOnly}
          aria-describedby="served-by"
          onPress={() => askDevice(designer, { owner: page, device: device.name, binds: device.binds })}
        >
          {device.component}…
        </Button>
      </div>
      {node.inputs.length > 0 && (
        <Section title="Settings">
          <InputList drawing={drawing} node={node} isFlow={false} canExpose={isClass} />
        </Section>
      )}
      <SentText
        label="What it is"
        value={ownHelp}
        rows={2}
        send={(text) => void designer.edit("", { case: "setHelp", value: { page, node: device.name, text } })}
      />
      {!isReadOnly && (
        <div>
          <Button icon="close" onPress={() => void removeDevice(designer, page, device.name)}>
            Remove {device.name}
          </Button>
        </div>
      )}
    </div>
  );
}

/** What is said of the device itself; the drawing has its component's help where nothing is. */
function useOwnHelp({ component, help }: Node): string {
  const general = usePart((state) =>
    state.palettes[state.document]?.components.find(({ name }) => name === component),
  )?.help;
  return general && help.startsWith(general) ? "" : help;
}

/** It stays selected. */
async function renameDevice(designer: Designer, page: string, device: string, name: string): Promise<void> {
  await renameNow(
    designer,
    drawnAt(designer, device),
    name,
    () => void designer.edit("", { case: "rename", value: { page, node: device, name } }),
  );
  const isThere = () => designer.drawing?.nodes.some((node) => node.name === name) || undefined;
  if (await onceDrawn(designer, isThere)) designer.select([name]);
}

/** With the reason beside each binding point that its component can't serve. */
function ServedPoint({ drawing, device }: { drawing: Drawing; device: Equipment_Device }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const page = drawing.page?.path ?? "";
  const reasons = useReasons(page, device);
  const points = drawing.equipment?.points ?? [];
  return (
    <Choice
      label="Serves"
      value={device.binds}
      isDisabled={isReadOnly}
      choices={points.map(({ name, help }) => {
        const reason = reasons.get(`$point.${name}`);
        return [name, name, reason ? `Does not fit: ${reason}` : help] as const;
      })}
      onChange={(binds) => {
        const reason = reasons.get(`$point.${binds}`);
        if (reason) return designer.tell(`${device.component} can’t serve ${binds}: ${reason}`, "hold");
        void designer.edit(`let ${device.name} serve ${binds}`, {
          case: "setDevice",
          value: { owner: page, device: device.name, binds },
        });
      }}
    />
  );
}

function useReasons(page: string, device: Equipment_Device): ReadonlyMap<string, string> {
  const designer = useDesigner();
  const { name, component } = device;
  const [fits, setFits] = useState<readonly FitList_Fit[]>([]);
  useEffect(() => {
    let isCurrent = true;
    const { document } = designer.state;
    const value = { document, page, fromNode: name, component };
    void designer.link.ask({ case: "fits", value }).then((answer) => {
      if (isCurrent && answer.result.case === "fits") setFits(answer.result.value.fits);
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, page, name, component]);
  return new Map(fits.map((fit) => [fit.node, fit.reason]));
}

function PointDetails({ drawing, point }: { drawing: Drawing; point: Equipment_Point }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const owner = drawing.page?.path ?? "";
  const devices = drawing.equipment?.devices.filter(({ binds }) => binds === point.name) ?? [];
  return (
    <div className="details">
      <Heading
        name={point.name}
        kind={point.type === "" ? "binding point of actuators" : `binding point, gives ${point.type}`}
        help={point.help}
      />
      <Verdict
        text={devices.length === 0 ? "nothing serves it" : ""}
        good={`served by ${devices.map(({ name }) => name).join(", ")}`}
      />
      {point.askedBy.length > 0 && <p className="small muted">{point.askedBy.join(", ")} asks for it.</p>}
      {!isReadOnly && (
        <div>
          <Button icon="plus" onPress={() => askDevice(designer, { owner, device: "", binds: point.name })}>
            Add a device for it
          </Button>
        </div>
      )}
    </div>
  );
}

/** Of the page of a binding point. */
export function BindingDetails({ drawing, equipment }: { drawing: Drawing; equipment: Equipment }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const name = drawing.page?.path ?? "";
  const type = equipment.points[0]?.type ?? "";
  const kNothing = "$nothing";
  const types = kSensedTypeNames.includes(type) || type === "" ? kSensedTypeNames : [type, ...kSensedTypeNames];
  return (
    <>
      <Choice
        label="Gives"
        value={type || kNothing}
        isDisabled={isReadOnly}
        choices={[
          [kNothing, "nothing: an actuator serves it", "Its first parameter is what the actuator is driven by"],
          ...types.map((one) => [one, one] as const),
        ]}
        onChange={(next) =>
          void designer.edit(`change what ${name} gives`, {
            case: "setBinding",
            value: { binding: name, type: next === kNothing ? "" : next },
          })
        }
      />
      <Section title="Served by">
        {equipment.devices.length === 0 && (
          <p className="small muted">No class of robots has a device for it yet, and no operator serves it.</p>
        )}
        <ul className="inputs">
          {equipment.devices.map((device) => (
            <li key={`${device.owner} ${device.name}`} className="binding">
              <span className="small">
                <b>{device.owner}</b> <span className="muted">{`${device.name}: ${device.component}`}</span>
              </span>
              <Verdict text={device.verdict} good="fits" />
            </li>
          ))}
        </ul>
      </Section>
      <Section title="Asked for by">
        <p className="small">
          {equipment.robots.length === 0 ? (
            <span className="muted">No robot of this file.</span>
          ) : (
            equipment.robots.join(", ")
          )}
        </p>
      </Section>
    </>
  );
}
