// One of the list of breakpoints: on, off, away.
import type { Breakpoint } from "../../core/protocol.ts";
import { Button, IconButton, Switch } from "../../ui/controls/controls.tsx";
import { readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart } from "../session/session.ts";
import { breakpointText } from "./break_points.ts";
import "./breakpoints.css";

interface EntryProps {
  breakpoint: Breakpoint;
  /** Of what it was set on, in few words and as a sentence, where that is gone. */
  lost?: readonly [string, string] | undefined;
  isDisabled?: boolean;
  onSwitch: (isOn: boolean) => void;
  onRemove: () => void;
  /** To what it is set on. */
  onGo?: (() => void) | undefined;
}

export function BreakpointEntry({ breakpoint, lost, isDisabled = false, onSwitch, onRemove, onGo }: EntryProps) {
  const halted = usePart("halted");
  const text = breakpointText(breakpoint);
  const isHit = halted?.hits.some((hit) => hit.breakpoint === breakpoint.id) ?? false;
  const hits = Number(breakpoint.hits);
  const [why, more] = lost ?? [sentence(readableMessage(breakpoint.error)), undefined];
  return (
    <li className={isHit ? "hit" : ""}>
      <Switch
        label={<span className="hidden-text">{text}: stops the run</span>}
        value={!breakpoint.isOff}
        isDisabled={isDisabled}
        onChange={onSwitch}
      />
      {onGo ? (
        <Button tone="link" className="ellipsis" onPress={onGo}>
          {text}
        </Button>
      ) : (
        <span className="break-text">{text}</span>
      )}
      <span className="small muted grow">{why === "" && hits > 0 ? `${hits}×` : ""}</span>
      <IconButton icon="close" label={`Remove the breakpoint ${text}`} isDisabled={isDisabled} onPress={onRemove} />
      {why !== "" && (
        <span className="small muted break-why" title={more}>
          {why}
        </span>
      )}
    </li>
  );
}
