// While a node runs its inputs have one field each: what that changes, the robots or the text, is chosen above them.

import { Parameter } from "../../console/selection/parameters_tab.tsx";
import { usePortText } from "../../console/selection/ports_tab.tsx";
import { useSomePorts } from "../../console/selection/use_watched.ts";
import { useMayOrder, usePart as useSessionPart } from "../../console/session/session.ts";
import { type Port as LivePort, Port_Role } from "../../core/protocol.ts";
import type { FieldOf, InputsProps } from "../../designer/session/extensions.ts";
import { lastPart } from "../../designer/session/pages.ts";
import type { Node } from "../../designer/session/protocol.ts";
import { useIsReadOnly } from "../../designer/session/use.ts";
import { Button, Segments } from "../../ui/controls/controls.tsx";
import { isWritten, parameterName, parametersBelow } from "../run/targets.ts";
import { writeBack } from "../run/write_back.ts";
import { InSession } from "./in_session.tsx";
import { useLivePage, useLiveState, usePath } from "./use_live_part.ts";

export function LiveInputs(props: InputsProps) {
  return (
    <InSession>
      <Inputs {...props} />
    </InSession>
  );
}

const kTextOnly: FieldOf = () => undefined;

function Inputs({ node, children }: InputsProps) {
  const live = useLivePage();
  const path = usePath(node.live);
  const roster = useSessionPart("roster");
  const robot = useSessionPart("selection").robots[0] ?? 0;
  const changes = useLiveState((state) => state.changes);
  const ports = roster.portsOf(robot);
  const own = path === "" ? [] : parametersBelow(ports, path).filter((port) => port.role !== Port_Role.OUTPUT);
  useSomePorts(
    "live-parameters",
    own.map((port) => port.path),
  );
  if (own.length === 0) return children(kTextOnly, null);
  const program = roster.robot(robot)?.program;
  const others = roster.robots.filter((one) => one.program === program && one.id !== robot).map(({ id }) => id);
  const chooser = (
    <Segments
      label="What a change changes"
      value={changes}
      choices={[
        ["robots", "The robots, now"],
        ["text", "The text"],
      ]}
      onChange={(next) => live.store.setState({ changes: next })}
    />
  );
  const fieldOf: FieldOf = (port, what) => {
    const wanted = what === "weight" ? `gains[${port.index ?? 0}]` : port.name;
    const found = own.find((one) => lastPart(one.path) === wanted);
    return found && <LiveField port={found} index={ports.indexOf(found)} robots={[robot, ...others]} node={node} />;
  };
  return children(changes === "robots" ? fieldOf : kTextOnly, chooser);
}

interface FieldProps {
  port: LivePort;
  index: number;
  /** The first is the one whose value is shown. */
  robots: readonly number[];
  /** As it is drawn. */
  node: Node;
}

function LiveField({ port, index, robots, node }: FieldProps) {
  const live = useLivePage();
  const mayOrder = useMayOrder();
  const isReadOnly = useIsReadOnly();
  const shown = usePortText(robots[0] ?? 0, index);
  const name = parameterName(port.path);
  const isSame = shown === "" || shown === port.initial || isWritten(node, name, shown, port.unit);
  return (
    <div className="live-parameter">
      <Parameter port={port} index={index} name={name} robots={robots} isDisabled={!mayOrder} />
      {!isReadOnly && !isSame && (
        <Button icon="save" onPress={() => void writeBack(live, port.path, shown)}>
          Write {name} = {shown} to the text
        </Button>
      )}
    </div>
  );
}
