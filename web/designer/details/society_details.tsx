// A society: its members, in each other as they are drawn; who they are, how many, who coordinates them.
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { addMember, groupMembers, memberChoices, siblingsOf } from "../palette/societies.ts";
import type { Designer } from "../session/designer.ts";
import { type Drawing, type Node, Node_Shape } from "../session/protocol.ts";
import { useDesigner, useDocument, useIsReadOnly, usePart } from "../session/use.ts";
import { Heading, Section, SentField } from "./parts.tsx";
import { Verdict } from "./verdict.tsx";

/** No operator: as a key of a list, which can't be empty. */
const kNothing = "$nothing";

export function SocietyDetails({ drawing }: { drawing: Drawing }) {
  const isReadOnly = useIsReadOnly();
  const isEmpty = drawing.nodes.length === 1 && drawing.nodes[0]!.shape === Node_Shape.CASTE;
  return (
    <Section title="Members">
      {isEmpty && <Verdict text="It has no members yet: a mission can’t use it." good="" />}
      <ul className="inputs members">
        {drawing.nodes.map((node) => (
          <li key={node.name} className="member card" style={{ marginLeft: Math.min(node.member.length, 5) * 10 }}>
            <Member drawing={drawing} node={node} />
          </li>
        ))}
      </ul>
      {!isReadOnly && <AddMember drawing={drawing} />}
    </Section>
  );
}

/** What is selected on its page. */
export function MemberDetails({ drawing, node }: { drawing: Drawing; node: Node }) {
  return (
    <div className="details">
      <Heading name={titleOf(node)} kind={kindOf(node)} help={node.help} />
      <Member drawing={drawing} node={node} isWhole />
    </div>
  );
}

function AddMember({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const names = memberChoices(useDocument(), drawing);
  return (
    <div className="add-member">
      <h4 className="small muted">Add a member</h4>
      <div className="columns" style={{ gap: 4 }}>
        {names.map(({ name }) => (
          <Button key={name} icon="plus" onPress={() => void addMember(designer, drawing, [], name)}>
            {name}
          </Button>
        ))}
      </div>
      {names.length === 0 && (
        <p className="small muted">
          This file has no robots to be members yet.{" "}
          <Button tone="link" onPress={() => designer.store.setState({ dialog: "declaration", subject: "robot" })}>
            Make a robot…
          </Button>
        </p>
      )}
    </div>
  );
}

interface MemberProps {
  drawing: Drawing;
  node: Node;
  /** It is the only one that is shown: its heading stands above. */
  isWhole?: boolean;
}

function Member({ drawing, node, isWhole = false }: MemberProps) {
  const designer = useDesigner();
  const society = drawing.page?.path ?? "";
  const isCaste = node.shape === Node_Shape.CASTE;
  const by = node.inputs.find((port) => port.name === "by")?.value ?? "";
  const same = { society, path: node.member, name: isCaste ? "" : node.component, count: node.count, by, isCaste };
  const set = async (name: string, change: Partial<typeof same>) =>
    (await designer.edit(name, { case: "setMember", value: { ...same, ...change } })).ok;
  return (
    <>
      {!isWhole && (
        <div className="columns spread" style={{ flexWrap: "nowrap" }}>
          <Button tone="link" className="grow" onPress={() => designer.select([node.name])}>
            <b>{titleOf(node)}</b> <span className="muted">{kindOf(node)}</span>
          </Button>
          <MemberTools drawing={drawing} node={node} />
        </div>
      )}
      {!isCaste && (
        <div className="columns even">
          <Who drawing={drawing} node={node} onChange={(name) => void set(`${name} as a member`, { name })} />
          <SentField
            label="How many"
            value={String(Math.max(1, node.count))}
            send={(typed) => {
              const count = wholeNumber(typed);
              if (count === undefined) {
                designer.tell(`“${typed}” is no number of robots: a whole one from 1 on`, "hold");
                return false;
              }
              return set(`${count} ${node.component}`, { count });
            }}
          />
        </div>
      )}
      <Coordinator by={by} onChange={(next) => void set(`coordinate ${titleOf(node)}`, { by: next })} />
      {isWhole && <MemberTools drawing={drawing} node={node} isWhole />}
    </>
  );
}

function wholeNumber(typed: string): number | undefined {
  return /^\d{1,6}$/.test(typed) && Number(typed) > 0 ? Number(typed) : undefined;
}

function Who({ drawing, node, onChange }: { drawing: Drawing; node: Node; onChange: (name: string) => void }) {
  const isReadOnly = useIsReadOnly();
  const known = memberChoices(useDocument(), drawing);
  const all = known.some(({ name }) => name === node.component)
    ? known
    : [{ name: node.component, kind: node.shape === Node_Shape.UNKNOWN ? "nothing is called that" : "" }, ...known];
  return (
    <Choice
      label="Who"
      value={node.component}
      choices={all.map(({ name, kind }) => [name, name, kind] as const)}
      isDisabled={isReadOnly}
      onChange={onChange}
    />
  );
}

/** Also what stands there and is not known. */
function Coordinator({ by, onChange }: { by: string; onChange: (by: string) => void }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const known = usePart((state) => state.palettes[state.document]?.coordinators) ?? [];
  const isOwn = useDocument()?.declarations.some((one) => one.kind === "operator" && one.name === by) ?? false;
  const coordinators = [...new Set([kNothing, ...known, by || kNothing])];
  return (
    <div className="columns bottom" style={{ flexWrap: "nowrap", gap: 4 }}>
      <div className="grow">
        <Choice
          label="Coordinated by"
          value={by || kNothing}
          choices={coordinators.map((one) => [one, one === kNothing ? "nothing" : one] as const)}
          isDisabled={isReadOnly}
          onChange={(next) => onChange(next === kNothing ? "" : next)}
        />
      </div>
      {isOwn && (
        <IconButton
          icon="right"
          label={`Open ${by}`}
          onPress={() => designer.navigation.goTo(designer.state.document, by)}
        />
      )}
    </div>
  );
}

/** What can be done with a member as a whole: as icons, or in words where it is the only one shown. */
function MemberTools({ drawing, node, isWhole = false }: MemberProps) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  if (isReadOnly) return null;
  const tools = toolsOf(designer, drawing, node);
  return (
    <div className={isWhole ? "columns" : "member-tools"} style={{ gap: isWhole ? 4 : 0 }}>
      {isWhole && node.inner && (
        <Button icon="right" onPress={() => designer.navigation.enter(node.inner!)}>
          Look inside
        </Button>
      )}
      {tools.map(({ icon, label, run }) =>
        isWhole ? (
          <Button key={label} icon={icon} onPress={run}>
            {label}
          </Button>
        ) : (
          <IconButton key={label} icon={icon} label={`${label}: ${titleOf(node)}`} onPress={run} />
        ),
      )}
    </div>
  );
}

