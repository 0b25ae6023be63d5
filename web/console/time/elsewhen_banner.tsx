// Says, so that nobody takes it for now, that another moment is shown.
import { useState } from "react";
import { momentText } from "../../core/run_time.ts";
import { Banner } from "../../ui/controls/banner.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { readableMessage } from "../../ui/words/format.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { useIsElsewhen, useIsRecording, useReading } from "../session/session.ts";
import { useTravel, useWhereabouts } from "./use_travel.ts";

/** Not in a recording: it has no now. */
export function ElsewhenBanner() {
  const isElsewhen = useIsElsewhen();
  const isRecording = useIsRecording();
  return isElsewhen && !isRecording ? <Told /> : null;
}

/** What can't be shown of a recording that isn't computed again, and why. */
export function OnlyRecordedBanner() {
  const why = useReading(["timeLine"], (model) => model.get("timeLine")?.onlyRecorded ?? "");
  const [isRead, setRead] = useState(false);
  if (why === "" || isRead) return null;
  return (
    <Banner tone="hold" role="status">
      <Icon name="warning" />
      <span className="grow">
        {sentence(readableMessage(why))} You see what was recorded: where robots were, about once a second, and what was
        told. Not shown: values of ports, states and <i>Why?</i>, plots, and moments found by a condition.
      </span>
      <IconButton icon="close" label="Dismiss" onPress={() => setRead(true)} />
    </Banner>
  );
}

function Told() {
  const travel = useTravel();
  const { time } = useWhereabouts();
  return (
    <Banner tone="past" role="status">
      <Icon name="cycle_back" />
      <span className="grow">
        You are looking at <span className="number">{momentText(time)}</span>. The run is at{" "}
        <span className="number">{momentText(travel.end)}</span> now; nothing can be ordered here.
      </span>
      <Button tone="primary" onPress={() => travel.now()}>
        Now
      </Button>
    </Banner>
  );
}
