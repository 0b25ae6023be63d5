// Asked once before a run is given up.
import { Control_Action } from "../../core/protocol.ts";
import { Confirm } from "../../ui/controls/confirm.tsx";
import { control } from "../session/orders.ts";
import { useMayOrder, useSession, useUi } from "../session/session.ts";

const kTexts = {
  abort: {
    title: "Abort the mission?",
    text: "All robots stop, and the mission ends. It can be begun anew then.",
    action: Control_Action.ABORT,
    word: "Abort",
  },
  restart: {
    title: "Restart the run?",
    text: "This run is given up: its robots leave the map, its trails and alerts go, and time begins at 0.",
    action: Control_Action.RESTART,
    word: "Restart",
  },
} as const;

export function ConfirmDialog() {
  const session = useSession();
  const name = useUi("dialog");
  const mayOrder = useMayOrder();
  if (name !== "abort" && name !== "restart") return null;
  const { title, text, action, word } = kTexts[name];
  return (
    <Confirm
      title={title}
      width={420}
      no="Go on as it is"
      yes={word}
      isDisabled={!mayOrder}
      onYes={() => control(session, action)}
      onClose={() => session.ui.set("dialog", "")}
    >
      <p>{text}</p>
    </Confirm>
  );
}