interface Tool {
  icon: "up" | "down" | "layers" | "minus" | "close";
  label: string;
  run: () => void;
}

function toolsOf(designer: Designer, drawing: Drawing, node: Node): Tool[] {
  const society = drawing.page?.path ?? "";
  const path = node.member;
  const isCaste = node.shape === Node_Shape.CASTE;
  const [at, into] = [path.at(-1) ?? 0, path.slice(0, -1)];
  const siblings = siblingsOf(drawing, path);
  const move = (index: number) =>
    void designer.edit(`move ${titleOf(node)}`, { case: "moveMember", value: { society, path, into, index } });
  const tools: Tool[] = [];
  if (path.length > 0 && at > 0) tools.push({ icon: "up", label: "Move up", run: () => move(at - 1) });
  if (path.length > 0 && at + 1 < siblings) tools.push({ icon: "down", label: "Move down", run: () => move(at + 2) });
  if (path.length > 0 && !isCaste)
    tools.push({
      icon: "layers",
      label: "Make a caste of it",
      run: () => void groupMembers(designer, drawing, [node.name]),
    });
  if (isCaste && path.length > 0)
    tools.push({
      icon: "minus",
      label: "Take apart",
      run: () =>
        void designer.edit(`take ${titleOf(node)} apart`, { case: "ungroupMembers", value: { society, path } }),
    });
  if (path.length > 0 || !isCaste)
    tools.push({
      icon: "close",
      label: "Remove",
      run: () => void designer.edit(`remove ${titleOf(node)}`, { case: "removeMember", value: { society, path } }),
    });
  return tools;
}

function titleOf(node: Node): string {
  if (node.shape !== Node_Shape.CASTE) return node.title || node.component;
  return node.member.length === 0 ? node.title : `Caste ${node.member.map((at) => at + 1).join(".")}`;
}

function kindOf(node: Node): string {
  if (node.shape === Node_Shape.CASTE) return node.member.length === 0 ? "the whole society" : "together";
  if (node.shape === Node_Shape.TEAM) return `team of ${node.count}`;
  return node.shape === Node_Shape.SOCIETY ? "society" : node.shape === Node_Shape.UNKNOWN ? "unknown" : "robot";
}
