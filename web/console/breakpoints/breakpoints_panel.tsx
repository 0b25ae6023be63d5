// Where the run pauses: a breakpoint in words, all that are set, and which of them has stopped it.
import type { Breakpoint } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { order } from "../session/orders.ts";
import { useMayOrder, usePart, useReading, useSession, useWhyNoOrder } from "../session/session.ts";
import { atSentence, hitText } from "./break_points.ts";
import { BreakpointEntry } from "./breakpoint_entry.tsx";
import { SentenceField } from "./sentence_field.tsx";

/** How many have stopped the run that stands now. */
export function useBreakpointsBadge(): number {
  return useReading(["halted"], (model) => model.get("halted")?.hits.length ?? 0);
}

export function BreakpointsPanel() {
  const session = useSession();
  const mayOrder = useMayOrder();
  const whyNot = useWhyNoOrder("set breakpoints");
  const all = usePart("breakpoints");
  const remove = (id: number) => void order(session, { case: "removeBreakpoint", value: { id } });
  const change = (breakpoint: Breakpoint, isOn: boolean) =>
    void order(session, { case: "setBreakpoint", value: { breakpoint: { ...breakpoint, isOff: !isOn } } });
  const set = async (condition: string) => {
    const reply = await session.connection.ask({
      case: "setBreakpoint",
      value: { breakpoint: atSentence(condition) },
    });
    return reply.ok ? "" : reply.error || "the server said no";
  };
  return (
    <div className="rows tab-body">
      <SentenceField isDisabled={!mayOrder} onSet={set} />
      <p className="small muted">{whyNot ?? "The run pauses at the end of the cycle in which it becomes so."}</p>
      <StoppedBy />
      {all.length > 0 && (
        <ul className="break-list" aria-label="Breakpoints that are set">
          {all.map((one) => (
            <BreakpointEntry
              key={one.id}
              breakpoint={one}
              isDisabled={!mayOrder}
              onSwitch={(isOn) => change(one, isOn)}
              onRemove={() => remove(one.id)}
            />
          ))}
        </ul>
      )}
      {all.length > 1 && (
        <Button tone="quiet" isDisabled={!mayOrder} onPress={() => remove(0)}>
          Remove all
        </Button>
      )}
    </div>
  );
}

function StoppedBy() {
  const hits = usePart("halted")?.hits ?? [];
  if (hits.length === 0) return null;
  return (
    <p className="notice hold" role="status">
      {sentence(hitText(hits[0]!))}
      {hits.length > 1 ? ` And ${hits.length - 1} more.` : ""}
    </p>
  );
}
