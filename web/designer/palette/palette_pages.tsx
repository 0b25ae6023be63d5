// What is at the left of pages on which no component stands: declarations of a file, what devices may serve, members.
import type { ReactNode } from "react";
import { Icon } from "../../ui/controls/icons.tsx";
import { type Drawing, Drawing_Kind, type Equipment_Point, Node_Shape } from "../session/protocol.ts";
import { useDesigner, useDocument, useIsReadOnly, usePart } from "../session/use.ts";
import { NodeIcon } from "../views/icons.tsx";
import { askDevice } from "./device_chooser.tsx";
import { firstSentence } from "./groups.ts";
import { addMember, memberChoices } from "./societies.ts";

interface LineProps {
  tone: string;
  title: string;
  help: string;
  icon: ReactNode;
  onChoose: () => void;
}

function Line({ tone, title, help, icon, onChoose }: LineProps) {
  const isReadOnly = useIsReadOnly();
  return (
    <li>
      <button type="button" className={`palette-entry tone-${tone}`} disabled={isReadOnly} onClick={onChoose}>
        <span className="node-icon">{icon}</span>
        <span className="palette-names">
          <span>{title}</span>
          <span className="small muted palette-help">{help}</span>
        </span>
      </button>
    </li>
  );
}

function Lines({ title, children, note }: { title: string; children: ReactNode; note?: string }) {
  return (
    <section aria-label={title}>
      <h3 className="palette-group">{title}</h3>
      {note && <p className="small muted palette-note">{note}</p>}
      <ul>{children}</ul>
    </section>
  );
}

const kKinds = [
  ["assemblage", "skill", "Assemblage", "A skill, put together out of behaviors and other skills."],
  ["robot", "body", "Robot", "What one robot does, and which body it has."],
  ["society", "society", "Society", "Robots together: teams of the same, castes of different ones."],
] as const;

const kRarer = [
  ["class", "body", "Class of robots", "A body of your own, with its sensors and actuators."],
  ["operator", "operator", "Operator of societies", "What coordinates the robots of a team or a caste."],
  ["binding", "sense", "Binding point", "What skills ask for without knowing the robot."],
] as const;

/** The page of this kind has a list of its own; null: components stand on it. */
export function palettePage(drawing: Drawing | undefined): ReactNode {
  switch (drawing?.kind ?? Drawing_Kind.FILE) {
    case Drawing_Kind.FILE:
      return <Declarations />;
    case Drawing_Kind.SOCIETY:
      return <Members drawing={drawing!} />;
    case Drawing_Kind.CLASS:
    case Drawing_Kind.OPERATOR:
      return <Points drawing={drawing!} />;
    case Drawing_Kind.BINDING:
      return <p className="empty small">What a binding point gives is set in the details at the right.</p>;
    default:
      return null;
  }
}

function Declarations() {
  const designer = useDesigner();
  const list = (kinds: typeof kKinds | typeof kRarer) =>
    kinds.map(([kind, tone, title, help]) => (
      <Line
        key={kind}
        tone={tone}
        title={title}
        help={help}
        icon={<Icon name="plus" />}
        onChoose={() => designer.store.setState({ dialog: "declaration", subject: kind })}
      />
    ));
  return (
    <div className="palette">
      <Lines title="New in this file">{list(kKinds)}</Lines>
      <Lines title="Bodies and coordination">{list(kRarer)}</Lines>
    </div>
  );
}

/** By how much they are needed. */
function pointGroups(points: readonly Equipment_Point[]): (readonly [string, readonly Equipment_Point[]])[] {
  const isNeeded = (point: Equipment_Point) => !point.isServed && point.askedBy.length > 0;
  return (
    [
      ["Needed, and not served", points.filter(isNeeded)],
      ["Not served yet", points.filter((point) => !point.isServed && !isNeeded(point))],
      ["Served", points.filter(({ isServed }) => isServed)],
    ] as const
  ).filter(([, members]) => members.length > 0);
}

function Points({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const isClass = drawing.kind === Drawing_Kind.CLASS;
  const owner = drawing.page?.path ?? "";
  const groups = pointGroups(drawing.equipment?.points ?? []);
  return (
    <div className="palette">
      <p className="small muted palette-note">
        {isClass
          ? "Choose what a new device serves; then which one."
          : "Choose what the operator serves; then by what."}
      </p>
      {groups.map(([title, points]) => (
        <Lines key={title} title={title}>
          {points.map(({ name, type, help, askedBy }) => (
            <Line
              key={name}
              tone={type === "" ? "body" : "sense"}
              title={name}
              help={[
                firstSentence(help),
                ...(askedBy.length > 0 ? [`For ${askedBy.slice(0, 3).join(", ")}.`] : []),
              ].join(" ")}
              icon={
                <NodeIcon
                  icon={type === "" ? "actuator" : ""}
                  component=""
                  shape={type === "" ? Node_Shape.ACTUATOR : Node_Shape.SENSOR}
                />
              }
              onChoose={() => askDevice(designer, { owner, device: "", binds: name })}
            />
          ))}
        </Lines>
      ))}
    </div>
  );
}

function Members({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const choices = memberChoices(useDocument(), drawing);
  const group = casteOf(
    usePart((state) => state.selection),
    drawing,
  );
  return (
    <div className="palette">
      <Lines
        title={group.length > 0 ? "Add to the caste that is selected" : "Add a member"}
        {...(choices.length === 0 ? { note: "This file has no robots yet." } : {})}
      >
        {choices.map(({ name, kind }) => (
          <Line
            key={name}
            tone={kind === "robot" ? "body" : "society"}
            title={name}
            help={kind === "robot" ? "A robot; how many of it is set at the right." : "A society of this file."}
            icon={<NodeIcon icon={kind} component="" shape={Node_Shape.ROBOT} />}
            onChoose={() => void addMember(designer, drawing, group, name)}
          />
        ))}
      </Lines>
      <Lines title="New in this file">
        {kKinds.slice(1).map(([kind, tone, title, help]) => (
          <Line
            key={kind}
            tone={tone}
            title={`${title}…`}
            help={help}
            icon={<Icon name="plus" />}
            onChoose={() => designer.store.setState({ dialog: "declaration", subject: kind })}
          />
        ))}
      </Lines>
    </div>
  );
}

/** Of the caste that is selected; empty: the society itself. */
function casteOf([name, ...more]: readonly string[], drawing: Drawing): readonly number[] {
  const node = more.length === 0 ? drawing.nodes.find((one) => one.name === name) : undefined;
  return node?.shape === Node_Shape.CASTE ? node.member : [];
}
