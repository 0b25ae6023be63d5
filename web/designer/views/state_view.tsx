// A state: its name, what it does in it, marks of start and end.
import { Handle, type NodeProps, Position } from "@xyflow/react";
import { type CSSProperties, Fragment, memo } from "react";
import { Icon } from "../../ui/controls/icons.tsx";
import { withoutGhost } from "../compare/compared.ts";
import { DifferenceSign, useDifferenceClass } from "../compare/sign.tsx";
import { BreakDot } from "../running/break_dot.tsx";
import { useLive } from "../running/use_live.ts";
import { useDesigner, useTrouble } from "../session/use.ts";
import type { StateNode } from "../states/flow.ts";
import { farNameSize, nameParts, stateSize } from "../states/form.ts";

export const StateView = memo(function StateView({ data, selected }: NodeProps<StateNode>) {
  const { state, page } = data;
  const designer = useDesigner();
  const isActive = useLive(page, state.live)?.isActive ?? false;
  const trouble = useTrouble(state.name);
  const differs = useDifferenceClass(state.name);
  const classes = [
    "state",
    selected ? "selected" : "",
    isActive ? "active" : "",
    trouble,
    differs,
    state.isFinal ? "final" : "",
  ];
  const size = stateSize(state);
  const farSize = farNameSize({ name: state.name, width: size.width });
  return (
    <div className={classes.join(" ")} style={size} title={state.help || undefined}>
      <Handle id="in" type="target" position={Position.Left} className="state-in" isConnectableStart={false} />
      {state.isStart && (
        <svg className="state-start" viewBox="0 0 34 20" aria-hidden="true">
          <circle cx="6" cy="10" r="5" />
          <path d="M11 10h20M26 5l6 5-6 5" />
        </svg>
      )}
      <BreakDot page={page} id={state.name} />
      <DifferenceSign name={state.name} inner={state.inner?.path} />
      <span className="state-name ellipsis" style={{ "--far-size": `${farSize}px` } as CSSProperties}>
        {nameParts(withoutGhost(state.name)).map((part, i) => (
          <Fragment key={`${i} ${part}`}>
            {i > 0 && <wbr />}
            {part}
          </Fragment>
        ))}
      </span>
      <span className="state-does ellipsis">{state.title || state.member}</span>
      {state.isFinal && <span className="state-mark">end</span>}
      {state.inner && (
        <button
          type="button"
          className="node-enter nodrag"
          tabIndex={-1}
          title={`Look inside of ${state.name}`}
          aria-label={`Look inside of ${state.name}`}
          data-file={(state.calls ?? state.inner).document}
          data-page={(state.calls ?? state.inner).path}
          onClick={(event) => {
            event.stopPropagation();
            designer.navigation.enter(state.calls ?? state.inner!);
          }}
        >
          <Icon name="right" />
        </button>
      )}
      <Handle
        id="out"
        type="source"
        position={Position.Right}
        className="state-out"
        title="Drag to another state: a transition"
        isConnectableEnd={false}
      />
    </div>
  );
});

/** What a screen reader says of a state. */
export function spokenState(state: StateNode["data"]["state"]): string {
  const marks = [state.isStart ? "start state" : "state", state.isFinal ? "final" : ""].filter((mark) => mark !== "");
  return `${state.name}, ${marks.join(", ")}, does ${state.title || state.member || "nothing"}`;
}
