// A transition: the way from state to state, with its trigger and its place in the order of asking.
import { EdgeLabelRenderer, type EdgeProps, useInternalNode } from "@xyflow/react";
import { memo, useEffect, useRef, useState } from "react";
import {
  detailWords,
  isGhostTransition,
  kFirstGone,
  kindSign,
  kindWord,
  useMark,
  withoutGhost,
} from "../compare/compared.ts";
import { useDifferenceClass } from "../compare/sign.tsx";
import { BreakDot, useBreaks } from "../running/break_dot.tsx";
import { useLive } from "../running/use_live.ts";
import { DifferenceKind } from "../session/protocol.ts";
import { useDesigner, usePart, useTrouble } from "../session/use.ts";
import { useCanvas } from "../sight/canvas_store.ts";
import { curveOf, type TransitionEdge, transitionId } from "../states/flow.ts";
import { isNoTrigger, triggerWords } from "../states/trigger_words.ts";

type TransitionData = NonNullable<TransitionEdge["data"]>;

export const TransitionView = memo(function TransitionView({
  source,
  target,
  data,
  selected,
}: EdgeProps<TransitionEdge>) {
  const from = useInternalNode(source);
  const to = useInternalNode(target);
  const differs = useDifferenceClass(data ? transitionId(data.transition) : "");
  const flashes = useFlash(data?.page ?? "", data ? `${transitionId(data.transition)}` : "");
  if (!from || !to || !data) return null;
  const curve = curveOf(data.transition, data.route, rectOf(from), rectOf(to));
  const classes = `transition ${selected ? "selected" : ""} ${flashes ? "flashes" : ""} ${differs}`;
  return (
    <>
      <path
        d={curve.path}
        className={`react-flow__edge-path ${classes}`}
        markerEnd={`url(#${flashes ? "arrow-live" : selected ? "arrow-strong" : "arrow"})`}
        fill="none"
      />
      <path d={curve.path} className="react-flow__edge-interaction" fill="none" stroke="transparent" strokeWidth={18} />
      <EdgeLabelRenderer>
        <TransitionLabel data={data} at={curve.pointAt(data.route.at)} className={classes} />
      </EdgeLabelRenderer>
    </>
  );
});

function TransitionLabel({
  data,
  at,
  className,
}: {
  data: TransitionData;
  at: { x: number; y: number };
  className: string;
}) {
  const designer = useDesigner();
  const { transition, siblings, lines, scale } = data;
  const id = transitionId(transition);
  const breaks = useBreaks(data.page, id);
  const isSelected = usePart((state) => state.selection.includes(id));
  const isAimedAt = useCanvas((state) => state.aimedAt === id);
  const trouble = useTrouble(id);
  const mark = useMark(id);
  const kind = isGhostTransition(transition) ? DifferenceKind.REMOVED : mark?.kind;
  const classes = [
    "transition-label nodrag nopan",
    className,
    isSelected ? "selected" : "",
    isAimedAt ? "aimed-at" : "",
    isNoTrigger(transition.trigger) ? "unset" : trouble,
  ];
  return (
    <button
      type="button"
      className={classes.filter((one) => one !== "").join(" ")}
      style={{ transform: `translate(-50%, -50%) translate(${at.x}px, ${at.y}px) scale(${scale})` }}
      title={
        [triggerWords(transition.trigger), transition.help, ...(mark?.details ?? []).map(detailWords)]
          .filter((one) => one !== "")
          .join("\n\n") || undefined
      }
      data-transition={id}
      aria-label={`${spokenTransition(transition)}${breaks ? ", with a breakpoint" : ""}${kind === undefined ? "" : `, ${kindWord(kind)}`}`}
      aria-pressed={isSelected}
      onClick={(event) => designer.select(event.shiftKey ? [...designer.state.selection, id] : [id])}
      onDoubleClick={() => designer.store.setState({ dialog: "rename", subject: id })}
    >
      <BreakDot page={data.page} id={id} />
      {kind !== undefined && <span className={`difference-sign ${kindWord(kind)}`} data-sign={kindSign(kind)} />}
      {siblings > 1 && <span className="transition-order" data-order={transition.index + 1} aria-hidden="true" />}
      <span className="transition-lines" data-lines={lines.join("\n")} aria-hidden="true" />
      {transition.restarts && <span className="transition-anew" title="Starts the state anew" aria-hidden="true" />}
    </button>
  );
}

/** With all that is written on the label, and in its words. */
function spokenTransition({ index, from, to, trigger, restarts }: TransitionData["transition"]): string {
  const which = index < kFirstGone ? `Transition ${index + 1} of ${from}` : `Transition of ${withoutGhost(from)}`;
  return `${which}: ${spokenTrigger(trigger)}, to ${withoutGhost(to)}${restarts ? ", anew" : ""}`;
}

function spokenTrigger(trigger: string): string {
  if (isNoTrigger(trigger)) return triggerWords(trigger);
  return trigger ? `when ${triggerWords(trigger)}` : "when?";
}

/** True for a moment after the transition was made. */
function useFlash(page: string, live: string): boolean {
  const times = useLive(page, live)?.times ?? 0;
  const before = useRef(times);
  const [flashes, setFlashes] = useState(false);
  useEffect(() => {
    if (times === before.current) return;
    before.current = times;
    setFlashes(true);
    const timer = setTimeout(() => setFlashes(false), 900);
    return () => clearTimeout(timer);
  }, [times]);
  return flashes;
}

function rectOf(node: NonNullable<ReturnType<typeof useInternalNode>>) {
  const { x, y } = node.internals.positionAbsolute;
  return { x, y, width: node.measured.width ?? 0, height: node.measured.height ?? 0 };
}
