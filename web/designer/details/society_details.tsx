// A society: its members, in each other as they are drawn.

import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { type Drawing, type Node, Node_Shape } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly, usePart } from "../session/use.ts";
import { Section, SentField } from "./parts.tsx";

/** No operator: as a key of a list, which can't be empty. */
const kNothing = "$nothing";

export function SocietyDetails({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const society = drawing.page?.path ?? "";
  const set = (
    name: string,
    value: { path: number[]; name?: string; count?: number; by?: string; isCaste?: boolean },
  ) => designer.edit(name, { case: "setMember", value: { society, ...value } }).then((answer) => answer.ok);
  const robots = useRobots();
  return (
    <Section title="Members">
      <ul className="inputs">
        {drawing.nodes.map((node) => (
          <Member key={node.name} node={node} isReadOnly={isReadOnly} set={set} society={society} />
        ))}
      </ul>
      {!isReadOnly && (
        <div className="columns" style={{ gap: 4, marginTop: 12 }}>
          {robots.map((robot) => (
            <Button
              key={robot}
              icon="plus"
              onPress={() =>
                void set(`add ${robot}`, { path: [Math.max(1, memberCount(drawing))], name: robot, count: 1 })
              }
            >
              {robot}
            </Button>
          ))}
          {robots.length === 0 && <p className="small muted">This file has no robots to be members yet.</p>}
        </div>
      )}
    </Section>
  );
}

interface MemberProps {
  node: Node;
  society: string;
  isReadOnly: boolean;
  set: (
    name: string,
    value: { path: number[]; name?: string; count?: number; by?: string; isCaste?: boolean },
  ) => Promise<boolean>;
}

function Member({ node, society, isReadOnly, set }: MemberProps) {
  const designer = useDesigner();
  const path = node.member;
  const isCaste = node.shape === Node_Shape.CASTE;
  const by = node.inputs.find((port) => port.name === "by")?.value ?? "";
  // Also what stands there and is not known, or has arguments.
  const known = usePart((state) => state.palettes[state.document]?.coordinators) ?? [];
  const coordinators = [...new Set([kNothing, ...known, by || kNothing])];
  const same = { path, name: node.component, count: node.count, by, isCaste };
  return (
    <li className="member">
      <div className="columns spread" style={{ flexWrap: "nowrap" }}>
        <b className="ellipsis">{node.title || node.component || "caste"}</b>
        {!isReadOnly && path.length > 0 && (
          <IconButton
            icon="close"
            label={`Remove ${node.title || node.component}`}
            onPress={() =>
              void designer.edit(`remove ${node.component}`, { case: "removeMember", value: { society, path } })
            }
          />
        )}
      </div>
      {!isCaste && (
        <SentField
          label="How many"
          value={String(Math.max(1, node.count))}
          send={(count) =>
            set(`${count} ${node.component}`, { ...same, count: Math.max(1, Math.round(Number(count)) || 1) })
          }
        />
      )}
      <Choice
        label="Coordinated by"
        value={by || kNothing}
        choices={coordinators.map((one) => [one, one === kNothing ? "nothing" : one] as const)}
        isDisabled={isReadOnly}
        onChange={(next) => void set(`coordinate ${node.component}`, { ...same, by: next === kNothing ? "" : next })}
      />
    </li>
  );
}

function memberCount(drawing: Drawing): number {
  return drawing.nodes.filter((node) => node.member.length === 1).length;
}

function useRobots(): string[] {
  const designer = useDesigner();
  return (designer.document?.declarations ?? [])
    .filter((one) => one.kind === "robot" || one.kind === "society")
    .map((one) => one.name)
    .filter((name) => name !== designer.state.page);
}
